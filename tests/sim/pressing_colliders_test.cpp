// Colliders that turn into hair and take it along, and such as press it against something that stands.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace coif::pressing_colliders_test {

constexpr ChainModel kModels[] = {ChainModel::kCascade, ChainModel::kPassive};

StepSettings weightless(float dt) {
  StepSettings settings{.dt = dt, .substeps = 1};
  settings.environment.gravity = {};
  return settings;
}

constexpr float kFast = 10;  ///< rad/s
constexpr float kShort = 1.0f / 240;

/// A bar of 60 cm that turns about the vertical through one of its ends, 30 cm behind the strand; at 0 it points at
/// that.
MovingCollider bar(ColliderShape shape, double angle, bool tells_velocity) {
  MovingCollider bar{.shape = shape, .center = {0, -0.09, -0.3}, .rotation = turned_about({0, 1, 0}, angle)};
  bar.axis = {0, 0, 0.6f};
  bar.radius = bar.end_radius = 0.01f;
  if (shape == ColliderShape::kTaperedCapsule) bar.end_radius = 0.012f;
  bar.half_extents = {0.005f, 0.005f, 0.6f};
  if (shape == ColliderShape::kBox) bar.radius = 0.005f;
  bar.is_velocity_known = tells_velocity;
  if (tells_velocity) bar.velocity.angular = {0, kFast, 0};
  return bar;
}

/// One bone of 10 cm hangs from the origin and is hit a centimetre above its end.
TEST(PressingColliders, ThrowHairAsFastAsTheyTurn) {
  TestRig rig;
  TestBone bone{.length = 0.1f};
  bone.stiffness = 0.01f;
  bone.damping = 0;
  rig.add(bone);
  for (const ChainModel model : kModels) {
    rig.model = model;
    for (const ColliderShape shape : {ColliderShape::kCapsule, ColliderShape::kTaperedCapsule, ColliderShape::kBox}) {
      for (const bool tells : {false, true}) {
        for (const double side : {1.0, -1.0}) {  // from the left, or from the right
          TestHair test(rig, {.solver = &kCharacterSolver, .moving_colliders = 1});
          for (double angle = -0.3; angle < 0.08; angle += double(kFast * kShort)) {
            MovingCollider one = bar(shape, side * angle, tells);
            one.velocity.angular.y *= float(side);
            ASSERT_EQ(test.hair.set_colliders(0, {&one, 1}), Status::kOk);
            ASSERT_EQ(test.hair.step(weightless(kShort)), Status::kOk);
          }
          const Vec3 before = test.ends()[0];
          ASSERT_EQ(test.hair.set_colliders(0, {}), Status::kOk);
          ASSERT_EQ(test.hair.step(weightless(1e-3f)), Status::kOk);
          const double speed = side * double(test.ends()[0].x - before.x) / 1e-3;
          // 0.3 m from the axis, and a ninth more at the bone's end.
          EXPECT_GT(speed, 0.8 * 3.3) << int(shape) << (tells ? " told" : "");
          EXPECT_LT(speed, 1.5 * 3.3) << int(shape) << (tells ? " told" : "");
        }
      }
    }
  }
}

/// What stands, and how deep a point is in it.
struct Wall {
  const char* name;
  std::function<void(TestRig&)> add;
  std::vector<MovingCollider> colliders;
  std::function<float(const Vec3&)> depth;
};

std::vector<Wall> walls() {
  MovingCollider plane{.shape = ColliderShape::kPlane, .center = {0.1, 0.2, -0.16}, .axis = {0, 0, 2}};
  const auto behind_plane = [](const Vec3& p) { return -0.16f - p.z; };
  return {{"a plane of the asset",
           [](TestRig& rig) {
             rig.add_plane({0.1f, 0.2f, -0.16f}, {0, 0, 1});
           },
           {},
           behind_plane},
          {"a plane of the game", [](TestRig&) {}, {plane}, behind_plane},
          {"a ball that keeps hair inside",
           [](TestRig& rig) {
             rig.add_sphere({0.02f, 0, 0.1f}, 0.26f);
             rig.colliders.back().flags |= kColliderKeepsInside;
           },
           {},
           [](const Vec3& p) { return std::hypot(p.x - 0.02f, p.y, p.z - 0.1f) - 0.26f; }}};
}

/// A ball comes from before the strand until it overlaps with what stands behind that: hair goes out sideways.
TEST(PressingColliders, HairBetweenAHandAndAWallIsInNeither) {
  for (const ChainModel model : kModels) {
    for (const Wall& wall : walls()) {
      for (const float hit_radius : {0.0f, 0.003f, 0.01f}) {
        TestRig rig;
        rig.model = model;
        TestBone bone{.joint = {0, 0.05f, -0.1f}, .length = 0.06f, .friction = 1, .stiffness = 60, .damping = 12};
        bone.hit_radius = hit_radius;
        bone.torsion = kShortestArc;
        rig.add_strand(4, bone);
        wall.add(rig);
        TestHair test(rig, {.solver = &kCharacterSolver, .moving_colliders = 2});
        float in_hand = 0, in_wall = 0, aside = 0;
        for (int frame = 0; frame < 120; ++frame) {
          MovingCollider hand{.center = {0.005, -0.06, -0.0 - 0.002 * std::min(frame, 60)}};
          hand.radius = 0.04f;
          std::vector<MovingCollider> all = wall.colliders;
          all.push_back(hand);
          ASSERT_EQ(test.hair.set_colliders(0, all), Status::kOk);
          ASSERT_EQ(test.hair.step({}), Status::kOk);
          for (const Vec3& end : test.ends()) {
            const double away = std::hypot(double(end.x) - hand.center[0], double(end.y) - hand.center[1],
                                           double(end.z) - hand.center[2]);
            in_hand = std::max(in_hand, float(0.04 - away) + hit_radius);
            in_wall = std::max(in_wall, wall.depth(end) + hit_radius);
            aside = std::max(aside, std::fabs(end.x));
          }
        }
        EXPECT_LT(in_hand, 1e-5f) << wall.name;
        EXPECT_LT(in_wall, 3e-5f) << wall.name;
        EXPECT_GT(aside, 0.02f) << wall.name;
      }
    }
  }
}

/// A plate that appears around a bone's end, whichever of its own axes is the thin one.
TEST(PressingColliders, ABoxIsLeftByItsNearestFace) {
  TestRig rig;
  rig.add({.length = 0.1f, .stiffness = 100, .damping = 10, .torsion = kShortestArc});
  for (const ChainModel model : kModels) {
    rig.model = model;
    for (const double side : {1.0, -1.0}) {
      MovingCollider by_x{.shape = ColliderShape::kBox, .center = {side * 0.002, -0.1, 0}};
      by_x.half_extents = {0.005f, 0.03f, 0.05f};
      MovingCollider by_z{.shape = ColliderShape::kBox, .center = {0, -0.1, side * 0.002}};
      by_z.half_extents = {0.05f, 0.03f, 0.005f};
      MovingCollider by_own_y{.shape = ColliderShape::kBox, .center = {0, -0.1, side * 0.002}};
      by_own_y.rotation = turned_about({1, 0, 0}, 1.57079633);
      by_own_y.half_extents = {0.05f, 0.005f, 0.03f};
      for (const MovingCollider& plate : {by_x, by_z, by_own_y}) {
        TestHair test(rig, {.solver = &kCharacterSolver, .moving_colliders = 1});
        ASSERT_EQ(test.hair.set_colliders(0, {&plate, 1}), Status::kOk);
        ASSERT_EQ(test.hair.step(weightless(kShort)), Status::kOk);
        const Vec3 end = test.ends()[0];
        const float way = plate.center[0] != 0 ? end.x : end.z, beside = plate.center[0] != 0 ? end.z : end.x;
        // It comes in at the plate's upper edge, 7 cm below its start, and goes past that 3 mm beside.
        EXPECT_NEAR(way, -side * 0.003 / 0.07 * 0.1, 5e-5);
        EXPECT_NEAR(beside, 0, 1e-4);
      }
    }
  }
}

/// A head that is put somewhere, or seen again, knows nothing of where its colliders were before.
TEST(PressingColliders, HaveNoWayToAHeadThatWasNotThere) {
  TestRig rig;
  TestBone bone{.length = 0.06f, .stiffness = 60, .damping = 12};
  bone.torsion = kShortestArc;
  rig.add_strand(3, bone);
  for (const ChainModel model : kModels) {
    rig.model = model;
    for (const bool is_reset : {true, false}) {
      TestHair test(rig, {.solver = &kCharacterSolver, .moving_colliders = 1});
      for (const double x : {-0.3, 0.3}) {
        MovingCollider hand{.center = {x, -0.1, 0}};
        hand.radius = 0.04f;
        if (x > 0 && is_reset) {
          ASSERT_EQ(test.hair.reset(0, {}), Status::kOk);
        } else if (x > 0) {
          ASSERT_EQ(test.hair.set_detail(0, {.simulated = false}), Status::kOk);
          ASSERT_EQ(test.hair.step(weightless(kShort)), Status::kOk);
          ASSERT_EQ(test.hair.set_detail(0, {.simulated = true}), Status::kOk);
        }
        ASSERT_EQ(test.hair.set_colliders(0, {&hand, 1}), Status::kOk);
        ASSERT_EQ(test.hair.step(weightless(kShort)), Status::kOk);
      }
      EXPECT_LT(largest_distance(test.ends(), rig.rest_ends()), 1e-6f) << is_reset;
    }
  }
}

}  // namespace coif::pressing_colliders_test
