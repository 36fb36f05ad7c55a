// A head that turns so far in one step that hair would pass through a collider between two frames.

#include "models/playback.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace coif::contact_test {

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

// Bones that touch colliders, many side by side: each is turned as little as it takes, and none minds its neighbours.

using Point = std::array<double, 3>;

constexpr double kPi = 3.14159265358979323846;
constexpr ColliderShape kShapes[] = {ColliderShape::kSphere, ColliderShape::kEllipsoid, ColliderShape::kCapsule,
                                     ColliderShape::kTaperedCapsule, ColliderShape::kPlane};

Point point_of(const Vec3& v) { return {v.x, v.y, v.z}; }
Point plus(const Point& a, const Point& b, double s) { return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double size(const Point& a) { return std::sqrt(dot(a, a)); }

/// Where a convex function is least between 0 and `end`.
double where_least(double end, const std::function<double(double)>& f) {
  double low = 0, high = end;
  for (int i = 0; i < 40; ++i) {
    const double third = (high - low) / 3;
    if (f(low + third) < f(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  if (f(0) <= f(low)) return 0;
  return f(end) <= f(low) ? end : low;
}

/// Metres from the collider to the point less the hair's radius, negative inside; of an ellipsoid only the sign is
/// exact.
double gap_of(const ColliderRecord& c, double hit_radius, const Point& p) {
  const Point center{c.center[0], c.center[1], c.center[2]}, axis{c.axis[0], c.axis[1], c.axis[2]};
  const Point offset = plus(p, center, -1);
  if (c.shape == ColliderShape::kPlane) return dot(offset, axis) - hit_radius;
  if (c.shape == ColliderShape::kSphere) return size(offset) - c.radii[0] - hit_radius;
  if (c.shape == ColliderShape::kEllipsoid) {
    const Quat back{-c.rotation[0], -c.rotation[1], -c.rotation[2], c.rotation[3]};
    const Point own = point_of(rotated(back, {float(offset[0]), float(offset[1]), float(offset[2])}));
    Point unit;
    for (std::size_t i = 0; i < 3; ++i) unit[i] = own[i] / (double(c.radii[i]) + hit_radius);
    return (size(unit) - 1) * std::min({c.radii[0], c.radii[1], c.radii[2]});
  }
  const bool tapers = c.shape == ColliderShape::kTaperedCapsule;
  const double taper = tapers ? double(c.radii[0]) - c.radii[1] : 0;
  const auto ball = [&](double share) { return size(plus(offset, axis, -share)) - (c.radii[0] - taper * share); };
  return ball(where_least(1, ball)) - hit_radius;
}

/// A bone as the test knows it: one of a chain each.
struct Segment {
  Point start, direction;
  double length, hit_radius;
};

Point deepest_point(const ColliderRecord& collider, const Segment& bone) {
  const auto at = [&](double along) { return plus(bone.start, bone.direction, along); };
  if (collider.shape == ColliderShape::kPlane) return at(bone.length);  // only the end can be behind it
  return at(where_least(bone.length, [&](double along) { return gap_of(collider, bone.hit_radius, at(along)); }));
}

double gap_of(const ColliderRecord& collider, const Segment& bone) {
  return gap_of(collider, bone.hit_radius, deepest_point(collider, bone));
}

/// The sine of the angle between the bone and the surface's normal where it is deepest.
double sideways(const ColliderRecord& collider, const Segment& bone) {
  const Point deepest = deepest_point(collider, bone);
  Point normal{};
  for (std::size_t i = 0; i < 3; ++i) {
    Point step{};
    step[i] = 1e-4;
    normal[i] = gap_of(collider, 0, plus(deepest, step, 1)) - gap_of(collider, 0, plus(deepest, step, -1));
  }
  const double cosine = dot(normal, bone.direction) / size(normal);
  return std::sqrt(std::max(0.0, 1 - cosine * cosine));
}

/// The least angle by which any of many ways to turn takes the bone out of the collider, radians.
double least_turn(const ColliderRecord& collider, const Segment& bone) {
  const Point& d = bone.direction;
  const Point other = std::fabs(d[0]) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0};
  Point u = plus(other, d, -dot(other, d));
  u = plus({}, u, 1 / size(u));
  const Point v{d[1] * u[2] - d[2] * u[1], d[2] * u[0] - d[0] * u[2], d[0] * u[1] - d[1] * u[0]};
  double best = kPi;
  for (int way = 0; way < 60; ++way) {
    const Point side = plus(plus({}, u, std::cos(way * kPi / 30)), v, std::sin(way * kPi / 30));
    const auto is_clear = [&](double angle) {
      Segment turned = bone;
      turned.direction = plus(plus({}, d, std::cos(angle)), side, std::sin(angle));
      return gap_of(collider, turned) >= 0;
    };
    if (!is_clear(best)) continue;
    double low = 0, high = best;
    while (high - low > 1e-5) (is_clear((low + high) / 2) ? high : low) = (low + high) / 2;
    best = high;
  }
  return best;
}

void add_collider(TestRig& rig, ColliderShape shape) {
  switch (shape) {
    case ColliderShape::kSphere: return rig.add_sphere({0.01f, 0, 0}, 0.1f);
    case ColliderShape::kEllipsoid: {
      return rig.add_ellipsoid({0, 0.01f, 0}, {0.08f, 0.12f, 0.1f}, turned_about({0.6f, 0, 0.8f}, 0.7));
    }
    case ColliderShape::kCapsule: return rig.add_capsule({-0.06f, 0, 0.02f}, {0.07f, 0.03f, 0}, 0.07f);
    case ColliderShape::kTaperedCapsule: {
      return rig.add_tapered_capsule({-0.06f, 0, 0}, 0.09f, {0.07f, 0, 0.03f}, 0.05f);
    }
    case ColliderShape::kPlane: return rig.add_plane({0, 0.01f, 0}, {0, 0.8f, 0.6f});
    case ColliderShape::kBox: break;  // In no asset.
  }
}

/// Bones about the origin in all directions, on which nothing acts; about half of them reach into the collider. Each
/// differs from its neighbours in everything.
TestRig crossing_bones(ColliderShape shape, std::uint32_t seed, std::uint32_t count) {
  TestRig rig;
  std::mt19937 random(seed);
  const auto share = [&random] { return double(random()) / 4294967296.0 * 2 - 1; };
  while (rig.simulated_count() < count) {
    Point joint{share(), share(), share()}, way{share(), share(), share()};
    if (!(size(joint) > 0.1 && size(way) > 0.1)) continue;
    joint = plus({}, joint, (0.17 + 0.03 * share()) / size(joint));
    way = plus({}, way, 1 / size(way));
    if (rig.simulated_count() % 4 != 0) way = plus(way, joint, -9);  // more of them inwards
    way = plus({}, way, 1 / size(way));
    rig.add({.joint = {float(joint[0]), float(joint[1]), float(joint[2])},
             .rest_direction = {float(way[0]), float(way[1]), float(way[2])},
             .length = float(0.12 + 0.05 * share()),
             .hit_radius = rig.simulated_count() % 2 == 0 ? 0 : 0.01f,
             .stiffness = 0,
             .damping = 0});
  }
  add_collider(rig, shape);
  return rig;
}

Segment segment_of(const TestRig& rig, std::size_t i, const Vec3& end) {
  const BoneRecord& bone = rig.bones[i + 1];
  Segment segment{{bone.joint[0], bone.joint[1], bone.joint[2]}, {}, bone.length, rig.dynamics[i + 1].hit_radius};
  const Point way = plus(point_of(end), segment.start, -1);
  segment.direction = plus({}, way, 1 / size(way));
  return segment;
}

std::vector<Vec3> ends_after_a_step(const TestRig& rig, InstructionSet set, const Quat& turn = {},
                                    std::uint32_t instances = 1) {
  TestHair test(rig, {.instances = instances, .instruction_set = set});
  for (std::uint32_t i = 0; i < instances; ++i) EXPECT_EQ(test.hair.set_head(i, {{}, turn}), Status::kOk);
  EXPECT_EQ(test.hair.step(weightless()), Status::kOk);
  return test.ends(instances - 1);
}

// As deep as one step takes it. Newton's method, where it is used, comes from inside and stops once outside: a little
// too far from deeper, and where the bone meets the surface head-on.
TEST(LaneContact, TurnsABoneToTheSurfaceAndNoFurtherThanItTakes) {
  for (const ColliderShape shape : kShapes) {
    const TestRig rig = crossing_bones(shape, 5, 300);
    const ColliderRecord& collider = rig.colliders[0];
    const std::vector<Vec3> rest = rig.rest_ends(), ends = ends_after_a_step(rig, InstructionSet::kBest);
    const bool is_exact = shape == ColliderShape::kSphere || shape == ColliderShape::kPlane;
    const double deepest = is_exact ? 0.05 : 0.002;
    int touching = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      SCOPED_TRACE(testing::Message() << "shape " << int(shape) << ", bone " << i);
      const Segment before = segment_of(rig, i, rest[i]), after = segment_of(rig, i, ends[i]);
      const double start_gap = gap_of(collider, before.hit_radius, before.start);
      const double depth = -gap_of(collider, before);
      if (!(start_gap > 1e-3 && depth > 1e-4 && depth < deepest && sideways(collider, before) > 0.5)) continue;
      ++touching;
      EXPECT_GT(gap_of(collider, after), -1e-6);
      EXPECT_LT(gap_of(collider, after), 1e-4);
      const double turned = std::acos(std::min(1.0, dot(before.direction, after.direction)));
      EXPECT_LT(turned, 1.02 * least_turn(collider, before) + 1e-3);
    }
    EXPECT_GE(touching, 8) << "shape " << int(shape);
  }
}

// What pushes into a wall is taken away there: hair that lay against it for long leaves it as hair does that just came.
TEST(LaneContact, AWallFromWithinStoresNoSpeed) {
  for (const bool is_capsule : {false, true}) {
    TestRig rig;
    rig.add({.joint = {0, 0.05f, 0}, .rest_direction = {0, -1, 0}, .length = 0.1f, .stiffness = 0, .damping = 1});
    if (is_capsule) rig.add_capsule({0, 0, -0.1f}, {0, 0, 0.1f}, 0.1f);
    if (!is_capsule) rig.add_sphere({0, 0, 0}, 0.1f);
    rig.colliders[0].flags = kColliderKeepsInside;
    const auto left = [&](int frames) {
      TestHair test(rig);
      StepSettings settings{.dt = 1.0f / 60};
      const auto run = [&](float gravity, int count) {
        settings.environment.gravity = {gravity, 0, 0};
        for (int i = 0; i < count; ++i) EXPECT_EQ(test.hair.step(settings), Status::kOk);
      };
      run(9.81f, frames);
      EXPECT_GT(test.ends()[0].x, 0.09f) << "it lies against the wall";
      run(-9.81f, 12);
      return test.ends()[0].x;
    };
    EXPECT_LT(left(60), 0.085f);
    EXPECT_NEAR(left(60), left(600), 1e-4f);
  }
}

TEST(LaneContact, LeavesBonesAloneThatAreClear) {
  for (const ColliderShape shape : kShapes) {
    const TestRig rig = crossing_bones(shape, 7, 64);
    TestRig bald = rig;
    for (BoneRecord& bone : bald.bones) bone.colliders = 0;
    const std::vector<Vec3> ends = ends_after_a_step(rig, InstructionSet::kBest);
    const std::vector<Vec3> free = ends_after_a_step(bald, InstructionSet::kBest);
    int clear = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (!(gap_of(rig.colliders[0], segment_of(rig, i, free[i])) > 1e-5)) continue;
      ++clear;
      EXPECT_EQ(distance(ends[i], free[i]), 0.0f) << "shape " << int(shape) << ", bone " << i;
    }
    EXPECT_GT(clear, 8) << "shape " << int(shape);
  }
}

/// The `i`-th bone and its collider without the others.
TestRig alone(const TestRig& rig, std::size_t i) {
  TestRig single = rig;
  single.bones = {rig.bones[0], rig.bones[i + 1]};
  single.bones[1].chain = 0;
  single.dynamics = {rig.dynamics[0], rig.dynamics[i + 1]};
  return single;
}

TEST(LaneContact, NeighboursAndInstructionSetsChangeNoBit) {
  const Quat turns[] = {{}, turned_about({0, 0.6f, 0.8f}, 1.9)};  // the latter takes bones through the collider
  for (const ColliderShape shape : kShapes) {
    const TestRig rig = crossing_bones(shape, 11, 32);
    for (const Quat& turn : turns) {
      std::vector<Vec3> expected;
      for (std::size_t i = 0; i < rig.simulated_count(); ++i) {
        expected.push_back(ends_after_a_step(alone(rig, i), plainest_set(), turn)[0]);
      }
      for (const InstructionSet set : runnable_sets()) {
        for (const std::uint32_t instances : {1u, 17u}) {  // in rows by chains and by heads
          EXPECT_EQ(largest_distance(ends_after_a_step(rig, set, turn, instances), expected), 0.0f)
              << "shape " << int(shape) << ", " << name_of(set) << ", " << instances << " heads";
        }
      }
    }
  }
}

}  // namespace coif::contact_test
