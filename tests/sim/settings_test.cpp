// Whatever an asset or a game may say, particles stay finite and bones keep their length.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::settings_test {

/// Asserts after a step; lengths may be wrong by what single precision cannot resolve that far from the head.
void expect_sound(const TestRig& rig, const TestHair& test) {
  const std::vector<Vec3> ends = test.ends();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const float length = rig.bones[i + 1].length, far = distance(ends[i], {});
    ASSERT_NEAR(distance(start_of(rig, ends, i), ends[i]), length, 1e-5f * length + 1e-6f * (far + 0.1f))
        << "bone " << i;
  }
  for (const Mat34& matrix : test.hair.palette(0)) {
    for (const auto& row : matrix.m) ASSERT_NEAR(std::hypot(row[0], row[1], row[2]), 1, 1e-4);
  }
}

/// Violence at four time steps, then a wandering head.
void expect_survives(const TestRig& rig, StepSettings settings = {}) {
  settings.teleport_angle = 4;
  for (const float dt : {1e-6f, 1.0f / 240, 1.0f / 60, 0.1f}) {
    SCOPED_TRACE(testing::Message() << "dt " << dt);
    settings.dt = dt;
    TestHair test(rig);
    Violence violence(9);
    for (int i = 0; i < 60; ++i) {
      ASSERT_EQ(test.hair.set_head(0, i < 30 ? violence.next() : wander(double(i) * dt)), Status::kOk);
      ASSERT_EQ(test.hair.step(settings), Status::kOk);
      ASSERT_NO_FATAL_FAILURE(expect_sound(rig, test)) << "step " << i;
    }
  }
}

/// Four bones beside a head, all alike but for their length.
TestRig strand_of(TestBone bone, const std::vector<float>& lengths) {
  TestRig rig;
  bone.joint = {0, 0.02f, -0.12f};
  for (const float length : lengths) {
    bone.length = length;
    bone.parent = rig.add(bone);
  }
  rig.add_sphere({}, 0.1f);
  return rig;
}

const std::vector<float> kUsual = {0.1f, 0.1f, 0.1f, 0.1f};

TEST(ExtremeSettings, Resistances) {
  for (const float resistance : {0.0f, 1e-6f, 0.5f, 1 - 1e-6f, 1.0f}) {
    SCOPED_TRACE(resistance);
    expect_survives(strand_of({.resistance = resistance}, kUsual));
    expect_survives(strand_of({.resistance = resistance, .friction = 1}, kUsual), {.substeps = 8});
  }
}

TEST(ExtremeSettings, Frictions) {
  for (const float friction : {0.0f, 1e-3f, 10.0f, 1e4f}) {
    SCOPED_TRACE(friction);
    expect_survives(strand_of({.resistance = 0.1f, .friction = friction}, kUsual));
    expect_survives(strand_of({.friction = friction, .torsion = friction}, kUsual), {.dynamics = {.friction = 1e6f}});
  }
}

TEST(ExtremeSettings, Gravities) {
  for (const float gravity : {1e3f, 1e5f, 1e8f}) {
    SCOPED_TRACE(gravity);
    StepSettings settings;
    settings.environment.gravity = {gravity, -gravity, 0};
    expect_survives(strand_of({.resistance = 0.1f, .friction = 1}, kUsual), settings);
    expect_survives(strand_of({.resistance = 0}, kUsual), settings);
  }
}

TEST(ExtremeSettings, Lengths) {
  for (const float length : {1e-5f, 1e-3f, 1.0f, 30.0f, 1e3f}) {
    SCOPED_TRACE(length);
    expect_survives(strand_of({.resistance = 0.1f, .friction = 1}, {length, length, length}));
  }
  expect_survives(strand_of({.resistance = 0.1f, .friction = 1}, {1e-5f, 1e3f, 1e-5f, 0.1f}));
  expect_survives(strand_of({.resistance = 0.1f, .friction = 1}, {1e-3f, 10, 1e-2f, 0.1f}));
}

TEST(ExtremeSettings, JointsOnJoints) {
  expect_survives(strand_of({.resistance = 0.2f, .friction = 1}, {0.1f, 1e-6f, 1e-6f, 0.1f}));
  expect_survives(strand_of({.resistance = 0, .friction = 0}, {1e-6f, 1e-6f, 1e-6f, 0.1f}));
}

TEST(ExtremeSettings, ScalesAtTheirBounds) {
  for (const float stiffness : {0.0f, 1e6f}) {
    for (const float damping : {0.0f, 1e6f}) {
      SCOPED_TRACE(testing::Message() << stiffness << " " << damping);
      expect_survives(strand_of({.resistance = 0.3f, .friction = 1}, kUsual),
                      {.dynamics = {.stiffness = stiffness, .damping = damping}});
    }
  }
}

TEST(ExtremeSettings, AHeadThatSpinsAtAHundredRadiansPerSecond) {
  const TestRig rig = strand_of({.resistance = 0.1f, .friction = 1}, kUsual);
  for (const double fps : {10.0, 60.0, 240.0}) {
    TestHair test(rig);
    StepSettings settings{.dt = float(1 / fps), .teleport_angle = 4};
    for (int i = 1; i < 300; ++i) {
      ASSERT_EQ(test.hair.set_head(0, {{}, turned_about({0.6f, 0.8f, 0}, 100 * i / fps)}), Status::kOk);
      ASSERT_EQ(test.hair.step(settings), Status::kOk);
      ASSERT_NO_FATAL_FAILURE(expect_sound(rig, test)) << fps << " fps, frame " << i;
    }
  }
}

TEST(ExtremeSettings, RootsInsideTheHead) {
  for (const float depth : {0.0f, 0.05f, 0.0999f, 0.1f}) {
    SCOPED_TRACE(depth);
    TestRig rig;
    const std::uint32_t root = rig.add({.joint = {0, 0.1f - depth, 0}, .length = 0.08f, .resistance = 0.1f});
    rig.add({.parent = root, .length = 0.08f, .resistance = 0.1f});
    rig.add_sphere({}, 0.1f);
    expect_survives(rig);
  }
}

TEST(ExtremeSettings, RadiiThatNoBoneCanKeep) {
  TestRig rig = strand_of({.resistance = 0.1f, .hit_radius = 10}, kUsual);
  rig.add_capsule({-1, 0, 0}, {1, 0, 0}, 0.3f);
  rig.add_plane({0, 0.5f, 0}, {0, 1, 0});
  rig.add_plane({0, -0.5f, 0}, {0, -1, 0});
  rig.add_sphere({0.5f, 0, 0}, 0.1f);
  rig.colliders.back().flags = kColliderKeepsInside;
  expect_survives(rig);
}

TEST(ExtremeSettings, TheShortestStepsThereAre) {
  for (const float dt : {1e-9f, 1e-20f, 1e-38f}) {
    const TestRig rig = strand_of({.resistance = 0.1f, .friction = 1}, kUsual);
    TestHair test(rig);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(test.hair.step({.dt = dt}), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), rig.rest_ends()), 1e-4f) << dt;
  }
}

// Settings that change from step to step while hair moves.

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

/// Ends of two seconds of wandering with these numbers of every bone.
Playback played_with(ChainModel model, float stiffness, float damping, float friction, const DynamicsScale& factors) {
  TestRig rigged = rig();
  rigged.model = model;
  for (DynamicsRecord& bone : rigged.dynamics) {
    bone.stiffness = stiffness, bone.damping = damping, bone.friction = friction;
    if (model == ChainModel::kPassive) bone.torsion = kShortestArc;
  }
  return play(rigged, wander, even_frames(60, 2), {.dynamics = factors});
}

TEST(LiveSettings, NoFactorLeadsBeyondWhatACookBakes) {
  for (const ChainModel model : {ChainModel::kCascade, ChainModel::kPassive}) {
    const auto difference = [model](const Playback& a, float stiffness, float damping, float friction) {
      return rms_tip_difference(a, played_with(model, stiffness, damping, friction, {}));
    };
    const Playback stiff = played_with(model, 100, 5, 2, {.stiffness = kMostScale});
    EXPECT_EQ(difference(stiff, kMostStiffness, 5, 2), 0.0);
    EXPECT_EQ(difference(stiff, 1e12f, 5, 2), 0.0);  // what an asset says ends there too
    EXPECT_GT(difference(stiff, 0.25f * kMostStiffness, 5, 2), 0.0);
    const Playback damped = played_with(model, 100, 5, 2, {.damping = kMostScale});
    EXPECT_EQ(difference(damped, 100, kMostDamping, 2), 0.0);
    EXPECT_GT(difference(damped, 100, 0.5f * kMostDamping, 2), 0.0);
    const Playback slow = played_with(model, 100, 5, 2, {.friction = kMostScale});
    EXPECT_EQ(difference(slow, 100, 5, kMostDamping), 0.0);
    EXPECT_GT(difference(slow, 100, 5, 0.5f * kMostDamping), 0.0);
    const Playback all = played_with(model, 100, 5, 2, {kMostScale, kMostScale, kMostScale});
    EXPECT_EQ(difference(all, kMostStiffness, kMostDamping, kMostDamping), 0.0);
  }
}

TEST(LiveSettings, DefaultsAfterAChangeAreTheDefaultsAgain) {
  TestHair changed(rig()), calm(rig());
  (void)play(changed, wander, even_frames(60, 2), {.dynamics = {.stiffness = 0.1f}, .inertia = 0.5f});
  for (TestHair* test : {&changed, &calm}) (void)play(*test, until(1, wander), even_frames(60, 8));
  EXPECT_LT(largest_distance(changed.ends(), calm.ends()), 1e-5f);
}

}  // namespace coif::settings_test
