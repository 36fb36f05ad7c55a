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

/// Hair with kCharacterSolver and room for four colliders.
class Character : public TestHair {
 public:
  explicit Character(const TestRig& rig, std::uint32_t instances = 1)
      : TestHair(rig, HairDesc{.instances = instances, .solver = &kCharacterSolver, .moving_colliders = 4}) {}

  void step(const std::vector<MovingCollider>& colliders, const StepSettings& settings) {
    ASSERT_EQ(hair.set_colliders(0, colliders), Status::kOk);
    ASSERT_EQ(hair.step(settings), Status::kOk);
  }
};

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
          // Within reach it takes the strand along, over its top or before it: the tip is not behind its middle. What
          // the hand went through would hang where it hung.
          const bool is_pushing = x > 0.0 && x < 0.08;
          if (is_pushing && double(ends[3].x) < x - 0.02) ++wrong;
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

/// Nothing but the one collider acts.
StepSettings calm_step() {
  StepSettings settings;
  settings.environment.gravity = {};
  return settings;
}

MovingCollider ball(double x, double y, double z, float radius) {
  MovingCollider sphere{.shape = ColliderShape::kSphere, .center = {x, y, z}};
  sphere.radius = radius;
  return sphere;
}

TEST(MovingColliders, OneThatAppearsInHairPutsItOutsideAndThrowsNothing) {
  for (const ChainModel model : kModels) {
    const TestRig rig = strand(model);
    Character test(rig);
    const MovingCollider sudden = ball(0.005, -0.1, -0.1, 0.04f);
    std::vector<Vec3> last = test.ends();
    for (int frame = 0; frame < 60; ++frame) {
      test.step({sudden}, calm_step());
      const auto ends = test.ends();
      EXPECT_LE(depth(rig, ends, sudden), kAllowed * 0.04) << name_of(model) << frame;
      if (frame > 0) {
        EXPECT_LT(largest_distance(ends, last) * 60, 2.0f) << name_of(model) << " m/s in frame " << frame;
      }
      last = ends;
    }
  }
}

TEST(MovingColliders, OneThatIsFarFromWhereItWasHasBeenPutThere) {
  for (const ChainModel model : kModels) {
    Character swept(strand(model)), put(strand(model));
    // Two metres in one step: through the strand, if there were a way.
    swept.step({ball(-1, -0.1, -0.1, 0.01f)}, calm_step());
    swept.step({ball(1, -0.1, -0.1, 0.01f)}, calm_step());
    put.step({}, calm_step());
    put.step({}, calm_step());
    EXPECT_EQ(largest_distance(swept.ends(), put.ends()), 0.0f);
  }
}

TEST(MovingColliders, HairBetweenHandAndHeadIsInNeither) {
  for (const ChainModel model : kModels) {
    const TestRig rig = strand(model);
    Character test(rig);
    const MovingCollider head = ball(0, 0, 0, 0.095f);
    double in_hand = 0, in_head = 0;
    for (int frame = 0; frame < 90; ++frame) {
      // From behind, until they overlap by half a centimetre.
      const double z = -0.25 + 0.002 * std::min(frame, 60);
      const MovingCollider hand = ball(0.01, -0.03, z, 0.04f);
      test.step({hand}, {});
      in_hand = std::max(in_hand, depth(rig, test.ends(), hand));
      in_head = std::max(in_head, depth(rig, test.ends(), head));
    }
    EXPECT_LE(in_hand, kAllowed * 0.04) << name_of(model);
    EXPECT_LE(in_head, kAllowed * 0.095) << name_of(model);
  }
}

TEST(MovingColliders, KeepHairsHitRadiusAway) {
  for (const ChainModel model : kModels) {
    const TestRig rig = strand(model, 0.004f);
    Character test(rig);
    for (int frame = 0; frame < 40; ++frame) {
      const MovingCollider hand = hands(-0.2 + 0.01 * frame, -0.06, -0.1)[std::size_t(frame / 10)];
      test.step({hand}, at_rate(60));
      EXPECT_LE(depth(rig, test.ends(), hand, 0.004f), kAllowed * 0.03) << name_of(model) << ' ' << frame;
    }
  }
}

TEST(MovingColliders, ScaleWithTheHeadTheyAreSeenFrom) {
  for (const ChainModel model : kModels) {
    Character own(strand(model)), twice(strand(model));
    for (int frame = 0; frame < 60; ++frame) {
      const double t = frame / 60.0;
      HeadPose pose = turn(t), larger = pose;
      for (double& metres : larger.position) metres *= 2;
      larger.scale = 2;
      MovingCollider hand = hands(-0.2 + 0.6 * t, -0.06, -0.1)[std::size_t(frame / 15)], large = hand;
      for (double& metres : large.center) metres *= 2;
      for (float* const metres : {&large.radius, &large.end_radius, &large.axis.x, &large.axis.y, &large.axis.z,
                                  &large.half_extents.x, &large.half_extents.y, &large.half_extents.z}) {
        *metres *= 2;
      }
      const StepSettings settings;
      ASSERT_EQ(own.hair.set_head(0, pose), Status::kOk);
      own.step({hand}, settings);
      ASSERT_EQ(twice.hair.set_head(0, larger), Status::kOk);
      twice.step({large}, settings);
    }
    const auto a = own.hair.palette(0), b = twice.hair.palette(0);
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size_bytes()), 0) << name_of(model);
  }
}

/// All matrices of 90 frames in which hands of every shape stroke every head of a crowd, each in its own way.
std::vector<Mat34> stroked(InstructionSet set, std::uint32_t instances, std::uint32_t asked) {
  const TestRig rig = feature_rig();
  HairDesc desc{.instances = instances, .solver = &kCharacterSolver, .instruction_set = set, .moving_colliders = 3};
  TestHair test(rig, desc);
  std::vector<Mat34> all;
  for (int frame = 0; frame < 90; ++frame) {
    for (std::uint32_t i = 0; i < instances; ++i) {
      const std::uint32_t own = instances == 1 ? asked : i;
      const double phase = 0.05 * frame * (1 + 0.1 * own);
      const auto shapes = hands(0.25 * (phase - std::floor(phase)) - 0.1, -0.1, -0.1);
      const std::vector<MovingCollider> mine(shapes.begin() + own % 3, shapes.begin() + own % 3 + 2);
      EXPECT_EQ(test.hair.set_colliders(i, mine), Status::kOk);
    }
    EXPECT_EQ(test.hair.step({.dt = frame % 7 == 0 ? 0.05f : 1.0f / 60}), Status::kOk);
    const auto palette = test.hair.palette(instances == 1 ? 0 : asked);
    all.insert(all.end(), palette.begin(), palette.end());
  }
  return all;
}

TEST(MovingColliders, MoveHairAlikeUnderEveryInstructionSetAndInEveryCrowd) {
  const std::vector<Mat34> alone = stroked(plainest_set(), 1, 5);
  const auto is_same = [&](const std::vector<Mat34>& other) {
    return alone.size() == other.size() && std::memcmp(alone.data(), other.data(), alone.size() * sizeof(Mat34)) == 0;
  };
  for (const InstructionSet set : runnable_sets()) {
    EXPECT_TRUE(is_same(stroked(set, 1, 5))) << name_of(set);
    EXPECT_TRUE(is_same(stroked(set, 33, 5))) << name_of(set);
  }
}

TEST(MovingColliders, OfNoRadiusAndNoLengthAreHarmless) {
  for (const ChainModel model : kModels) {
    const TestRig rig = strand(model);
    Character test(rig);
    for (int frame = 0; frame < 60; ++frame) {
      const double x = -0.1 + 0.004 * frame;
      MovingCollider point = ball(x, -0.1, -0.1, 0), line = point, plate = point, cone = point;
      line.shape = ColliderShape::kCapsule;
      line.axis = {};
      plate.shape = ColliderShape::kBox;
      cone.shape = ColliderShape::kTaperedCapsule;
      cone.axis = {0, 0.01f, 0};
      cone.end_radius = 0.02f;
      test.step({point, line, plate, cone}, {});
      for (const Vec3& end : test.ends()) EXPECT_TRUE(std::isfinite(end.x + end.y + end.z));
      EXPECT_LT(worst_stretch(rig, test.ends()), 1e-5f);
    }
  }
}

}  // namespace coif::moving_colliders_test
