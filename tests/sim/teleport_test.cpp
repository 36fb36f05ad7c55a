// Heads that are put somewhere else, and what their hair feels of it.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coif::teleport_test {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
const Quat kTurn = turned_about({0.36f, 0.8f, 0.48f}, 3.0);

TestRig rig() {
  TestRig rig = calm_strand(4, 0.3f);
  rig.add_sphere({0, 0, 0}, 0.115f);
  return rig;
}

StepSettings weightless() {
  StepSettings settings;
  settings.environment.gravity = {};
  return settings;
}

/// `pose` seen from a world that is turned and moved.
HeadPose elsewhere(const HeadPose& pose, const Quat& turn, const Vec3& way) {
  const Vec3 at{float(pose.position[0]), float(pose.position[1]), float(pose.position[2])};
  const Vec3 turned = rotated(turn, at);
  return {{double(turned.x) + way.x, double(turned.y) + way.y, double(turned.z) + way.z}, product(turn, pose.rotation)};
}

constexpr int kFrames = 90, kJump = 45;

/// Plays `wander` twice without weight; in the middle the second head's world is turned and moved. Returns how far the
/// two shapes are from each other, at most. `announce`: the host says so.
float worst_difference(const Quat& turn, const Vec3& way, bool announce, const StepSettings& settings) {
  TestHair stays(rig()), jumps(rig());
  float worst = 0;
  for (int frame = 1; frame <= kFrames; ++frame) {
    const HeadPose pose = wander(frame / 60.0);
    const HeadPose other = frame < kJump ? pose : elsewhere(pose, turn, way);
    EXPECT_EQ(stays.hair.set_head(0, pose), Status::kOk);
    const bool says = announce && frame == kJump;
    EXPECT_EQ(says ? jumps.hair.teleport(0, other) : jumps.hair.set_head(0, other), Status::kOk);
    EXPECT_EQ(stays.hair.step(settings), Status::kOk);
    EXPECT_EQ(jumps.hair.step(settings), Status::kOk);
    worst = std::max(worst, largest_distance(stays.ends(), jumps.ends()));
  }
  return worst;
}

TEST(Teleport, AnnouncedKeepsShapeAndMotion) {
  // The head goes on steadily during the step, where the wandering one accelerates: that is what is left.
  EXPECT_LT(worst_difference(turned_about({0, 1, 0}, 1), {2, 1, 0}, true, weightless()), 1e-3f);
  EXPECT_LT(worst_difference(kTurn, {1000, 0, -30}, true, weightless()), 1e-3f);
  StepSettings in_parts = weightless();
  in_parts.substeps = 4;
  EXPECT_LT(worst_difference(kTurn, {1000, 0, -30}, true, in_parts), 1e-3f);
}

TEST(Teleport, DetectedIsAsAnnounced) {
  const StepSettings settings = weightless();
  EXPECT_LT(worst_difference({}, {6, 0, 0}, false, settings), 1e-3f) << "by distance";
  EXPECT_LT(worst_difference(kTurn, {}, false, settings), 1e-3f) << "by angle";
}

TEST(Teleport, BelowTheThresholdsHairFeelsTheWay) {
  EXPECT_GT(worst_difference({}, {4, 0, 0}, false, weightless()), 0.05f);
  EXPECT_GT(worst_difference(turned_about({0, 1, 0}, 2.5), {}, false, weightless()), 0.05f);
}

TEST(Teleport, ThresholdsAreTheHosts) {
  StepSettings believes = weightless(), wary = weightless();
  believes.teleport_distance = believes.teleport_angle = kInfinity;
  EXPECT_GT(worst_difference({}, {6, 0, 0}, false, believes), 0.05f);
  EXPECT_GT(worst_difference(kTurn, {}, false, believes), 0.05f);
  wary.teleport_distance = 0.5f;
  EXPECT_LT(worst_difference({}, {1, 0, 0}, false, wary), 1e-3f);
}

TEST(Teleport, ASteadyHeadsHairKeepsStillThroughIt) {
  for (const bool announce : {false, true}) {
    TestHair test(rig());
    const auto glide = [](int frame) {
      return HeadPose{{0.05 * frame, 0, 0.02 * frame}, turned_about({0, 1, 0}, 0.05 * frame)};
    };
    ASSERT_EQ(test.hair.reset(0, glide(0)), Status::kOk);
    for (int frame = 1; frame <= 300; ++frame) {
      ASSERT_EQ(test.hair.set_head(0, glide(frame)), Status::kOk);
      ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
    }
    const std::vector<Vec3> before = test.ends();
    for (int frame = 301; frame <= 320; ++frame) {
      const HeadPose pose = elsewhere(glide(frame), kTurn, {1e4f, -20, 7});
      const bool says = announce && frame == 301;
      ASSERT_EQ(says ? test.hair.teleport(0, pose) : test.hair.set_head(0, pose), Status::kOk);
      ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
      EXPECT_LT(largest_distance(test.ends(), before), 1e-4f) << frame;
    }
  }
}

TEST(Teleport, UnderASteadyHeadMovingHairGoesOnInEveryPart) {
  const auto steady = [](double t) { return HeadPose{{3 * t, 4 * t, 1 - t}, turned_about({0, 0.6f, 0.8f}, 1.5 * t)}; };
  TestHair stays(rig()), jumps(rig());
  StepSettings settings = weightless();
  settings.substeps = 3;
  double now = 0;
  for (int frame = 0; frame < 12; ++frame) {  // the hair has been left behind and catches up
    settings.dt = frame % 2 == 0 ? 0.03f : 0.02f;
    now += double(settings.dt);
    const HeadPose pose = steady(now), other = frame < 5 ? pose : elsewhere(pose, kTurn, {100, 200, 300});
    ASSERT_EQ(stays.hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(jumps.hair.set_head(0, other), Status::kOk);
    ASSERT_EQ(stays.hair.step(settings), Status::kOk);
    ASSERT_EQ(jumps.hair.step(settings), Status::kOk);
    ASSERT_LT(largest_distance(stays.ends(), jumps.ends()), 2e-5f) << frame;
    ASSERT_GT(largest_distance(stays.ends(), rig().rest_ends()), 1e-3f) << "or nothing moves";
  }
}

TEST(Teleport, AMillionMetresAwayEverythingGoesOn) {
  TestHair there(rig()), here(rig());
  (void)play(there, wander, even_frames(60, 1));
  HeadPose pose = wander(1);
  ASSERT_EQ(here.hair.reset(0, pose), Status::kOk);
  pose.position[0] += 1e6;
  ASSERT_EQ(there.hair.teleport(0, pose), Status::kOk);
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(there.hair.step({}), Status::kOk);
    ASSERT_EQ(here.hair.step({}), Status::kOk);
    ASSERT_LT(worst_stretch(rig(), there.ends()), 1e-5f);
  }
  EXPECT_LT(largest_distance(there.ends(), here.ends()), 1e-5f);
}

/// A tenth of a light year: further is no way that a float can tell, and the hair is put to rest there.
TEST(Teleport, KeepsTheShapeUpToTheFarthestWay) {
  constexpr double kFarthest = 1e15;
  const double beyond = std::nextafter(kFarthest, 2 * kFarthest);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double way : {kFarthest, -kFarthest, beyond, -beyond}) {
      TestHair test(rig()), near(rig());
      HeadPose pose;
      for (TestHair* const each : {&test, &near}) {
        ASSERT_EQ(each->hair.reset(0, pose), Status::kOk);
        ASSERT_EQ(each->hair.push(0, {.radius = 1, .speed = 3}), Status::kOk);
        for (int frame = 0; frame < 10; ++frame) ASSERT_EQ(each->hair.step(weightless()), Status::kOk);
      }
      pose.position[axis] = way;
      ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
      pose.position[axis] = 100;
      ASSERT_EQ(near.hair.set_head(0, pose), Status::kOk);
      for (TestHair* const each : {&test, &near}) ASSERT_EQ(each->hair.step(weightless()), Status::kOk);
      ASSERT_GT(largest_distance(near.ends(), rig().rest_ends()), 1e-2f);
      const bool is_way = std::fabs(way) <= kFarthest;
      EXPECT_LT(largest_distance(test.ends(), is_way ? near.ends() : rig().rest_ends()), 1e-4f) << way;
    }
  }
}

TEST(Teleport, BelievedAMillionMetresInAStepStaysFiniteAndUnstretched) {
  StepSettings believes;
  believes.teleport_distance = believes.teleport_angle = kInfinity;
  TestHair test(rig());
  for (int i = 0; i < 60; ++i) {
    const HeadPose pose{{i % 2 == 0 ? 1e6 : 0, 0, 0}, turned_about({0, 1, 0}, i)};
    ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(test.hair.step(believes), Status::kOk);
    ASSERT_LT(worst_stretch(rig(), test.ends()), 1e-5f) << i;
  }
  for (int i = 0; i < 1200; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
  TestHair calm(rig());
  ASSERT_EQ(calm.hair.reset(0, {{}, turned_about({0, 1, 0}, 59)}), Status::kOk);
  for (int i = 0; i < 300; ++i) ASSERT_EQ(calm.hair.step({}), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(), calm.ends()), 1e-3f);
}

TEST(Teleport, ResetForgetsIt) {
  TestHair test(rig());
  (void)play(test, wander, even_frames(60, 1));
  ASSERT_EQ(test.hair.teleport(0, {{50, 0, 0}, kTurn}), Status::kOk);
  ASSERT_EQ(test.hair.reset(0, {}), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(), rig().rest_ends()), 1e-6f);
  ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(), rig().rest_ends()), 1e-6f);
  ASSERT_EQ(test.hair.set_head(0, {{0.3, 0, 0}, {}}), Status::kOk);
  ASSERT_EQ(test.hair.teleport(0, {{50, 0, 0}, kTurn}), Status::kOk);
  ASSERT_EQ(test.hair.reset(0, {}), Status::kOk);
  ASSERT_EQ(test.hair.set_head(0, {{0.3, 0, 0}, {}}), Status::kOk);
  ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
  EXPECT_GT(largest_distance(test.ends(), rig().rest_ends()), 1e-2f) << "that was a movement";
}

TEST(Teleport, RefusesWhatSetHeadRefuses) {
  TestHair test(rig());
  EXPECT_EQ(test.hair.teleport(1, {}), Status::kBadIndex);
  EXPECT_EQ(test.hair.teleport(0, {{NAN, 0, 0}, {}}), Status::kBadPose);
  EXPECT_EQ(Hair{}.teleport(0, {}), Status::kNotCreated);
}

}  // namespace coif::teleport_test
