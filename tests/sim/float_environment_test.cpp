// What a host's threads have chosen for floating point is theirs, and does not matter to hair.

#include "models/playback.h"
#include "sim/hair_town.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace coif::float_environment_test {

/// Ends of bones over a game whose poses have been computed before `choose` chose something for this thread.
std::vector<std::vector<Vec3>> ends_under(const std::function<void()>& choose, InstructionSet set) {
  TestRig rig = feature_rig();
  std::vector<HeadPose> poses;
  for (int frame = 0; frame < 120; ++frame) poses.push_back(wander(frame / 60.0));
  std::vector<std::vector<Vec3>> ends;
  std::fenv_t usual;
  EXPECT_EQ(std::fegetenv(&usual), 0);
  {
    TestHair test(rig, HairDesc{.instances = 3, .instruction_set = set});
    choose();
    EXPECT_EQ(test.hair.reset(1, poses[0]), Status::kOk);
    for (std::size_t frame = 0; frame < poses.size(); ++frame) {
      for (std::uint32_t i = 0; i < 3; ++i)
        EXPECT_EQ(test.hair.set_head(i, poses[(frame + 40 * i) % 120]), Status::kOk);
      EXPECT_EQ(test.hair.set_detail(2, {.level = std::uint32_t(frame / 9 % 2), .simulated = frame % 30 > 3}),
                Status::kOk);
      EXPECT_EQ(test.hair.step({.substeps = 1 + std::uint32_t(frame / 50), .inertia = frame < 80 ? 1.0f : 0.5f}),
                Status::kOk);
      ends.push_back(test.ends(1));
      ends.push_back(test.ends(2));
    }
  }
  EXPECT_EQ(std::fesetenv(&usual), 0);
  return ends;
}

void expect_equal(const std::vector<std::vector<Vec3>>& a, const std::vector<std::vector<Vec3>>& b, const char* what) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(largest_distance(a[i], b[i]), 0.0f) << what << ", " << i;
}

TEST(FloatEnvironment, TheThreadsRoundingChangesNoBit) {
  for (const InstructionSet set : runnable_sets()) {
    const auto usual = ends_under([] {}, set);
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      expect_equal(ends_under([mode] { EXPECT_EQ(std::fesetround(mode), 0); }, set), usual, name_of(set));
    }
  }
}

TEST(FloatEnvironment, NothingTrapsWhereTheHostLetsExceptionsTrap) {
#if defined(__GLIBC__)
  if (feenableexcept(FE_INVALID) == -1) GTEST_SKIP() << "this processor does not trap";
  (void)fedisableexcept(FE_ALL_EXCEPT);
  for (const InstructionSet set : runnable_sets()) {
    const auto trap = [] { (void)feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW); };
    expect_equal(ends_under(trap, set), ends_under([] {}, set), name_of(set));
  }
#else
  GTEST_SKIP() << "no way to let exceptions trap";
#endif
}

TEST(FloatEnvironment, TheHostsOwnIsBackAfterwards) {
  (void)ends_under(
      [] {
        EXPECT_EQ(std::fesetround(FE_UPWARD), 0);
        (void)std::feclearexcept(FE_ALL_EXCEPT);
        TestHair test(feature_rig());
        for (int i = 0; i < 60; ++i) {
          EXPECT_EQ(test.hair.set_head(0, wander(0.1 * i)), Status::kOk);
          (void)std::feclearexcept(FE_ALL_EXCEPT);
          EXPECT_EQ(test.hair.step({.dt = 0.1f}), Status::kOk);
          EXPECT_EQ(std::fetestexcept(FE_ALL_EXCEPT & ~FE_INEXACT), 0) << "what is computed leaves no flags";
        }
        EXPECT_EQ(std::fegetround(), FE_UPWARD);
      },
      InstructionSet::kBest);
}

/// Matrices of heads whose chains take other lanes in calls that compute nothing else, after `choose` chose something
/// for this thread.
std::vector<Mat34> matrices_under(const std::function<void()>& choose) {
  const auto kinds = hair_town::opened(
      {hair_town::uneven_strands(ChainModel::kPassive, 4, kShortestArc, true).contents(), feature_rig().contents()});
  const WorldDesc desc{.assets = 2, .heads = 6, .dynamics_sets = 2};
  AlignedBytes memory = hair_town::memory_of(HairWorld::memory_need(desc).bytes);
  HairWorld world;
  EXPECT_EQ(world.create(desc, memory.bytes()), Status::kOk);
  std::vector<WorldHead> heads(desc.heads);
  WorldAsset assets[2];
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(world.add_asset(kinds[i]->asset, assets[i]), Status::kOk);
  for (std::size_t i = 0; i < heads.size(); ++i) {
    EXPECT_EQ(world.add_head(assets[i % 2], {}, heads[i]), Status::kOk);
    EXPECT_EQ(world.set_detail(heads[i], {.simulated = false}), Status::kOk);
  }
  std::fenv_t usual;
  EXPECT_EQ(std::fegetenv(&usual), 0);
  choose();
  for (const WorldHead head : heads) EXPECT_EQ(world.set_detail(head, {}), Status::kOk);
  for (const WorldHead head : heads) EXPECT_EQ(world.choose_dynamics(head, 1), Status::kOk);
  for (int frame = 0; frame < 30; ++frame) EXPECT_EQ(world.step({}), Status::kOk);
  EXPECT_EQ(std::fesetenv(&usual), 0);
  std::vector<Mat34> matrices;
  for (const WorldHead head : heads) {
    matrices.insert(matrices.end(), world.palette(head).begin(), world.palette(head).end());
  }
  return matrices;
}

TEST(FloatEnvironment, ChainsTakeOtherLanesWithTheSameBits) {
  const std::vector<Mat34> usual = matrices_under([] {});
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const std::vector<Mat34> here = matrices_under([mode] { EXPECT_EQ(std::fesetround(mode), 0); });
    EXPECT_EQ(std::memcmp(usual.data(), here.data(), usual.size() * sizeof(Mat34)), 0) << mode;
  }
}

TEST(FloatEnvironment, NumbersThatAreNoneAreRefusedWithoutATrap) {
#if defined(__GLIBC__)
  if (feenableexcept(FE_INVALID) == -1) GTEST_SKIP() << "this processor does not trap";
  (void)fedisableexcept(FE_ALL_EXCEPT);
  const float none = std::numeric_limits<float>::quiet_NaN();
  TestHair test(nine_bone_rig(),
                {.solver = &kCharacterSolver, .dynamics_sets = 2, .has_own_air = true, .feels_gusts = true});
  (void)feenableexcept(FE_INVALID);
  EXPECT_EQ(test.hair.step({.dt = none}), Status::kBadTimeStep);
  EXPECT_EQ(test.hair.settle(0, none, {}), Status::kBadTimeStep);
  EXPECT_EQ(test.hair.set_dynamics(1, {.damping = none}), Status::kBadArgument);
  EXPECT_EQ(test.hair.set_air(0, {.exposure = none}), Status::kBadArgument);
  EXPECT_EQ(test.hair.set_gusts({.length = none}), Status::kBadArgument);
  (void)fedisableexcept(FE_ALL_EXCEPT);
#else
  GTEST_SKIP() << "no way to let exceptions trap";
#endif
}

}  // namespace coif::float_environment_test
