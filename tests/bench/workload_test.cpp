#include "bench/workload.h"

#include "bench/frame_times.h"
#include "bench/timed_crowd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace coif::workload_test {

TEST(Workload, BonesHangEndToEndOutsideTheSphere) {
  const AssetContents contents = crowd_contents({1, 5, 16});
  ASSERT_EQ(contents.bones.size(), 1u + 5 * 16);
  for (std::size_t b = 1; b < contents.bones.size(); ++b) {
    const BoneRecord& bone = contents.bones[b];
    EXPECT_FLOAT_EQ(bone.length, kBoneLength);
    const float* along = bone.rest_direction;
    EXPECT_NEAR(std::hypot(along[0], along[1], along[2]), 1, 1e-6);
    float end[3];
    for (int axis = 0; axis < 3; ++axis) end[axis] = bone.joint[axis] + bone.length * along[axis];
    EXPECT_GT(std::hypot(end[0], end[1], end[2]), kHeadRadius + contents.dynamics[b].hit_radius);
    if (b + 1 == contents.bones.size() || contents.bones[b + 1].parent != b) continue;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(contents.bones[b + 1].joint[axis], end[axis], 1e-6);
  }
}

TEST(Workload, HairIsStiffAtTheRootAndDampedEverywhere) {
  const AssetContents contents = crowd_contents(kOneHead);
  for (std::size_t b = 1; b + 1 < contents.bones.size(); ++b) {
    const DynamicsRecord& here = contents.dynamics[b];
    EXPECT_GE(here.damping + here.friction, 2 * std::sqrt(here.stiffness));
    if (contents.bones[b + 1].parent != b) continue;
    EXPECT_LT(contents.dynamics[b + 1].stiffness, here.stiffness);
  }
}

TEST(Workload, HeadsSwayAndTurnEachInItsPhase) {
  double widest = 0, most_turned = 0;
  for (int frame = 0; frame < 600; ++frame) {
    const HeadPose pose = head_pose_at(17, frame * kFrameSeconds);
    widest = std::max(widest, std::abs(pose.position[0] - 2 * (17 % 15)));
    most_turned = std::max(most_turned, 2 * std::acos(double(pose.rotation.w)));
    EXPECT_EQ(pose.position[2], 2);
  }
  EXPECT_NEAR(widest, 0.3, 1e-3);
  EXPECT_NEAR(most_turned, 1, 1e-2);
  EXPECT_NE(head_pose_at(0, 1).rotation.y, head_pose_at(1, 1).rotation.y);
}

TEST(TimedCrowd, EverySolverAndInstructionSetBearsTheWorkloads) {
  for (const CrowdShape& shape : {CrowdShape{7, kCrowd.chains, kCrowd.bones}, kOneHead}) {
    for (const std::string& solver : solver_names()) {
      for (const std::string& set : instruction_set_names()) {
        TimedCrowd crowd({shape, solver, set});
        for (int frame = 0; frame < 120; ++frame) crowd.plan(kFrameSeconds), crowd.set_heads(), crowd.step(1 / 60.0f);
        EXPECT_TRUE(crowd.is_sane()) << solver << " on " << set;
      }
    }
  }
}

TEST(TimedCrowd, RefusedStepsAreNotSane) {
  TimedCrowd crowd({CrowdShape{1, 1, 1}});
  crowd.step(-1);
  EXPECT_FALSE(crowd.is_sane());
}

TEST(FrameTimes, TheMedianIgnoresTheFrameThatWasInterrupted) {
  FrameTimes times;
  for (const double seconds : {3e-3, 1e-3, 2.0}) times.add(seconds);
  EXPECT_EQ(times.median_seconds(), 3e-3);
  EXPECT_EQ(FrameTimes{}.median_seconds(), 0);
}

}  // namespace coif::workload_test
