// Sentences about values that are refused: explain().

#include "models/small_asset.h"
#include "models/test_rig.h"

#include <coif/explain.h>
#include <coif/links.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace coif::explain_test {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

template <typename Value>
std::string said_of(const Value& value) {
  char text[200] = "before";
  const std::size_t length = explain(value, text);
  EXPECT_EQ(length, std::string(text).size());
  return text;
}

TEST(Explain, NamesTheMemberItsValueAndItsBound) {
  EXPECT_EQ(said_of(StepSettings{.inertia = 1.5f}), "StepSettings: inertia is 1.5, above 1");
  EXPECT_EQ(said_of(StepSettings{.dt = -0.25f}), "StepSettings: dt is -0.25, below 0");
  EXPECT_EQ(said_of(StepSettings{.dt = kNaN}), "StepSettings: dt is not a number");
  EXPECT_EQ(said_of(StepSettings{.dt = kInfinity}), "StepSettings: dt is infinite, above 3.40282e38");
  EXPECT_EQ(said_of(StepSettings{.substeps = 65}), "StepSettings: substeps is 65, above 64");
  EXPECT_EQ(said_of(StepSettings{.environment = {.wind = {0, kNaN, 0}}}),
            "StepSettings: environment.wind is not finite");
  EXPECT_EQ(said_of(HairDesc{.instances = 0}), "HairDesc: instances is 0, below 1");
  EXPECT_EQ(said_of(WorldDesc{.heads = 2'000'000}), "WorldDesc: heads is 2000000, above 1000000");
  EXPECT_EQ(said_of(HairDesc{.longest_interval = 3}), "HairDesc: longest_interval is neither 1, 2 nor 4");
  EXPECT_EQ(said_of(DynamicsScale{.damping = 2e6f}), "DynamicsScale: damping is 2000000, above 1000000");
  EXPECT_EQ(said_of(Gusts{.length = 0.001f}), "Gusts: length is 0.001, below 0.05");
  EXPECT_EQ(said_of(Gusts{.length = 1.25e-5f}), "Gusts: length is 1.25e-5, below 0.05");
  EXPECT_EQ(said_of(Gusts{.direction = {}}), "Gusts: direction has no length");
  EXPECT_EQ(said_of(HeadAir{.exposure = 2}), "HeadAir: exposure is 2, above 1");
  EXPECT_EQ(said_of(Impulse{.radius = 0}), "Impulse: radius is not above 0");
  EXPECT_EQ(said_of(MovingCollider{.radius = -1}), "MovingCollider: radius is -1, below 0");
  EXPECT_EQ(said_of(HeadPose{.scale = 0}), "HeadPose: scale, one metre of the hair in world metres, is 0, below 0.05");
  EXPECT_EQ(said_of(HeadPose{.rotation = {0, 0, 0, 2}}),
            "HeadPose: length of rotation, which has to be a unit quaternion, is 2, above 1.001");
}

TEST(Explain, TellsFeaturesAndSolversThatDoNotBelongTogether) {
  EXPECT_EQ(said_of(HairDesc{.moving_colliders = 2}),
            "HairDesc: moving_colliders needs a solver for characters, as kCharacterSolver");
  EXPECT_EQ(said_of(HairDesc{.solver = &kCharacterSolver, .links = &kLinks}),
            "HairDesc: links is kLinks, but the solver is for characters: name kCharacterLinks");
  EXPECT_EQ(said_of(WorldDesc{.links = &kCharacterLinks}),
            "WorldDesc: links is kCharacterLinks, but the solver is not for characters: name kLinks");
  EXPECT_EQ(said_of(HairDesc{.solver = &kThesisSolver, .links = &kLinks}), "HairDesc: links are not for kThesisSolver");
  EXPECT_EQ(said_of(HairDesc{.solver = nullptr}), "HairDesc: solver is null");
  char text[64];
  (void)explain(Asset(), HairDesc{}, text);
  EXPECT_STREQ(text, "Asset: it is not open; open() says why");
}

TEST(Explain, HasNothingToSayOfWhatIsGood) {
  EXPECT_EQ(said_of(StepSettings{}), "");
  EXPECT_EQ(said_of(published_step(0.01f)), "");
  EXPECT_EQ(said_of(HairDesc{}), "");
  EXPECT_EQ(said_of(WorldDesc{}), "");
  EXPECT_EQ(said_of(HeadPose{}), "");
  EXPECT_EQ(said_of(Gusts{}), "");
  EXPECT_EQ(said_of(Impulse{}), "");
  EXPECT_EQ(said_of(MovingCollider{}), "");
}

/// One cannot say less than the other.
TEST(Explain, SpeaksWhereTheCallRefuses) {
  AlignedBytes file(write_asset(nine_bone_rig().contents()));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  for (const HairDesc& desc : {HairDesc{}, HairDesc{.instances = 0}, HairDesc{.dynamics_sets = 9},
                               HairDesc{.solver = &kCharacterSolver, .moving_colliders = 17},
                               HairDesc{.follows_poses = true}, HairDesc{.links = &kLinks}}) {
    char text[8];
    EXPECT_EQ(explain(asset, desc, text) == 0, Hair::memory_need(asset, desc).bytes != 0);
  }
}

TEST(Explain, CutsWhatDoesNotFit) {
  const StepSettings bad{.inertia = 2};
  const std::string whole = "StepSettings: inertia is 2, above 1";
  for (std::size_t size = 0; size < whole.size() + 3; ++size) {
    std::string text(size + 1, '#');
    EXPECT_EQ(explain(bad, std::span(text.data(), size)), whole.size());
    EXPECT_EQ(text[size], '#') << "behind what was given";
    if (size != 0) EXPECT_EQ(std::string(text.c_str()), whole.substr(0, size - 1));
  }
}

}  // namespace coif::explain_test
