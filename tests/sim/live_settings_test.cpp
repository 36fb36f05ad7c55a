// Settings that change from step to step while hair moves.

#include "sim/playback.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

TestRig rig() {
  TestRig rig = calm_strand(4, 0.3f);
  for (DynamicsRecord& bone : rig.dynamics) bone.friction = 1, bone.resistance = 0.1f;
  return rig;
}

/// What one step with other settings changes, in the middle of a motion: the largest distance to where the bones would
/// have been.
float change_of_one_step(StepSettings other, float dt) {
  TestHair as_before(rig()), changed(rig());
  for (TestHair* test : {&as_before, &changed}) {
    (void)play(*test, wander, even_frames(240, 1));
    EXPECT_EQ(test->hair.set_head(0, wander(1 + double(dt))), Status::kOk);
  }
  other.dt = dt;
  EXPECT_EQ(as_before.hair.step({.dt = dt}), Status::kOk);
  EXPECT_EQ(changed.hair.step(other), Status::kOk);
  return largest_distance(as_before.ends(), changed.ends());
}

/// Positions and velocities go on: what another force does in a step falls with the step's square.
void expect_smooth(const StepSettings& other, const char* what) {
  const float after_long = change_of_one_step(other, 1.0f / 100), after_short = change_of_one_step(other, 1.0f / 400);
  EXPECT_LT(after_long, 0.03f) << what;
  EXPECT_LT(after_short, 0.1f * after_long + 2e-6f) << what;
  EXPECT_GT(after_long, 1e-6f) << what << " does something";
}

TEST(LiveSettings, DynamicsChangeWithoutAJump) {
  expect_smooth({.dynamics = {.stiffness = 10}}, "stiffer");
  expect_smooth({.dynamics = {.stiffness = 0}}, "limp");
  expect_smooth({.dynamics = {.damping = 0}}, "undamped");
  expect_smooth({.dynamics = {.damping = 5}}, "more damped");
  expect_smooth({.dynamics = {.friction = 50}}, "in water");
}

TEST(LiveSettings, SurroundingsChangeWithoutAJump) {
  expect_smooth({.environment = {.gravity = {0, 9.81f, 0}}}, "upside down");
  expect_smooth({.environment = {.wind = {20, 0, 0}}}, "a gust");
  expect_smooth({.environment = {.air_follow = 0}}, "still air");
}

TEST(LiveSettings, SubStepsChangeNextToNothing) {
  EXPECT_LT(change_of_one_step({.substeps = 4}, 1.0f / 60), 1e-3f);
  EXPECT_LT(change_of_one_step({.substeps = 64}, 1.0f / 60), 1e-3f);
}

TEST(LiveSettings, ScalesMultiplyWhatTheAssetSays) {
  TestRig soft = rig(), scaled = rig();
  for (DynamicsRecord& bone : soft.dynamics) bone.stiffness = 100, bone.damping = 5, bone.friction = 2;
  for (DynamicsRecord& bone : scaled.dynamics) bone.stiffness = 300, bone.damping = 10, bone.friction = 1;
  const StepSettings factors{.dynamics = {.stiffness = 3, .damping = 2, .friction = 0.5f}};
  const Playback a = play(soft, wander, even_frames(60, 2), factors), b = play(scaled, wander, even_frames(60, 2));
  EXPECT_EQ(rms_tip_difference(a, b), 0.0);
  EXPECT_GT(rms_tip_difference(a, play(soft, wander, even_frames(60, 2))), 1e-3);
}

TEST(LiveSettings, DefaultsAfterAChangeAreTheDefaultsAgain) {
  TestHair changed(rig()), calm(rig());
  (void)play(changed, wander, even_frames(60, 2), {.dynamics = {.stiffness = 0.1f}, .inertia = 0.5f});
  for (TestHair* test : {&changed, &calm}) (void)play(*test, until(1, wander), even_frames(60, 8));
  EXPECT_LT(largest_distance(changed.ends(), calm.ends()), 1e-5f);
}

}  // namespace
}  // namespace coif
