// Explosions and hands: what changes the speed of hair between two steps.

#include "models/playback.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace coif::push_test {

constexpr const Solver* kSolvers[] = {&kCascadeSolver, &kPassiveSolver, &kThesisSolver, &kCharacterSolver};

bool same_bits(const Hair& a, std::uint32_t i, const Hair& b, std::uint32_t k) {
  const auto one = a.palette(i), other = b.palette(k);
  return one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size_bytes()) == 0;
}

/// Three bones of 10 cm that hang from the origin; nothing acts on them.
TestRig loose() {
  TestRig rig;
  TestBone bone{.length = 0.1f};
  bone.stiffness = 1;
  bone.damping = 0;
  rig.add_strand(3, bone);
  return rig;
}

float length_of(const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

StepSettings weightless(float dt = 1e-3f) {
  StepSettings settings{.dt = dt, .substeps = 1};
  settings.environment.gravity = {};
  return settings;
}

/// How fast the bones' ends go in the step after an impulse.
std::vector<Vec3> speeds_after(TestHair& test, const Impulse& impulse) {
  const auto before = test.ends();
  EXPECT_EQ(test.hair.push(0, impulse), Status::kOk);
  const auto pushed = test.ends();
  EXPECT_EQ(largest_distance(before, pushed), 0.0f) << "nothing is put elsewhere";
  EXPECT_EQ(test.hair.step(weightless()), Status::kOk);
  auto speeds = test.ends();
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    speeds[i] = {(speeds[i].x - before[i].x) * 1e3f, (speeds[i].y - before[i].y) * 1e3f,
                 (speeds[i].z - before[i].z) * 1e3f};
  }
  return speeds;
}

TEST(Impulse, AnExplosionFadesFromItsMiddleToItsEdge) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(loose(), {.solver = solver});
    // Beside the second bone's end: 0.5 m off, of a metre; straight to the side of it, so that all of it turns the
    // bone.
    const auto speeds = speeds_after(test, {.center = {-0.5, -0.2, 0}, .radius = 1, .speed = 4});
    EXPECT_NEAR(speeds[1].x, 2, solver == &kPassiveSolver ? 0.5 : 0.05);
    EXPECT_GT(speeds[0].x, 0.5f);
    EXPECT_GT(speeds[2].x, 0.5f);
    EXPECT_NEAR(speeds[1].z, 0, 1e-3);
  }
}

TEST(Impulse, BeyondItsRadiusIsNothing) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(loose(), {.solver = solver}), same(loose(), {.solver = solver});
    EXPECT_EQ(test.hair.push(0, {.center = {-0.5, -0.2, 0}, .radius = 0.49f, .speed = 400, .velocity = {5, 5, 5}}),
              Status::kOk);
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(test.hair.step({}) == Status::kOk && same.hair.step({}) == Status::kOk);
    EXPECT_TRUE(same_bits(test.hair, 0, same.hair, 0));
  }
}

TEST(Impulse, ACapsuleEndsAtBothOfItsEnds) {
  for (const Solver* const solver : kSolvers) {
    for (const float side : {-1.0f, 1.0f}) {  // the hair is 0.5 m beyond the one end, or beyond the other
      const double near = side < 0 ? -1 : 0.5;
      const Impulse beside{
          .center = {near, -0.2, 0}, .axis = {0.5f, 0, 0}, .radius = 0.45f, .speed = 4, .velocity = {1, 1, 1}};
      TestHair test(loose(), {.solver = solver});
      for (const Vec3& speed : speeds_after(test, beside)) EXPECT_LT(length_of(speed), 0.05f);
      Impulse through = beside;
      through.radius = 0.6f;
      float most = 0;
      for (const Vec3& speed : speeds_after(test, through)) most = std::max(most, length_of(speed));
      EXPECT_GT(most, 0.1f) << "or it reaches nothing at all";
    }
  }
}

TEST(Impulse, BeyondItsEndsACapsuleIsABall) {
  for (const Solver* const solver : kSolvers) {
    for (const float beyond : {1.02f, 1.08f, 2.0f}) {  // where the strand is along the axis
      TestHair ball(loose(), {.solver = solver}), far_end(loose(), {.solver = solver}),
          near_end(loose(), {.solver = solver});
      const float away = 0.5f * (beyond - 1);
      const double x = -double(away);
      const auto of_ball = speeds_after(ball, {.center = {x, -0.2, 0.1}, .radius = 1, .speed = 4});
      const auto of_far =
          speeds_after(far_end, {.center = {x - 0.5, -0.2, 0.1}, .axis = {0.5f, 0, 0}, .radius = 1, .speed = 4});
      const auto of_near =
          speeds_after(near_end, {.center = {x, -0.2, 0.1}, .axis = {-0.5f, 0, 0}, .radius = 1, .speed = 4});
      EXPECT_LT(largest_distance(of_ball, of_far), 1e-3f) << beyond;
      EXPECT_LT(largest_distance(of_ball, of_near), 1e-3f) << beyond;
      EXPECT_GT(length_of(of_ball[1]), 0.5f);
    }
  }
}

/// A hand that stands still in the world holds what it is around, though the head turns under it and takes the joints
/// along.
TEST(Impulse, AStrokeHoldsHairOfAHeadThatTurns) {
  TestRig rig;
  TestBone bone{.joint = {0.2f, 0, 0}, .length = 0.1f};
  bone.stiffness = 1;
  bone.damping = 0;
  rig.add(bone);
  for (const Solver* const solver : {&kCascadeSolver, &kPassiveSolver}) {
    TestHair test(rig, {.solver = solver});
    const auto turn_to = [&](int frame) {
      const HeadVelocity turning{{}, {0, 5, 0}};
      const HeadPose pose{{}, turned_about({0, 1, 0}, 5e-3 * frame)};
      if (frame == 1) {  // the hair goes along from the start
        ASSERT_EQ(test.hair.teleport(0, pose), Status::kOk);
      }
      ASSERT_EQ(test.hair.set_head(0, pose, turning), Status::kOk);
      ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
    };
    const auto place = [&](int frame) {  // of the tail, in the world
      const Vec3 end = test.ends()[0];
      const double c = std::cos(5e-3 * frame), s = std::sin(5e-3 * frame);
      return Vec3{float(c * double(end.x) + s * double(end.z)), end.y, float(c * double(end.z) - s * double(end.x))};
    };
    for (int frame = 1; frame <= 4; ++frame) turn_to(frame);
    Vec3 before = place(4);
    turn_to(5);
    Vec3 after = place(5);
    EXPECT_GT(length_of({after.x - before.x, after.y - before.y, after.z - before.z}), 4e-4f) << "it went along";
    ASSERT_EQ(test.hair.push(0, {.center = {0.2, -0.1, 0}, .radius = 100, .strokes = true}), Status::kOk);
    before = after;
    turn_to(6);
    after = place(6);
    EXPECT_LT(length_of({after.x - before.x, after.y - before.y, after.z - before.z}), 1.5e-4f);
  }
}

TEST(Impulse, ABlowAddsItsVelocity) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(loose(), {.solver = solver});
    // A capsule along the strand, so wide that all is near its middle.
    const auto speeds =
        speeds_after(test, {.center = {0, 0, 0}, .axis = {0, -0.3f, 0}, .radius = 1000, .velocity = {0, 0, 1.5f}});
    for (std::size_t i = 1; i < 3; ++i) EXPECT_NEAR(speeds[i].z, 1.5f, 0.05) << i;
  }
}

TEST(Impulse, AStrokeTakesHairAlongHoweverOftenItIsMade) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(loose(), {.solver = solver});
    const Impulse stroke{
        .center = {0, 0, 0}, .axis = {0, -0.3f, 0}, .radius = 1000, .velocity = {0, 0, 1}, .strokes = true};
    for (int i = 0; i < 5; ++i) ASSERT_EQ(test.hair.push(0, stroke), Status::kOk);
    const auto speeds = speeds_after(test, stroke);
    EXPECT_NEAR(speeds[2].z, 1, 0.05);
  }
}

/// Also under a head that moves and is turned, and in hair whose head is twice as large.
TEST(Impulse, IsOfTheWorldsMetres) {
  for (const Solver* const solver : kSolvers) {
    TestHair small(loose(), {.solver = solver}), large(loose(), {.solver = solver});
    const Quat turn = turned_about({0, 0, 1}, 0.5);
    ASSERT_EQ(small.hair.reset(0, {{1, 2, 3}, turn}), Status::kOk);
    ASSERT_EQ(large.hair.reset(0, {{2, 4, 6}, turn, 2}), Status::kOk);
    ASSERT_EQ(small.hair.push(0, {.center = {0.75, 1.75, 3}, .radius = 1, .speed = 2, .velocity = {1, 0, 1}}),
              Status::kOk);
    ASSERT_EQ(large.hair.push(0, {.center = {1.5, 3.5, 6}, .radius = 2, .speed = 4, .velocity = {2, 0, 2}}),
              Status::kOk);
    for (int i = 0; i < 10; ++i) {
      ASSERT_TRUE(small.hair.step(weightless()) == Status::kOk && large.hair.step(weightless()) == Status::kOk);
    }
    EXPECT_TRUE(same_bits(small.hair, 0, large.hair, 0));
    EXPECT_GT(largest_distance(small.ends(), loose().rest_ends()), 0.001f) << "it was felt";
  }
}

TEST(Impulse, StretchesNothing) {
  for (const Solver* const solver : {&kCascadeSolver, &kPassiveSolver, &kCharacterSolver}) {
    const TestRig rig = feature_rig();
    TestHair test(rig, {.solver = solver});
    for (int frame = 0; frame < 60; ++frame) {
      ASSERT_EQ(test.hair.set_head(0, wander(frame * 0.02)), Status::kOk);
      if (frame % 10 == 0) {
        const HeadPose at = wander(frame * 0.02);
        const auto& [x, y, z] = at.position;
        ASSERT_EQ(test.hair.push(0, {.center = {x + 0.1, y, z}, .radius = 0.5f, .speed = 30}), Status::kOk);
      }
      ASSERT_EQ(test.hair.step({}), Status::kOk);
      ASSERT_LT(worst_stretch(rig, test.ends()), 1e-5f);
    }
  }
}

TEST(Impulse, WakesAHeadThatItReachesAndNoOther) {
  for (const Solver* const solver : kSolvers) {
    TestRig rig = nine_bone_rig();
    TestHair test(rig, {.instances = 2, .solver = solver});
    for (int i = 0; i < 900; ++i) ASSERT_EQ(test.hair.step({.sleep_speed = 1e-3f}), Status::kOk);
    ASSERT_TRUE(test.hair.is_asleep(0) && test.hair.is_asleep(1));
    ASSERT_EQ(test.hair.push(0, {.center = {5, 0, 0}, .radius = 1, .speed = 9}), Status::kOk);
    EXPECT_TRUE(test.hair.is_asleep(0));
    ASSERT_EQ(test.hair.push(0, {.center = {1, 0, 0}, .radius = 5, .speed = 9}), Status::kOk);
    EXPECT_FALSE(test.hair.is_asleep(0));
    EXPECT_TRUE(test.hair.is_asleep(1));
  }
}

TEST(Impulse, IsTheSameBitsForOneHeadAndMany) {
  for (const Solver* const solver : kSolvers) {
    TestHair one(feature_rig(), {.instances = 1, .solver = solver}),
        many(feature_rig(), {.instances = 20, .solver = solver});
    for (int frame = 0; frame < 20; ++frame) {
      const HeadPose pose = wander(frame * 0.02);
      const Impulse impulse{
          .center = {pose.position[0], pose.position[1] - 0.2, pose.position[2]}, .radius = 0.4f, .speed = 1};
      for (TestHair* const test : {&one, &many}) {
        const std::uint32_t i = test == &one ? 0 : 13;
        ASSERT_EQ(test->hair.set_head(i, pose), Status::kOk);
        ASSERT_EQ(test->hair.push(i, impulse), Status::kOk);
        ASSERT_EQ(test->hair.step({}), Status::kOk);
      }
    }
    EXPECT_TRUE(same_bits(one.hair, 0, many.hair, 13));
  }
}

TEST(Impulse, BadArgumentsChangeNothing) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  for (const Solver* const solver : kSolvers) {
    TestHair test(loose(), {.solver = solver}), same(loose(), {.solver = solver});
    const Impulse good{.radius = 1, .speed = 1};
    std::vector<Impulse> bad(8, good);
    bad[0].center[1] = double(kNaN), bad[1].radius = 0, bad[2].radius = kNaN, bad[3].radius = kInfinity,
    bad[4].speed = kNaN;
    bad[5].velocity = {0, kInfinity, 0}, bad[6].axis = {kNaN, 0, 0}, bad[7].radius = -1;
    for (const Impulse& impulse : bad) EXPECT_EQ(test.hair.push(0, impulse), Status::kBadArgument);
    EXPECT_EQ(test.hair.push(1, good), Status::kBadIndex);
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(test.hair.step({}) == Status::kOk && same.hair.step({}) == Status::kOk);
    EXPECT_TRUE(same_bits(test.hair, 0, same.hair, 0));
  }
  EXPECT_EQ(Hair().push(0, {}), Status::kNotCreated);
}

/// Faster than a float can have it: such hair is put back into its rest pose.
TEST(Impulse, ThatIsFarTooStrongIsSurvived) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(loose(), {.solver = solver});
    for (const float speed : {1e10f, 1e30f, 3e38f}) {
      ASSERT_EQ(test.hair.push(0, {.center = {-0.1, -0.1, 0}, .radius = 1, .speed = speed, .velocity = {speed, 0, 0}}),
                Status::kOk);
      for (int i = 0; i < 3; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
      for (const Vec3& end : test.ends()) ASSERT_LT(std::abs(end.x) + std::abs(end.y) + std::abs(end.z), 1.0f);
    }
  }
}

}  // namespace coif::push_test
