// The first pose that a head is told puts it there: no hair is thrown, however far it is from the origin.

#include "models/playback.h"
#include "models/small_asset.h"
#include "models/test_rig.h"

#include <coif/hair.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

namespace coif::first_pose_test {

constexpr const Solver* kSolvers[] = {&kCascadeSolver, &kPassiveSolver, &kThesisSolver};

/// Hair that has been told nothing: unlike TestHair's.
class NewHair {
 public:
  explicit NewHair(const HairDesc& desc) : file_(write_asset(nine_bone_rig().contents())), memory_(memory_for(desc)) {
    EXPECT_EQ(hair.create(asset_, desc, memory_.bytes()), Status::kOk);
  }

  [[nodiscard]] std::vector<Vec3> ends(std::uint32_t head = 0) const {
    std::vector<Vec3> all(hair.bone_count());
    EXPECT_EQ(hair.bone_ends(head, all), Status::kOk);
    return {all.begin() + 1, all.end()};
  }

  Hair hair;

 private:
  AlignedBytes memory_for(const HairDesc& desc) {
    EXPECT_TRUE(asset_.open(file_.bytes()));
    return AlignedBytes(std::vector<std::byte>(Hair::memory_need(asset_, desc).bytes));
  }

  AlignedBytes file_;
  Asset asset_;
  AlignedBytes memory_;
};

const HeadPose kFar{{3, 1.6, -2.5}, turned_about({0, 1, 0}, 2)};

StepSettings weightless() {
  StepSettings settings;
  settings.environment.gravity = {};
  return settings;
}

/// Farthest that any bone end gets from where it was, in a quarter of a second.
float moved(NewHair& test, StepSettings settings) {
  const auto before = test.ends();
  float most = 0;
  for (int frame = 0; frame < 15; ++frame) {
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    most = std::max(most, largest_distance(test.ends(), before));
  }
  return most;
}

TEST(FirstPose, PutsTheHeadThere) {
  for (const Solver* const solver : kSolvers) {
    NewHair one({.solver = solver}), all({.instances = 20, .solver = solver});
    ASSERT_EQ(one.hair.set_head(0, kFar), Status::kOk);
    EXPECT_LT(moved(one, weightless()), 1e-5f);
    ASSERT_EQ(all.hair.set_heads(std::vector<HeadPose>(20, kFar)), Status::kOk);
    EXPECT_LT(moved(all, weightless()), 1e-5f);
  }
}

TEST(FirstPose, WhatComesThenIsMovement) {
  for (const Solver* const solver : kSolvers) {
    NewHair test({.solver = solver});
    ASSERT_EQ(test.hair.set_head(0, kFar), Status::kOk);
    EXPECT_LT(moved(test, weightless()), 1e-5f);
    HeadPose next = kFar;
    next.position[0] += 0.3;
    ASSERT_EQ(test.hair.set_head(0, next), Status::kOk);
    EXPECT_GT(moved(test, weightless()), 0.01f);
  }
}

TEST(FirstPose, IsWhereTheHeadIsToldToStandEvenIfThatIsTheOrigin) {
  for (const Solver* const solver : kSolvers) {
    NewHair test({.solver = solver});
    ASSERT_EQ(test.hair.set_head(0, {}), Status::kOk);
    ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
    ASSERT_EQ(test.hair.set_head(0, {{0, 0, 0.3}, {}}), Status::kOk);
    EXPECT_GT(moved(test, weightless()), 0.01f);
  }
}

TEST(FirstPose, UntilTheNextStepAnyOtherDoesTheSame) {
  NewHair test({});
  ASSERT_EQ(test.hair.set_head(0, {{1, 0, 0}, {}}), Status::kOk);
  ASSERT_EQ(test.hair.set_head(0, kFar), Status::kOk);
  EXPECT_LT(moved(test, weightless()), 1e-5f);
}

TEST(FirstPose, OfHairThatHungBeforeKeepsItsShape) {
  for (const Solver* const solver : kSolvers) {
    NewHair test({.solver = solver}), stays({.solver = solver});
    for (int frame = 0; frame < 40; ++frame) {
      ASSERT_EQ(test.hair.step({}), Status::kOk);
      ASSERT_EQ(stays.hair.step({}), Status::kOk);
    }
    ASSERT_EQ(test.hair.set_head(0, {{4, 0, 0}, {}}), Status::kOk);
    ASSERT_EQ(test.hair.step({}), Status::kOk);
    ASSERT_EQ(stays.hair.step({}), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), stays.ends()), 1e-5f);
  }
}

TEST(FirstPose, WakesAHeadThatSleptAndPutsItThere) {
  NewHair test({});
  for (int frame = 0; frame < 900; ++frame) ASSERT_EQ(test.hair.step({}), Status::kOk);
  ASSERT_TRUE(test.hair.is_asleep(0));
  ASSERT_EQ(test.hair.set_head(0, {{4, 0, 0}, {}}), Status::kOk);
  EXPECT_FALSE(test.hair.is_asleep(0));
  EXPECT_LT(moved(test, {}), 1e-4f);
}

TEST(FirstPose, IsOneWhereAnotherWasRefused) {
  NewHair test({.instances = 2});
  HeadPose bad = kFar;
  bad.scale = 0;
  EXPECT_EQ(test.hair.set_head(0, bad), Status::kBadScale);
  const HeadPose both[] = {kFar, bad};
  EXPECT_EQ(test.hair.set_heads(both), Status::kBadScale);
  EXPECT_LT(moved(test, weightless()), 1e-5f);
}

TEST(FirstPose, AfterAResetIsMovement) {
  NewHair test({});
  ASSERT_EQ(test.hair.reset(0, {}), Status::kOk);
  ASSERT_EQ(test.hair.set_head(0, {{0, 0, 0.3}, {}}), Status::kOk);
  EXPECT_GT(moved(test, weightless()), 0.01f);
}

TEST(FirstPose, OfASavedCrowdIsStillTheFirst) {
  NewHair test({}), other({});
  std::vector<std::byte> state(test.hair.saved_bytes());
  ASSERT_EQ(test.hair.save(state), Status::kOk);
  ASSERT_EQ(other.hair.reset(0, {}), Status::kOk);
  ASSERT_EQ(other.hair.restore(state), Status::kOk);
  ASSERT_EQ(other.hair.set_head(0, kFar), Status::kOk);
  EXPECT_LT(moved(other, weightless()), 1e-5f);
}

/// A head that flies and turns steadily from the first pose on: its hair is at rest against it, as if that had always
/// been so.
void expect_goes_along(const Solver* solver, const HeadVelocity& velocity, float tolerance) {
  NewHair test({.solver = solver});
  const auto before = test.ends();
  StepSettings settings = weightless();
  settings.environment.air_follow = 1;
  for (int frame = 0; frame < 6; ++frame) {
    const double t = frame / 60.0;
    const HeadPose pose{{3 + double(velocity.linear.x) * t, 1, double(velocity.linear.z) * t},
                        turned_about({0, 1, 0}, double(velocity.angular.y) * t)};
    ASSERT_EQ(test.hair.set_head(0, pose, velocity), Status::kOk);
    ASSERT_EQ(test.hair.step(settings), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), before), tolerance) << frame;
  }
}

TEST(FirstPose, WithAVelocityHasItFromTheStart) {
  for (const Solver* const solver : {&kCascadeSolver, &kPassiveSolver}) {
    expect_goes_along(solver, {{4, 0, -3}, {}}, 2e-3f);
    expect_goes_along(solver, {{}, {0, 1, 0}}, 2e-3f);
  }
  expect_goes_along(&kThesisSolver, {{0.4f, 0, -0.3f}, {}}, 2e-3f);
}

/// Bones at a right angle to the axis are not left behind where the head begins to turn: a step at 2 rad/s would leave
/// them 5 mm.
TEST(FirstPose, WithAnAngularVelocityTakesBonesAlong) {
  for (const Solver* const solver : kSolvers) {
    NewHair test({.solver = solver});
    const auto before = test.ends();
    ASSERT_EQ(test.hair.set_head(0, {{}, turned_about({1, 0, 0}, 0.5)}, {{}, {2, 0, 0}}), Status::kOk);
    ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), before), 5e-4f);
  }
}

TEST(FirstPose, OfATeleportWithAVelocityHairGoesOnAsItWas) {
  for (const Solver* const solver : {&kCascadeSolver, &kPassiveSolver}) {
    NewHair test({.solver = solver});
    ASSERT_EQ(test.hair.set_head(0, {}), Status::kOk);
    for (int frame = 0; frame < 60; ++frame) ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
    const auto before = test.ends();
    ASSERT_EQ(test.hair.teleport(0, kFar), Status::kOk);
    ASSERT_EQ(test.hair.set_head(0, kFar, {{5, 0, 0}, {}}), Status::kOk);
    ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), before), 1e-3f);
  }
}

TEST(BadScale, IsNamed) {
  EXPECT_NE(std::strstr(describe(Status::kBadScale), "scale"), nullptr);
  EXPECT_EQ(std::strstr(describe(Status::kBadPose), "scale"), nullptr);
}

}  // namespace coif::first_pose_test
