// Gusts along a chain, and the sleep after them.

#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::gusts_on_chains_test {

constexpr float kFrame = 1.0f / 60;
constexpr ChainModel kModels[] = {ChainModel::kCascade, ChainModel::kPassive};

const HairDesc kAiry{.solver = &kCharacterSolver, .has_own_air = true, .feels_gusts = true};

/// So short that the bones of one chain are in different parts of them.
Gusts short_gusts() { return {.amplitude = 3, .length = 0.4f, .speed = 2, .direction = {0, 0, -1}, .seed = 7}; }

/// Bones of 20 cm that feel no air, end to end, and one that does at their end.
TestRig mast(ChainModel model, int bare) {
  TestRig rig;
  rig.model = model;
  const TestBone bone{
      .joint = {0.05f, 0.1f, -0.1f}, .rest_direction = {0, 0, -1}, .length = 0.2f, .stiffness = 200, .damping = 20};
  TestBone last{.parent = rig.add_strand(bare, bone), .length = 0.1f, .friction = 30, .stiffness = 100};
  rig.add(last);
  return rig;
}

/// The last bone in gusts, and in a wind that is told in every step as the field has it where that bone starts.
TEST(GustsOnChains, EachBoneFeelsThemWhereItStarts) {
  for (const ChainModel model : kModels) {
    for (const int bare : {1, 2, 3}) {
      const TestRig rig = mast(model, bare);
      TestHair felt(rig, kAiry), told(rig, kAiry);
      StepSettings settings{.substeps = 1}, calm = settings;
      settings.environment.gravity = calm.environment.gravity = {60, 0, 0};  // far from where they rest
      for (int frame = 0; frame < 300; ++frame) {
        for (TestHair* const each : {&felt, &told}) ASSERT_EQ(each->hair.step(calm), Status::kOk);
      }
      const auto bent = felt.ends();
      ASSERT_GT(largest_distance(bent, rig.rest_ends()), 0.03f);
      ASSERT_EQ(felt.hair.set_gusts(short_gusts()), Status::kOk);
      float most = 0;
      for (int frame = 0; frame < 60; ++frame) {
        const Vec3 start = felt.ends()[std::size_t(bare) - 1];
        const double place[3] = {double(start.x), double(start.y), double(start.z)};
        const double way = felt.hair.gusts_way() + double(short_gusts().speed * 0.5f * kFrame);
        ASSERT_EQ(felt.hair.step(calm), Status::kOk);
        settings.environment.wind = gust_at(short_gusts(), way, place);
        ASSERT_EQ(told.hair.step(settings), Status::kOk);
        EXPECT_LT(largest_distance(felt.ends(), told.ends()), 1e-4f) << bare << ' ' << frame;
        most = std::max(most, largest_distance(felt.ends(), bent));
      }
      EXPECT_GT(most, 0.02f) << "it is blown about";
    }
  }
}

/// The rest that sleep needs begins when the gusts have ended.
TEST(GustsOnChains, LetHairSleepAsLongAfterThemAsItHasToRest) {
  for (const ChainModel model : kModels) {
    TestHair test(mast(model, 1), kAiry);
    Gusts faint = short_gusts();
    faint.amplitude = 1e-6f;
    ASSERT_EQ(test.hair.set_gusts(faint), Status::kOk);
    const StepSettings settings{.dt = kFrame, .substeps = 1, .sleep_after = 10.9f * kFrame};
    for (int frame = 0; frame < 600; ++frame) ASSERT_EQ(test.hair.step(settings), Status::kOk);
    ASSERT_FALSE(test.hair.is_asleep(0));
    faint.amplitude = 0;
    ASSERT_EQ(test.hair.set_gusts(faint), Status::kOk);
    int frames = 0;
    for (; frames < 100 && !test.hair.is_asleep(0); ++frames) ASSERT_EQ(test.hair.step(settings), Status::kOk);
    EXPECT_GE(frames, 11) << "not before it has rested for so long";
    EXPECT_LE(frames, 12) << "and a frame later at most";
  }
}

}  // namespace coif::gusts_on_chains_test
