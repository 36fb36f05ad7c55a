// What hosts tell of the game's colliders, and what that wakes: Hair::set_colliders().

#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coif::told_colliders_test {

class Character : public TestHair {
 public:
  Character() : TestHair(nine_bone_rig(), HairDesc{.solver = &kCharacterSolver, .moving_colliders = 4}) {}

  void step(const std::vector<MovingCollider>& colliders, const StepSettings& settings) {
    ASSERT_EQ(hair.set_colliders(0, colliders), Status::kOk);
    ASSERT_EQ(hair.step(settings), Status::kOk);
  }
};

MovingCollider ball(double x, double y, double z, float radius) {
  MovingCollider sphere{.shape = ColliderShape::kSphere, .center = {x, y, z}};
  sphere.radius = radius;
  return sphere;
}

TEST(ToldColliders, BadOnesChangeNothing) {
  Character test;
  test.step({ball(0.02, -0.1, -0.1, 0.04f)}, {});
  const auto before = test.memory_copy();
  const float nan = std::nanf(""), infinite = std::numeric_limits<float>::infinity();
  const auto refused = [&](const auto& change) {
    std::vector<MovingCollider> two(2, ball(0, 0, 0, 0.04f));
    change(two[1]);
    EXPECT_EQ(test.hair.set_colliders(0, two), Status::kBadArgument);
    EXPECT_EQ(test.memory_copy(), before);
  };
  refused([&](MovingCollider& c) { c.radius = nan; });
  refused([&](MovingCollider& c) { c.radius = -0.01f; });
  refused([&](MovingCollider& c) { c.radius = infinite; });
  refused([&](MovingCollider& c) { c.center[1] = double(nan); });
  refused([&](MovingCollider& c) { c.rotation = {0, 0, 0, 0}; });
  refused([&](MovingCollider& c) { c.axis.y = infinite; });
  refused([&](MovingCollider& c) { c.shape = ColliderShape(17); });
  refused([&](MovingCollider& c) { c.shape = ColliderShape::kEllipsoid; });  // of no size
  refused([&](MovingCollider& c) { c = {.shape = ColliderShape::kPlane, .axis = {}}; });
  refused([&](MovingCollider& c) { c.is_velocity_known = true, c.velocity.linear.x = nan; });
  EXPECT_EQ(test.hair.set_colliders(1, {}), Status::kBadIndex);
  EXPECT_EQ(test.hair.set_colliders(0, std::vector<MovingCollider>(5)), Status::kNotAsked);
  TestHair other(nine_bone_rig());
  EXPECT_EQ(other.hair.set_colliders(0, std::vector<MovingCollider>(1)), Status::kNotAsked);
  EXPECT_EQ(Hair::memory_need(test.asset, {.moving_colliders = 1}).bytes, 0u) << "kCoifSolver has none";
  EXPECT_EQ(Hair::memory_need(test.asset, {.solver = &kCharacterSolver, .moving_colliders = 17}).bytes, 0u);
}

/// From nothing to a thousand kilometres, whichever length it is.
TEST(ToldColliders, MayBeAsLargeAsTheLargestAndNoLarger) {
  Character test;
  const auto takes = [&](ColliderShape shape, const auto& length_of, float metres) {
    MovingCollider one{.shape = shape};
    one.half_extents = {1, 1, 1};
    one.radius = one.end_radius = 1;
    length_of(one) = metres;
    return test.hair.set_colliders(0, std::vector{one}) == Status::kOk;
  };
  const auto ends_at_the_largest = [&](ColliderShape shape, const auto& length_of) {
    const float largest = 1e6f;
    EXPECT_TRUE(takes(shape, length_of, largest)) << int(shape);
    EXPECT_FALSE(takes(shape, length_of, std::nextafter(largest, 2 * largest))) << int(shape);
    EXPECT_EQ(takes(shape, length_of, 0), shape != ColliderShape::kEllipsoid && shape != ColliderShape::kPlane);
  };
  ends_at_the_largest(ColliderShape::kSphere, [](MovingCollider& c) -> float& { return c.radius; });
  ends_at_the_largest(ColliderShape::kTaperedCapsule, [](MovingCollider& c) -> float& { return c.end_radius; });
  ends_at_the_largest(ColliderShape::kCapsule, [](MovingCollider& c) -> float& { return c.axis.y; });
  ends_at_the_largest(ColliderShape::kPlane, [](MovingCollider& c) -> float& { return c.axis.y; });
  for (const ColliderShape shape : {ColliderShape::kBox, ColliderShape::kEllipsoid}) {
    ends_at_the_largest(shape, [](MovingCollider& c) -> float& { return c.half_extents.x; });
    ends_at_the_largest(shape, [](MovingCollider& c) -> float& { return c.half_extents.y; });
    ends_at_the_largest(shape, [](MovingCollider& c) -> float& { return c.half_extents.z; });
  }
}

TEST(ToldColliders, WakeHairThatTheyReachAndNoOther) {
  Character test;
  const auto sleeps = [&] {
    for (int frame = 0; frame < 600 && !test.hair.is_asleep(0); ++frame) EXPECT_EQ(test.hair.step({}), Status::kOk);
    return test.hair.is_asleep(0);
  };
  ASSERT_TRUE(sleeps());
  ASSERT_EQ(test.hair.set_colliders(0, std::vector{ball(3, 0, 0, 0.04f)}), Status::kOk);
  EXPECT_TRUE(test.hair.is_asleep(0)) << "out of reach";
  ASSERT_EQ(test.hair.set_colliders(0, std::vector{ball(0.02, -0.1, -0.1, 0.04f)}), Status::kOk);
  EXPECT_FALSE(test.hair.is_asleep(0));
  ASSERT_TRUE(sleeps()) << "against it";
  ASSERT_EQ(test.hair.set_colliders(0, std::vector{ball(0.02, -0.1, -0.1, 0.04f)}), Status::kOk);
  EXPECT_TRUE(test.hair.is_asleep(0)) << "told again";
  ASSERT_EQ(test.hair.set_colliders(0, {}), Status::kOk);
  EXPECT_FALSE(test.hair.is_asleep(0)) << "it has gone";
}

/// World metres in front of a sleeping head within which something has to be told so that it wakes, to a millimetre;
/// `tell` says it there.
template <typename Tell>
double waking_distance(TestHair& test, const Tell& tell) {
  double near = 0, far = 100;
  while (far - near > 1e-3) {
    const double middle = 0.5 * (near + far);
    tell(1e4);
    for (int frame = 0; frame < 900 && !test.hair.is_asleep(0); ++frame) EXPECT_EQ(test.hair.step({}), Status::kOk);
    EXPECT_TRUE(test.hair.is_asleep(0));
    tell(middle);
    (test.hair.is_asleep(0) ? far : near) = middle;
  }
  return near;
}

/// The hair reaches so many times as far, what the game tells is as large as it says, and what hangs on a body grows
/// with it.
TEST(ToldColliders, WakeAScaledHeadWithinItsScaledReach) {
  TestRig rig = nine_bone_rig();
  rig.body_bones.push_back({0, {0, 0, 0}, {0, 0, 0, 1}});
  ColliderRecord sphere{};
  sphere.shape = ColliderShape::kSphere;
  sphere.rotation[3] = 1;
  for (float& radius : sphere.radii) radius = 0.25f;
  rig.body_colliders.push_back(sphere);
  const HairDesc desc{.solver = &kCharacterSolver, .moving_colliders = 1, .follows_body = true};
  double reach = 0;
  for (const double scale : {1.0, 4.0, 0.25}) {
    TestHair game(rig, desc), body(rig, desc);
    HeadPose head;
    head.scale = float(scale);
    for (TestHair* const test : {&game, &body}) ASSERT_EQ(test->hair.reset(0, head), Status::kOk);
    const double of_game = waking_distance(
        game, [&](double z) { ASSERT_EQ(game.hair.set_colliders(0, std::vector{ball(0, 0, z, 0.5f)}), Status::kOk); });
    const double of_body = waking_distance(body, [&](double z) {
      ASSERT_EQ(body.hair.set_body(0, std::vector{BodyPose{{0, 0, z}, {}}}), Status::kOk);
    });
    if (scale == 1.0) reach = of_game - 0.5;
    EXPECT_NEAR(of_game, scale * reach + 0.5, 6e-3) << scale;
    EXPECT_NEAR(of_body, scale * (reach + 0.25), 6e-3) << scale;
  }
  EXPECT_GT(reach, 0.1);
}

/// The same place in the list, another shape: it is another thing, which appears at rest.
TEST(ToldColliders, OfAnotherShapeThanBeforeHaveNoWayAndNoVelocity) {
  MovingCollider capsule{.shape = ColliderShape::kCapsule, .center = {0.02, -0.1, -0.1}, .axis = {0.02f, 0, 0}};
  capsule.radius = 0.04f;
  Character changes, appears;
  for (int frame = 0; frame < 3; ++frame) {
    changes.step({ball(0.62, -0.1, -0.1, 0.04f)}, {});
    appears.step({}, {});
    ASSERT_EQ(largest_distance(changes.ends(), appears.ends()), 0.0f) << "it touches nothing";
  }
  const auto before = appears.ends();
  for (int frame = 0; frame < 10; ++frame) {
    changes.step({capsule}, {});
    appears.step({capsule}, {});
    EXPECT_EQ(largest_distance(changes.ends(), appears.ends()), 0.0f) << frame;
  }
  EXPECT_GT(largest_distance(appears.ends(), before), 1e-3f) << "it pushes hair away";
}

}  // namespace coif::told_colliders_test
