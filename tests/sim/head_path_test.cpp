#include "motion/head_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double kSeconds = 6;
constexpr double kStep = 1.0e-4;  // of the differences

Vector3d spin_between(const HeadState& from, const HeadState& to, double dt) {
  const AngleAxisd turn(to.rotation * from.rotation.conjugate());
  return turn.axis() * (turn.angle() / dt);
}

/// Times well inside every smooth piece, and what is inside it.
std::vector<double> smooth_times(const HeadPath& path) {
  const std::vector<PathBreak> breaks = path.breaks(kSeconds);
  std::vector<double> times;
  for (double t = 0.013; t < kSeconds; t += 0.0317) {
    const auto is_near = [t](const PathBreak& end) { return std::fabs(end.seconds - t) < 2 * kStep; };
    if (std::ranges::none_of(breaks, is_near)) times.push_back(t);
  }
  return times;
}

class EveryPath : public testing::TestWithParam<MotionInfo> {
 protected:
  const std::unique_ptr<HeadPath> path_ = path_of(GetParam().motion);
};

TEST_P(EveryPath, DerivativesAreThoseOfItsPoses) {
  for (const double t : smooth_times(*path_)) {
    const HeadState before = path_->at(t - kStep), now = path_->at(t), after = path_->at(t + kStep);
    const Vector3d velocity = (after.position - before.position) / (2 * kStep);
    const Vector3d acceleration = (after.velocity - before.velocity) / (2 * kStep);
    const Vector3d angular_acceleration = (after.angular_velocity - before.angular_velocity) / (2 * kStep);
    ASSERT_LT((now.velocity - velocity).norm(), 1e-4) << t;
    ASSERT_LT((now.acceleration - acceleration).norm(), 2e-3) << t;
    ASSERT_LT((now.angular_velocity - spin_between(before, after, 2 * kStep)).norm(), 1e-4) << t;
    ASSERT_LT((now.angular_acceleration - angular_acceleration).norm(), 2e-3) << t;
  }
}

TEST_P(EveryPath, IsSmoothBetweenItsBreaks) {
  const std::vector<PathBreak> breaks = path_->breaks(kSeconds);
  for (double t = 0; t + 1e-3 < kSeconds; t += 1e-3) {
    const auto is_between = [t](const PathBreak& end) { return end.seconds >= t && end.seconds <= t + 1e-3; };
    if (std::ranges::any_of(breaks, is_between)) continue;
    const HeadState now = path_->at(t), next = path_->at(t + 1e-3);
    ASSERT_LT((next.acceleration - now.acceleration).norm(), 1.5) << t;  // m/s^2 within a millisecond
    ASSERT_LT((next.angular_acceleration - now.angular_acceleration).norm(), 2.0) << t;
  }
}

TEST_P(EveryPath, BreaksAscendAndBothSidesMeetUnlessItJumps) {
  double last = 0;
  for (const PathBreak& end : path_->breaks(kSeconds)) {
    EXPECT_GT(end.seconds, last);
    last = end.seconds;
    const HeadState left = path_->at(end.seconds, end.seconds - 1e-3),
                    right = path_->at(end.seconds, end.seconds + 1e-3);
    const double apart = (left.position - right.position).norm() + left.rotation.angularDistance(right.rotation);
    EXPECT_EQ(end.jumps, apart > 1e-6) << end.seconds;
    if (end.jumps) continue;
    EXPECT_LT((left.velocity - right.velocity).norm(), 1e-9) << end.seconds;
    const double kink = (left.acceleration - right.acceleration).norm() +
                        (left.angular_acceleration - right.angular_acceleration).norm();
    EXPECT_GT(kink, 0.1) << end.seconds << ": nothing breaks there";
  }
  EXPECT_LE(last, kSeconds);
}

TEST_P(EveryPath, IsWhatGamesAreGiven) {
  for (const double t : {-1.0, 0.0, 0.7, 1.0, 3.3}) {
    const HeadPose a = path_->pose(t), b = head_pose(GetParam().motion, t);
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(a.position[axis], b.position[axis]) << t;
    const HeadState state = path_->at(t);
    EXPECT_NEAR(state.rotation.w(), double(b.rotation.w), 1e-7) << t;
    EXPECT_NEAR(state.rotation.norm(), 1, 1e-12) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, EveryPath, testing::ValuesIn(all_motions().begin(), all_motions().end()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(HeadPath, OnlyTeleportJumps) {
  for (const MotionInfo& info : all_motions()) {
    const auto breaks = path_of(info.motion)->breaks(10);
    EXPECT_EQ(std::ranges::count_if(breaks, &PathBreak::jumps), info.motion == Motion::kTeleport ? 2 : 0) << info.name;
  }
}

}  // namespace
}  // namespace coif
