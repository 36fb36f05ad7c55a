// How much of its head's motion hair feels.

#include "sim/playback.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

StepSettings feeling(float inertia, std::uint32_t substeps = 1) {
  StepSettings settings{.substeps = substeps, .inertia = inertia, .teleport_distance = 1e9f, .teleport_angle = 4};
  settings.environment.gravity = {};
  return settings;
}

TestRig rig() {
  TestRig rig = calm_strand(4, 0.3f);
  for (DynamicsRecord& bone : rig.dynamics) bone.friction = 1;
  return rig;
}

TEST(Inertia, OfNothingCarriesHairRigidly) {
  for (const Solver* const solver : {&kCoifSolver, &kThesisSolver}) {
    TestHair test(rig(), {.solver = solver});
    StepSettings settings = feeling(0, solver == &kCoifSolver ? 3 : 1);
    Violence violence(2);
    for (int i = 0; i < 500; ++i) {
      ASSERT_EQ(test.hair.set_head(0, violence.next()), Status::kOk);
      ASSERT_EQ(test.hair.step(settings), Status::kOk);
      ASSERT_LT(largest_distance(test.ends(), rig().rest_ends()), 5e-5f) << i;
    }
  }
}

TEST(Inertia, OfNothingStillSagsAndBlows) {
  TestHair test(rig());
  StepSettings settings = feeling(0);
  settings.environment = {.gravity = {0, 0, 5}, .wind = {3, 0, 0}};
  const Playback moving = play(
      test,
      [](double t) {
        return HeadPose{{9 * t * t, 0, 0}, {}};
      },
      even_frames(60, 4), settings);
  const Playback standing = play(rig(), still, even_frames(60, 4), feeling(1));
  StepSettings all = feeling(1);
  all.environment = settings.environment;
  EXPECT_LT(rms_tip_difference(moving, play(rig(), still, even_frames(60, 4), all)), 1e-5);
  EXPECT_GT(rms_tip_difference(moving, standing), 0.005);
}

/// Root mean square way of the tip from its rest, metres.
double swing(float inertia, const HeadMotion& motion) {
  const Playback rest = play(rig(), still, even_frames(60, 4), feeling(1));
  return rms_tip_difference(play(rig(), motion, even_frames(60, 4), feeling(inertia)), rest);
}

TEST(Inertia, OfAHalfIsHalfTheSwing) {
  for (const HeadMotion& motion : {HeadMotion(nod), HeadMotion(turn), HeadMotion(run)}) {
    const double whole = swing(1, motion);
    ASSERT_GT(whole, 0.003);
    EXPECT_NEAR(swing(0.5f, motion) / whole, 0.5, 0.1);
    EXPECT_NEAR(swing(0.25f, motion) / whole, 0.25, 0.1);
  }
}

TEST(Inertia, OfOneIsTheWholeMotion) {
  const Playback whole = play(rig(), wander, even_frames(60, 2));
  const Playback almost = play(rig(), wander, even_frames(60, 2), {.inertia = 0.99999f});
  EXPECT_EQ(rms_tip_difference(whole, play(rig(), wander, even_frames(60, 2), {.inertia = 1})), 0);
  EXPECT_LT(rms_tip_difference(whole, almost), 1e-4);
}

TEST(Inertia, IsTheSameAtEveryFrameRate) {
  for (const double fps : {24.0, 30.0, 144.0}) {
    EXPECT_LT(rms_tip_difference(play(rig(), wander, even_frames(fps, 4), feeling(0.4f)),
                                 play(rig(), wander, even_frames(960, 4), feeling(0.4f))),
              0.01 * 0.3)
        << fps;
  }
}

TEST(Inertia, BeyondItsRangeIsRefused) {
  TestHair test(rig());
  for (const float inertia : {-0.01f, 1.01f, NAN})
    EXPECT_EQ(test.hair.step({.inertia = inertia}), Status::kBadArgument);
}

}  // namespace
}  // namespace coif
