// Colliders of the game, which move against the head: what they promise whatever their shape and speed.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace coif::moving_colliders_test {

constexpr double kAllowed = 1e-4;  // depth, share of the radius

struct Point {
  double x, y, z;
};

Point minus(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double size(const Point& a) { return std::sqrt(dot(a, a)); }
Point at(const MovingCollider& c) { return {c.center[0], c.center[1], c.center[2]}; }
Point of(const Vec3& v) { return {v.x, v.y, v.z}; }

/// In the collider's own axes.
Point into(const MovingCollider& c, const Point& world) {
  const Point p = minus(world, at(c));
  const Quat q{-c.rotation.x, -c.rotation.y, -c.rotation.z, c.rotation.w};
  return of(rotated(q, {float(p.x), float(p.y), float(p.z)}));
}

/// Metres from a world point to the collider's surface, negative inside; nothing of the runtime.
double gap(const MovingCollider& c, const Point& world) {
  const Point p = into(c, world);
  switch (c.shape) {
    case ColliderShape::kSphere: return size(p) - c.radius;
    case ColliderShape::kPlane: return dot(p, of(c.axis)) / size(of(c.axis));
    case ColliderShape::kBox: {
      const Point over{std::fabs(p.x) - c.half_extents.x, std::fabs(p.y) - c.half_extents.y,
                       std::fabs(p.z) - c.half_extents.z};
      const Point out{std::max(over.x, 0.0), std::max(over.y, 0.0), std::max(over.z, 0.0)};
      return size(out) + std::min(std::max({over.x, over.y, over.z}), 0.0) - c.radius;
    }
    default: break;
  }
  // Capsules: the nearest of many balls.
  double least = std::numeric_limits<double>::infinity();
  const double end = c.shape == ColliderShape::kTaperedCapsule ? c.end_radius : c.radius;
  for (int i = 0; i <= 2000; ++i) {
    const double s = i / 2000.0;
    const Point ball{c.axis.x * s, c.axis.y * s, c.axis.z * s};
    least = std::min(least, size(minus(p, ball)) - (c.radius + (end - c.radius) * s));
  }
  return least;
}

/// The deepest that any bone is in, of those that start outside; metres. The head stands in the origin.
double depth(const TestRig& rig, const std::vector<Vec3>& ends, const MovingCollider& collider, float hit_radius = 0) {
  double deepest = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Point from = of(start_of(rig, ends, i)), to = of(ends[i]);
    if (gap(collider, from) < hit_radius - 1e-6) continue;
    for (int k = 0; k <= 200; ++k) {
      const double s = k / 200.0;
      const Point p{from.x + s * (to.x - from.x), from.y + s * (to.y - from.y), from.z + s * (to.z - from.z)};
      deepest = std::max(deepest, hit_radius - gap(collider, p));
    }
  }
  return deepest;
}

/// A strand of four bones of 6 cm that hangs beside the head, and a head sphere.
TestRig strand(ChainModel model, float hit_radius = 0) {
  TestRig rig;
  rig.model = model;
  TestBone bone{.joint = {0, 0.05f, -0.1f}, .rest_direction = {0, -1, 0}, .length = 0.06f};
  bone.stiffness = model == ChainModel::kPassive ? 60 : 120;
  bone.damping = 12;
  bone.friction = 1;
  bone.hit_radius = hit_radius;
  bone.torsion = kShortestArc;
  rig.add_strand(4, bone);
  rig.add_sphere({0, 0, 0}, 0.095f);
  return rig;
}

/// Of kCharacterSolver, with room for four colliders.
class Character : public TestHair {
 public:
  explicit Character(const TestRig& rig, std::uint32_t instances = 1)
      : TestHair(rig, HairDesc{.instances = instances, .solver = &kCharacterSolver, .moving_colliders = 4}) {}

  void step(const std::vector<MovingCollider>& colliders, const StepSettings& settings) {
    ASSERT_EQ(hair.set_colliders(0, colliders), Status::kOk);
    ASSERT_EQ(hair.step(settings), Status::kOk);
  }
};

/// Of the strand, to a place; head space.
Point nearest_point(const TestRig& rig, const std::vector<Vec3>& ends, const Point& place) {
  Point nearest{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Point from = of(start_of(rig, ends, i)), to = of(ends[i]);
    for (int k = 0; k <= 100; ++k) {
      const double s = k / 100.0;
      const Point p{from.x + s * (to.x - from.x), from.y + s * (to.y - from.y), from.z + s * (to.z - from.z)};
      const double apart = size(minus(p, place));
      if (apart < least) {
        least = apart;
        nearest = p;
      }
    }
  }
  return nearest;
}

/// A hand's shapes, all about 4 cm thick, with their middle at `place`.
std::vector<MovingCollider> hands(double x, double y, double z) {
  MovingCollider sphere{.shape = ColliderShape::kSphere, .center = {x, y, z}};
  sphere.radius = 0.04f;
  MovingCollider capsule{.shape = ColliderShape::kCapsule, .center = {x, y, z - 0.1}, .axis = {0, 0, 0.2f}};
  capsule.radius = 0.04f;
  MovingCollider tapered{.shape = ColliderShape::kTaperedCapsule, .center = {x, y, z - 0.1}, .axis = {0, 0, 0.2f}};
  tapered.radius = 0.045f;
  tapered.end_radius = 0.03f;
  MovingCollider box{.shape = ColliderShape::kBox, .center = {x, y, z}, .rotation = turned_about({0, 0, 1}, 0.3)};
  box.half_extents = {0.03f, 0.03f, 0.08f};
  box.radius = 0.01f;
  return {sphere, capsule, tapered, box};
}

StepSettings at_rate(float fps) {
  StepSettings settings;
  settings.dt = 1 / fps;
  return settings;
}

constexpr ChainModel kModels[] = {ChainModel::kCascade, ChainModel::kPassive};

const char* name_of(ChainModel model) { return model == ChainModel::kPassive ? "passive" : "cascade"; }

TEST(MovingColliders, AHandThroughHairLeavesNoBoneInsideAndNoneOnTheWrongSide) {
  for (const ChainModel model : kModels) {
    for (std::size_t shape = 0; shape < 4; ++shape) {
      for (const float fps : {24.0f, 30.0f, 60.0f, 144.0f}) {
        const TestRig rig = strand(model);
        Character test(rig);
        for (int frame = 0; frame < 60; ++frame) ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
        double deepest = 0;
        int wrong = 0;
        for (int frame = 0; frame < int(fps / 4); ++frame) {
          // From left to right, at 3 m/s, through where the strand hangs: x from -0.3 to 0.45.
          const double x = -0.3 + 3.0 / fps * frame;
          const MovingCollider hand = hands(x, -0.06, -0.1)[shape];
          test.step({hand}, at_rate(fps));
          const auto ends = test.ends();
          deepest = std::max(deepest, depth(rig, ends, hand));
          // While the hand is within reach, hair lies before it where it passes it.
          const bool is_pushing = x > 0.0 && x < 0.08;
          if (is_pushing && nearest_point(rig, ends, at(hand)).x < x) ++wrong;
        }
        EXPECT_LE(deepest, kAllowed * 0.03) << name_of(model) << ' ' << shape << ' ' << fps;
        EXPECT_EQ(wrong, 0) << name_of(model) << ' ' << shape << ' ' << fps;
      }
    }
  }
}

TEST(MovingColliders, NothingStretches) {
  for (const ChainModel model : kModels) {
    const TestRig rig = strand(model);
    Character test(rig);
    for (int frame = 0; frame < 120; ++frame) {
      const double x = 0.2 * std::sin(frame * 0.4);
      test.step({hands(x, -0.06, -0.1)[std::size_t(frame) % 4]}, at_rate(30));
      EXPECT_LT(worst_stretch(rig, test.ends()), 1e-5f);
    }
  }
}

TEST(MovingColliders, FarAwayTheyChangeNoBit) {
  for (const ChainModel model : kModels) {
    const TestRig rig = strand(model);
    Character with(rig), without(rig);
    for (int frame = 0; frame < 100; ++frame) {
      const HeadPose pose = nod(frame / 60.0);
      ASSERT_EQ(with.hair.set_head(0, pose), Status::kOk);
      ASSERT_EQ(without.hair.set_head(0, pose), Status::kOk);
      with.step({hands(2 + 0.1 * frame, 0, 0)[0]}, {});
      ASSERT_EQ(without.hair.step({}), Status::kOk);
    }
    const auto a = with.hair.palette(0), b = without.hair.palette(0);
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0) << name_of(model);
  }
}

TEST(MovingColliders, AreNotNeededByTheCharacterSolver) {
  const TestRig rig = feature_rig();
  for (const bool asks : {false, true}) {
    HairDesc desc{.instances = 3, .solver = &kCharacterSolver};
    if (asks) desc.moving_colliders = 3;
    if (asks) desc.follows_poses = true;
    TestHair plain(rig, HairDesc{.instances = 3}), character(rig, desc);
    for (int frame = 0; frame < 90; ++frame) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        ASSERT_EQ(plain.hair.set_head(i, wander(frame / 60.0 + i)), Status::kOk);
        ASSERT_EQ(character.hair.set_head(i, wander(frame / 60.0 + i)), Status::kOk);
      }
      ASSERT_EQ(plain.hair.step({}), Status::kOk);
      ASSERT_EQ(character.hair.step({}), Status::kOk);
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto a = plain.hair.palette(i), b = character.hair.palette(i);
      EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0);
    }
  }
}

}  // namespace coif::moving_colliders_test
