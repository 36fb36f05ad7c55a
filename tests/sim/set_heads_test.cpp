// A whole crowd's heads at once, of which most stand.

#include "models/playback.h"
#include "models/test_rig.h"

#include <coif/hair.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace coif::set_heads_test {

constexpr std::uint32_t kHeads = 300;  // more than are compared at once

HeadPose place_of(std::uint32_t head) { return {{0.5 * head, 1.6, 0}, {}}; }

/// Heads that stand, except every seventh, which walks.
std::vector<HeadPose> poses_at(int frame) {
  std::vector<HeadPose> poses;
  for (std::uint32_t i = 0; i < kHeads; ++i) {
    HeadPose pose = place_of(i);
    if (i % 7 == 3) pose.position[2] = 0.02 * frame;
    poses.push_back(pose);
  }
  return poses;
}

bool same_bits(const TestHair& a, const TestHair& b, std::uint32_t head) {
  const auto one = a.hair.palette(head), other = b.hair.palette(head);
  return one.size() == other.size() && std::memcmp(one.data(), other.data(), one.size_bytes()) == 0;
}

TEST(SetHeads, DoesToTheBitWhatSetHeadDoesForEach) {
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    TestHair together(nine_bone_rig(), {.instances = kHeads, .solver = solver});
    TestHair each(nine_bone_rig(), {.instances = kHeads, .solver = solver});
    for (int frame = 0; frame < 240; ++frame) {
      const std::vector<HeadPose> poses = poses_at(frame < 60 || frame > 150 ? frame : 60);
      ASSERT_EQ(together.hair.set_heads(poses), Status::kOk);
      for (std::uint32_t i = 0; i < kHeads; ++i) ASSERT_EQ(each.hair.set_head(i, poses[i]), Status::kOk);
      ASSERT_EQ(together.hair.step({}), Status::kOk);
      ASSERT_EQ(each.hair.step({}), Status::kOk);
      for (std::uint32_t i = 0; i < kHeads; ++i) ASSERT_TRUE(same_bits(together, each, i)) << frame << ", head " << i;
    }
    for (std::uint32_t i = 0; i < kHeads; ++i) {
      EXPECT_EQ(together.hair.is_asleep(i), each.hair.is_asleep(i)) << i;
      EXPECT_FALSE(i % 7 == 3 && together.hair.is_asleep(i)) << i << " walks";
    }
  }
}

TEST(SetHeads, LeavesThoseAsleepThatStand) {
  TestHair test(nine_bone_rig(), {.instances = kHeads});
  const std::vector<HeadPose> poses = poses_at(0);
  for (int frame = 0; frame < 1200; ++frame) {
    ASSERT_EQ(test.hair.set_heads(poses), Status::kOk);
    ASSERT_EQ(test.hair.step({}), Status::kOk);
  }
  for (std::uint32_t i = 0; i < kHeads; ++i) ASSERT_TRUE(test.hair.is_asleep(i)) << i;
  std::vector<HeadPose> moved = poses;
  moved[299].position[1] += 0.01;
  ASSERT_EQ(test.hair.set_heads(moved), Status::kOk);
  for (std::uint32_t i = 0; i < kHeads; ++i) EXPECT_EQ(test.hair.is_asleep(i), i != 299) << i;
}

TEST(SetHeads, OfAnotherCountSetsNone) {
  TestHair test(nine_bone_rig(), {.instances = 3}), untouched(nine_bone_rig(), {.instances = 3});
  const HeadPose far{{1, 2, 3}, {}};
  for (const std::size_t count : {0u, 2u, 4u}) {
    EXPECT_EQ(test.hair.set_heads(std::vector<HeadPose>(count, far)), Status::kSizeMismatch) << count;
  }
  ASSERT_EQ(test.hair.step({}), Status::kOk);
  ASSERT_EQ(untouched.hair.step({}), Status::kOk);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_TRUE(same_bits(test, untouched, i));
  EXPECT_EQ(Hair().set_heads({}), Status::kNotCreated);
}

TEST(SetHeads, ABadPoseHoldsItsOwnHeadAlone) {
  TestHair test(nine_bone_rig(), {.instances = 3}), good(nine_bone_rig(), {.instances = 3});
  std::vector<HeadPose> poses{place_of(0), place_of(1), place_of(2)};
  poses[1].position[0] = std::numeric_limits<double>::quiet_NaN();
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(test.hair.set_heads(poses), Status::kBadPose) << "told again it is still bad";
    ASSERT_EQ(good.hair.set_head(0, place_of(0)), Status::kOk);
    ASSERT_EQ(good.hair.set_head(2, place_of(2)), Status::kOk);
    ASSERT_EQ(test.hair.step({}), Status::kOk);
    ASSERT_EQ(good.hair.step({}), Status::kOk);
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_TRUE(same_bits(test, good, i)) << i;
  }
}

// The same pose with a velocity and without are two things.
TEST(SetHeads, TakesBackAVelocityThatWasTold) {
  const HeadPose there{{0.1, 1.6, 0}, {}};
  const auto run = [&](bool takes_back, TestHair& test) {
    for (int frame = 0; frame < 5; ++frame) {
      ASSERT_EQ(test.hair.set_head(0, there, {{0, 0, 3}, {}}), Status::kOk);
      if (takes_back) {
        ASSERT_EQ(test.hair.set_heads(std::span(&there, 1)), Status::kOk);
      }
      ASSERT_EQ(test.hair.step({}), Status::kOk);
    }
  };
  TestHair told(nine_bone_rig()), taken_back(nine_bone_rig());
  run(false, told);
  run(true, taken_back);
  EXPECT_FALSE(same_bits(told, taken_back, 0));
}

}  // namespace coif::set_heads_test
