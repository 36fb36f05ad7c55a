// What colliders promise, whatever their shape: hair is never on the wrong side after a step, and a bone minds only the
// colliders of its set.

#include "sim/thesis_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace coif::collision_test {

constexpr float kRounding = 2e-5f;  // metres
constexpr double kPi = 3.14159265358979323846;

/// Metres from the point to the segment.
double distance_to_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double axis[3] = {double(b.x) - a.x, double(b.y) - a.y, double(b.z) - a.z};
  const double offset[3] = {double(p.x) - a.x, double(p.y) - a.y, double(p.z) - a.z};
  double along = 0, square = 0, rest = 0;
  for (int i = 0; i < 3; ++i) along += offset[i] * axis[i], square += axis[i] * axis[i];
  const double share = std::clamp(along / square, 0.0, 1.0);
  for (int i = 0; i < 3; ++i) rest += std::pow(offset[i] - share * axis[i], 2);
  return std::sqrt(rest);
}

/// Ten chains of three short bones, all about the origin, that keep `hit_radius`.
TestRig cloud(float hit_radius = 0) {
  TestRig rig;
  std::mt19937 random(3);
  const auto share = [&random] { return float(random()) / 4294967296.0f * 0.4f - 0.2f; };
  for (int chain = 0; chain < 10; ++chain) {
    std::uint32_t parent = 0;
    const Vec3 joint{share(), share(), share()};
    for (int i = 0; i < 3; ++i) {
      parent = rig.add({.parent = parent,
                        .joint = joint,
                        .length = 0.05f,
                        .resistance = 0.1f,
                        .friction = 1,
                        .hit_radius = hit_radius});
    }
  }
  return rig;
}

/// Calls `check` with every particle after each of 300 steps under a head that shakes and turns.
void for_each_end(const TestRig& rig, const std::function<void(const Vec3&)>& check) {
  TestHair test(rig, {.solver = &kThesisSolver});
  for (int frame = 0; frame < 300; ++frame) {
    const double t = frame / 60.0;
    const HeadPose pose{{0.2 * std::sin(9 * t), 0.1 * std::sin(13 * t), 0.1 * t},
                        turned_about({0.6f, 0, 0.8f}, 2 * std::sin(5 * t))};
    ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(test.hair.step({.iterations = 2}), Status::kOk);
    for (const Vec3& end : test.ends()) check(end);
  }
}

/// The result of one step of a bone of one metre that rests with its particle at `end`; nothing acts but colliders.
Vec3 stepped(TestRig rig, const Vec3& end, const Quat& head_rotation = {}) {
  ThesisStep step(rig);
  step.particles[0].position = end;
  step.head_rotation = head_rotation;
  step.run();
  return step.particles[0].position;
}

TestRig bone_from(const Vec3& joint, float hit_radius = 0) {
  TestRig rig;
  rig.add({.joint = joint, .hit_radius = hit_radius});
  return rig;
}

void touch_only(TestRig& rig, std::uint32_t set) {
  for (std::size_t i = 1; i < rig.bones.size(); ++i) rig.bones[i].colliders = set;
}

TEST(Collision, SphereKeepsItsDistance) {
  for (const float hit_radius : {0.0f, 0.03f}) {
    TestRig rig = cloud(hit_radius);
    rig.add_sphere({0.02f, 0.05f, 0}, 0.12f);
    for_each_end(rig, [&](const Vec3& end) {
      ASSERT_GT(distance(end, {0.02f, 0.05f, 0}), 0.12f + hit_radius - kRounding);
    });
  }
}

TEST(Collision, CapsuleKeepsItsDistance) {
  const Vec3 from{-0.1f, 0, 0.02f}, to{0.08f, -0.15f, 0};
  for (const float hit_radius : {0.0f, 0.03f}) {
    TestRig rig = cloud(hit_radius);
    rig.add_capsule(from, to, 0.06f);
    for_each_end(
        rig, [&](const Vec3& end) { ASSERT_GT(distance_to_segment(from, to, end), 0.06f + hit_radius - kRounding); });
  }
}

/// To the hull of two balls, metres: the smallest distance to the balls between them.
double gap_to_tapered(const Vec3& a, double radius_a, const Vec3& b, double radius_b, const Vec3& p) {
  double gap = INFINITY;
  for (int i = 0; i <= 500; ++i) {
    const double s = i / 500.0;
    const double x = a.x + s * (b.x - a.x), y = a.y + s * (b.y - a.y), z = a.z + s * (b.z - a.z);
    gap = std::min(gap, std::hypot(p.x - x, p.y - y, p.z - z) - radius_a - s * (radius_b - radius_a));
  }
  return gap;
}

TEST(Collision, TaperedCapsuleKeepsItsDistanceFromTheHullOfBothBalls) {
  const Vec3 from{-0.08f, 0, 0.02f}, to{0.1f, -0.1f, 0};
  for (const float hit_radius : {0.0f, 0.03f}) {
    TestRig rig = cloud(hit_radius);
    rig.add_tapered_capsule(from, 0.09f, to, 0.02f);
    for_each_end(
        rig, [&](const Vec3& end) { ASSERT_GT(gap_to_tapered(from, 0.09, to, 0.02, end), hit_radius - kRounding); });
  }
}

TEST(Collision, TaperedCapsuleOfEqualRadiiIsACapsule) {
  const Vec3 from{-0.1f, 0, 0.02f}, to{0.08f, -0.15f, 0};
  TestRig plain = cloud(0.01f), tapered = plain;
  plain.add_capsule(from, to, 0.06f);
  tapered.add_tapered_capsule(from, 0.06f, to, 0.06f);
  std::vector<Vec3> first, second;
  for_each_end(plain, [&](const Vec3& end) { first.push_back(end); });
  for_each_end(tapered, [&](const Vec3& end) { second.push_back(end); });
  EXPECT_EQ(largest_distance(first, second), 0.0f);
}

TEST(Collision, PlaneKeepsItsDistance) {
  for (const float hit_radius : {0.0f, 0.03f}) {
    TestRig rig = cloud(hit_radius);
    rig.add_plane({0, -0.05f, 0.3f}, {0, 0.6f, 0.8f});
    for_each_end(rig, [&](const Vec3& end) {
      ASSERT_GT(0.6f * (end.y + 0.05f) + 0.8f * (end.z - 0.3f), hit_radius - kRounding);
    });
  }
}

TEST(Collision, EllipsoidGrowsByTheHitRadiusOnEveryAxis) {
  for (const float hit_radius : {0.0f, 0.03f}) {
    TestRig rig = cloud(hit_radius);
    rig.add_ellipsoid({0, 0, 0}, {0.08f, 0.12f, 0.1f});
    for_each_end(rig, [&](const Vec3& end) {
      const float share =
          std::hypot(end.x / (0.08f + hit_radius), end.y / (0.12f + hit_radius), end.z / (0.1f + hit_radius));
      ASSERT_GT(share, 1 - 1e-4f);
    });
  }
}

TEST(Collision, ShapesThatKeepHairInsideLetNoneOut) {
  const Vec3 from{-0.05f, 0, 0}, to{0.05f, -0.05f, 0};
  for (const float hit_radius : {0.0f, 0.03f}) {
    TestRig in_sphere = cloud(hit_radius), in_capsule = cloud(hit_radius);
    in_sphere.add_sphere({0, 0, 0}, 0.1f);
    in_capsule.add_capsule(from, to, 0.08f);
    in_sphere.colliders[0].flags = in_capsule.colliders[0].flags = kColliderKeepsInside;
    for_each_end(in_sphere, [&](const Vec3& end) {
      ASSERT_LT(distance(end, {0, 0, 0}), 0.1f - hit_radius + kRounding);
    });
    for_each_end(in_capsule, [&](const Vec3& end) {
      ASSERT_LT(distance_to_segment(from, to, end), 0.08f - hit_radius + kRounding);
    });
  }
}

TEST(Collision, HitRadiusBeyondAnEnclosingShapeLeavesItsCentre) {
  TestRig sphere = bone_from({0, 1, 0}, 0.5f), capsule = bone_from({0, 1, 0}, 0.5f);
  sphere.add_sphere({0, 0.1f, 0}, 0.2f);
  capsule.add_capsule({-1, 0.1f, 0}, {1, 0.1f, 0}, 0.2f);
  sphere.colliders[0].flags = capsule.colliders[0].flags = kColliderKeepsInside;
  EXPECT_LT(distance(stepped(sphere, {0.6f, 0.2f, 0}), {0, 0.1f, 0}), kRounding);
  EXPECT_NEAR(stepped(capsule, {0.6f, 0.2f, 0}).y, 0.1f, kRounding);
}

TEST(Collision, ParticlesLeaveTheShortestWay) {
  TestRig capsule = bone_from({0.3f, 1.1f, 0}), plane = bone_from({0.3f, 0.9f, 0});
  capsule.add_capsule({-1, 0, 0}, {1, 0, 0}, 0.5f);
  plane.add_plane({0, 0, 0}, {0, 1, 0});
  EXPECT_LT(distance(stepped(capsule, {0.3f, 0.1f, 0}), {0.3f, 0.5f, 0}), kRounding) << "along the segment's side";
  EXPECT_LT(distance(stepped(plane, {0.3f, -0.1f, 0}), {0.3f, 0, 0}), kRounding);
  TestRig cap = bone_from({1.1f, 1, 0});
  cap.add_capsule({-1, 0, 0}, {1, 0, 0}, 0.5f);
  EXPECT_LT(distance(stepped(cap, {1.1f, 0, 0}), {1.5f, 0, 0}), kRounding) << "over the segment's end";
}

TEST(Collision, ParticleOnACapsulesSegmentLeavesSquarelyAndTurnsWithTheHead) {
  for (const Vec3& to : {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0.6f, 0.8f, 0}}) {
    TestRig rig = bone_from({0, 1, 0});
    rig.add_capsule({-to.x, -to.y, -to.z}, to, 0.5f);
    const Vec3 out = stepped(rig, {0, 0, 0});
    EXPECT_NEAR(distance(out, {0, 0, 0}), 0.5f, kRounding);
    EXPECT_NEAR(out.x * to.x + out.y * to.y + out.z * to.z, 0, kRounding);
    // The same seen from a head that lies on its face: (x, y, z) becomes (x, -z, y).
    const Vec3 turned = stepped(rig, {0, 0, 0}, turned_about({1, 0, 0}, kPi / 2));
    EXPECT_LT(distance(turned, {out.x, -out.z, out.y}), kRounding);
  }
}

TEST(Collision, ParticleOnASegmentsEndLeavesWhollyToo) {
  TestRig rig = bone_from({1, 1, 0});
  rig.add_capsule({-1, 0, 0}, {1, 0, 0}, 0.5f);
  EXPECT_NEAR(distance_to_segment({-1, 0, 0}, {1, 0, 0}, stepped(rig, {1, 0, 0})), 0.5, kRounding);
}

TEST(Collision, OutsideOfEverythingNothingMoves) {
  TestRig rig = bone_from({0, 1, 0}, 0.1f);
  rig.add_sphere({2, 0, 0}, 1.8f);
  rig.add_capsule({-2, -1, 0}, {-2, 1, 0}, 1.8f);
  rig.add_plane({0, -0.2f, 0}, {0, 1, 0});
  rig.add_sphere({0, 0, 0}, 3);
  rig.colliders[3].flags = kColliderKeepsInside;
  EXPECT_EQ(distance(stepped(rig, {0, 0, 0}), {0, 0, 0}), 0.0f);
}

TEST(ColliderSet, DecidesWhatABoneTouches) {
  for (std::uint32_t set = 0; set < 4; ++set) {
    TestRig rig = bone_from({0, 1, 0});
    rig.add_plane({0, 0.1f, 0}, {0, 1, 0});
    rig.add_plane({0, 0, 0.2f}, {0, 0, 1});
    rig.bones[1].colliders = set;
    const Vec3 end = stepped(rig, {0, 0, 0});
    EXPECT_EQ(end.y > 0.05f, (set & 1) != 0) << set;
    EXPECT_EQ(end.z > 0.15f, (set & 2) != 0) << set;
  }
}

TEST(ColliderSet, BitsWithoutAColliderAreIgnored) {
  TestRig rig = bone_from({0, 1, 0});
  rig.add_plane({0, 5, 0}, {0, -1, 0});
  rig.bones[1].colliders = ~0u;
  EXPECT_EQ(distance(stepped(rig, {0, 0, 0}), {0, 0, 0}), 0.0f);
}

TEST(ColliderSet, LeavingOutAColliderThatIsNeverTouchedChangesNoBit) {
  TestRig all = cloud(0.01f);
  all.add_sphere({0, 0, 0}, 0.1f);
  all.add_capsule({5, 0, 0}, {5, 1, 0}, 0.1f);
  TestRig fewer = all;
  touch_only(fewer, 0b01);
  std::vector<Vec3> first, second;
  for_each_end(all, [&](const Vec3& end) { first.push_back(end); });
  for_each_end(fewer, [&](const Vec3& end) { second.push_back(end); });
  EXPECT_EQ(largest_distance(first, second), 0.0f);
}

TEST(ColliderSet, EmptySetsSimulateAsWithoutColliders) {
  TestRig none = cloud(), untouchable = cloud();
  untouchable.add_sphere({0, 0, 0}, 0.15f);
  touch_only(untouchable, 0);
  std::vector<Vec3> first, second;
  for_each_end(none, [&](const Vec3& end) { first.push_back(end); });
  for_each_end(untouchable, [&](const Vec3& end) { second.push_back(end); });
  EXPECT_EQ(largest_distance(first, second), 0.0f);
}

TEST(ColliderSet, TheLastOfOverlappingCollidersHasItsWay) {
  TestRig rig = bone_from({0, 1, 0});
  rig.add_sphere({0, 0, 0}, 0.5f);
  rig.add_sphere({0, 0.6f, 0}, 0.5f);
  EXPECT_GT(distance(stepped(rig, {0, 0, 0}), {0, 0.6f, 0}), 0.5f - kRounding);
}

TEST(ColliderSet, MoreCollidersThanASetCanNameAreRefused) {
  TestRig rig = bone_from({0, 1, 0});
  for (std::uint32_t i = 0; i <= kMaxColliders; ++i) rig.add_sphere({}, 0.1f);
  AlignedBytes too_many(write_asset(rig.contents()));
  rig.colliders.pop_back();
  AlignedBytes most(write_asset(rig.contents()));
  EXPECT_FALSE(Asset{}.open(too_many.bytes()));
  EXPECT_TRUE(Asset{}.open(most.bytes()));
}

}  // namespace coif::collision_test
