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

}  // namespace coif::told_colliders_test
