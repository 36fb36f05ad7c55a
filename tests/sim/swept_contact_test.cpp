// A head that turns so far in one step that hair would pass through a collider between two frames.

#include "sim/playback.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

constexpr double kDegree = 0.01745329251994329577;

/// One soft bone that rests along +x from the origin, and a collider at an angle (degrees, counter-clockwise seen from
/// +z) and 0.2 m away.
TestRig hand_of_a_clock(ColliderShape shape, double angle) {
  TestRig rig;
  rig.add({.rest_direction = {1, 0, 0}, .length = 0.3f, .stiffness = 10, .damping = 0.5f});
  const float x = float(0.2 * std::cos(angle * kDegree)), y = float(0.2 * std::sin(angle * kDegree));
  if (shape == ColliderShape::kSphere) rig.add_sphere({x, y, 0}, 0.07f);
  if (shape == ColliderShape::kEllipsoid) rig.add_ellipsoid({x, y, 0}, {0.06f, 0.09f, 0.07f});
  if (shape == ColliderShape::kCapsule) rig.add_capsule({x, y, -0.2f}, {x, y, 0.2f}, 0.06f);
  if (shape == ColliderShape::kTaperedCapsule) rig.add_tapered_capsule({x, y, -0.2f}, 0.05f, {x, y, 0.2f}, 0.08f);
  return rig;
}

/// Degrees, counter-clockwise from +x.
double angle_of(const TestHair& test) { return std::atan2(test.ends()[0].y, test.ends()[0].x) / kDegree; }

StepSettings weightless() {
  StepSettings settings{.dt = 0.1f};
  settings.environment.gravity = {};
  return settings;
}

constexpr ColliderShape kRound[] = {ColliderShape::kSphere, ColliderShape::kEllipsoid, ColliderShape::kCapsule,
                                    ColliderShape::kTaperedCapsule};

TEST(SweptContact, ATurnOf150DegreesLeavesHairOnTheSideThatItCameFrom) {
  for (const ColliderShape shape : kRound) {
    for (const double side : {-1.0, 1.0}) {
      for (double at = 40; at <= 110; at += 5) {
        SCOPED_TRACE(testing::Message() << "shape " << int(shape) << " at " << side * at << " degrees");
        // Turned the other way than the collider is, the head carries the collider through the hair.
        TestHair test(hand_of_a_clock(shape, side * at));
        ASSERT_EQ(test.hair.set_head(0, {{}, turned_about({0, 0, 1}, -side * 150 * kDegree)}), Status::kOk);
        ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
        EXPECT_LT(side * angle_of(test), at) << "beyond it";
        EXPECT_GT(side * angle_of(test), at - 60) << "it was not taken along";
        StepSettings calming = weightless();
        calming.dynamics = {.stiffness = 20, .damping = 100};
        for (int i = 0; i < 60; ++i) ASSERT_EQ(test.hair.step(calming), Status::kOk);
        EXPECT_NEAR(angle_of(test), 0, 1);
      }
    }
  }
}

TEST(SweptContact, WithoutAColliderItPassesThere) {
  TestRig rig = hand_of_a_clock(ColliderShape::kSphere, 75);
  rig.bones[1].colliders = 0;
  TestHair test(rig);
  ASSERT_EQ(test.hair.set_head(0, {{}, turned_about({0, 0, 1}, -150 * kDegree)}), Status::kOk);
  ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
  EXPECT_GT(angle_of(test), 90);
}

TEST(SweptContact, ASmallTurnThatTouchesNothingIsFree) {
  for (const ColliderShape shape : kRound) {
    TestRig with = hand_of_a_clock(shape, 120), without = with;
    without.bones[1].colliders = 0;
    TestHair a(with), b(without);
    for (TestHair* test : {&a, &b}) {
      ASSERT_EQ(test->hair.set_head(0, {{}, turned_about({0, 0, 1}, -50 * kDegree)}), Status::kOk);
      ASSERT_EQ(test->hair.step(weightless()), Status::kOk);
    }
    EXPECT_EQ(largest_distance(a.ends(), b.ends()), 0.0f) << int(shape);
  }
}

}  // namespace
}  // namespace coif
