#include "motion/head_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::motion::motion_test {

constexpr double kDegree = 3.14159265358979323846 / 180;

double angle(const Quat& a, const Quat& b) {
  const double x = a.w * b.x - a.x * b.w - a.y * b.z + a.z * b.y, y = a.w * b.y + a.x * b.z - a.y * b.w - a.z * b.x;
  const double z = a.w * b.z - a.x * b.y + a.y * b.x - a.z * b.w, w = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
  return 2 * std::atan2(std::hypot(x, y, z), std::fabs(w));
}

double way(const HeadPose& a, const HeadPose& b) {
  return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1], a.position[2] - b.position[2]);
}

template <typename Value>
double highest(Motion motion, Value value) {
  double best = -1e9;
  for (double t = 0; t < 10; t += 0.001) best = std::max(best, value(head_pose(motion, t)));
  return best;
}

double height(const HeadPose& pose) { return pose.position[1]; }
double turned(const HeadPose& pose) { return angle(pose.rotation, Quat{}); }

TEST(Motion, NamesFindTheirMotions) {
  ASSERT_EQ(all_motions().size(), 11u);
  for (std::size_t i = 0; i < all_motions().size(); ++i) {
    const MotionInfo& info = all_motions()[i];
    EXPECT_EQ(find_motion(info.name), info.motion) << info.name;
    EXPECT_EQ(std::size_t(info.motion), i) << "in the order of the enumerators";
    EXPECT_STREQ(name_of(info.motion), info.name);
  }
  EXPECT_FALSE(find_motion("stroll"));
  EXPECT_FALSE(find_motion(""));
}

TEST(Motion, StartsAtRestAtTheOrigin) {
  for (const MotionInfo& info : all_motions()) {
    for (const double t : {-1.0, 0.0}) {
      EXPECT_EQ(way(head_pose(info.motion, t), {}), 0) << info.name;
      EXPECT_EQ(turned(head_pose(info.motion, t)), 0) << info.name;
    }
    EXPECT_LT(way(head_pose(info.motion, 1e-3), {}), 1e-4) << info.name << " starts with a kick";
    EXPECT_LT(turned(head_pose(info.motion, 1e-3)), 1e-3) << info.name << " starts with a twist";
  }
}

TEST(Motion, RotationsAreUnit) {
  for (const MotionInfo& info : all_motions()) {
    for (double t = 0; t < 5; t += 0.01) {
      const Quat q = head_pose(info.motion, t).rotation;
      ASSERT_NEAR(std::hypot(std::hypot(q.x, q.y), std::hypot(q.z, q.w)), 1, 1e-6) << info.name;
    }
  }
}

TEST(Motion, VelocityIsContinuousExceptWhereTeleportJumps) {
  constexpr double h = 1e-3;
  for (const MotionInfo& info : all_motions()) {
    if (info.motion == Motion::kTeleport) continue;
    for (double t = h; t < 6; t += h) {
      const HeadPose a = head_pose(info.motion, t - h), b = head_pose(info.motion, t),
                     c = head_pose(info.motion, t + h);
      for (int axis = 0; axis < 3; ++axis) {
        const double kick = (c.position[axis] - 2 * b.position[axis] + a.position[axis]) / h;
        ASSERT_LT(std::fabs(kick), 0.2) << info.name << " at " << t;  // 200 m/s^2 for a millisecond
      }
      ASSERT_LT(angle(b.rotation, c.rotation), 0.02) << info.name << " at " << t;
    }
  }
}

TEST(Motion, NodAndTurnReachTheirAnglesAtTheirRates) {
  EXPECT_NEAR(highest(Motion::kNod, turned), 40 * kDegree, 0.5 * kDegree);
  EXPECT_NEAR(highest(Motion::kTurn, turned), 57 * kDegree, 0.5 * kDegree);
  EXPECT_LT(angle(head_pose(Motion::kNod, 5).rotation, head_pose(Motion::kNod, 5 + 1 / 0.77).rotation), 1e-5);
  EXPECT_LT(angle(head_pose(Motion::kTurn, 5).rotation, head_pose(Motion::kTurn, 5 + 1 / 1.54).rotation), 1e-5);
}

TEST(Motion, ChargeReachesItsSpeedAndKeepsIt) {
  for (const double t : {0.3, 1.0, 9.0}) {
    EXPECT_NEAR(way(head_pose(Motion::kCharge, t), head_pose(Motion::kCharge, t + 1)), 8, 1e-6);
  }
  EXPECT_NEAR(head_pose(Motion::kCharge, 0.3).position[2], 1.2, 1e-9);
}

TEST(Motion, RunBobsAndSways) {
  EXPECT_NEAR(highest(Motion::kRun, height), 0.06, 0.001);
  const double fastest = highest(Motion::kRun, [last = 0.0](const HeadPose& pose) mutable {
    const double speed = (pose.position[2] - last) / 0.001;
    last = pose.position[2];
    return speed;
  });
  EXPECT_NEAR(fastest, 3, 0.4);
}

TEST(Motion, JogBobsWithEachStepAndLeansWithEveryOther) {
  EXPECT_NEAR(highest(Motion::kJog, height), 0.045, 1e-4);
  EXPECT_NEAR(highest(Motion::kJog, turned), 1 * kDegree, 0.01 * kDegree);
  const HeadPose now = head_pose(Motion::kJog, 5.1), step = head_pose(Motion::kJog, 5.1 + 1 / 2.4);
  EXPECT_LT(way(now, step), 1e-6) << "each step is as high";
  EXPECT_LT(turned({.position = {}, .rotation = {0, 0, now.rotation.z + step.rotation.z, 1}}), 1e-5)
      << "and leans to the other side";
  EXPECT_GT(turned(now), 0.5 * kDegree);
  EXPECT_EQ(now.position[0], 0);
  EXPECT_EQ(now.position[2], 0);
}

TEST(Motion, JumpFliesFreelyAndComesBack) {
  EXPECT_NEAR(highest(Motion::kJump, height), 0.45, 0.001);
  EXPECT_NEAR(-highest(Motion::kJump, [](const HeadPose& pose) { return -height(pose); }), -0.25, 0.001);
  // Half way up the flight nothing but gravity acts.
  constexpr double t = 0.8, h = 0.01;
  const auto y = [](double seconds) { return height(head_pose(Motion::kJump, seconds)); };
  EXPECT_NEAR((y(t + h) - 2 * y(t) + y(t - h)) / (h * h), -9.81, 0.01);
}

TEST(Motion, TumbleGoesAllTheWayRound) {
  EXPECT_NEAR(highest(Motion::kTumble, height), 1, 1e-4);
  EXPECT_NEAR(highest(Motion::kTumble, turned), 180 * kDegree, 0.5 * kDegree);
  EXPECT_NEAR(turned(head_pose(Motion::kTumble, 0.9)), 0, 1e-5);
  // Forward: half way through the roll's first half, up has become forward (+Z).
  const Quat q = head_pose(Motion::kTumble, 0.2).rotation;
  EXPECT_GT(2 * (double(q.y) * q.z + double(q.x) * q.w), 0.5);
}

/// How high one of the head's axes points, 1 straight up.
double up(const HeadPose& pose, const Eigen::Vector3d& axis) {
  const Quat& q = pose.rotation;
  return (Eigen::Quaterniond(double(q.w), double(q.x), double(q.y), double(q.z)) * axis).y();
}

TEST(Motion, BowTurnsTheHeadBelowTheHorizontalAndComesUpAgain) {
  EXPECT_NEAR(highest(Motion::kBow, turned), 120 * kDegree, 0.5 * kDegree);
  const HeadPose bent = head_pose(Motion::kBow, 1);
  EXPECT_NEAR(up(bent, {0, 1, 0}), -0.5, 1e-3) << "hair falls over the face";
  EXPECT_GT(bent.position[2], 0.3) << "forwards";
  EXPECT_NEAR(turned(head_pose(Motion::kBow, 2.5)), 0, 1e-5);
  EXPECT_LT(angle(head_pose(Motion::kBow, 0.7).rotation, head_pose(Motion::kBow, 0.7 + 2.8).rotation), 1e-5);
}

TEST(Motion, LieEndsOnTheBack) {
  const HeadPose lying = head_pose(Motion::kLie, 1);
  EXPECT_NEAR(up(lying, {0, 0, 1}), 1, 1e-5) << "the face is up";
  EXPECT_EQ(way(lying, head_pose(Motion::kLie, 60)), 0);
}

TEST(Motion, TeleportJumpsTwice) {
  EXPECT_EQ(way(head_pose(Motion::kTeleport, 0.999), head_pose(Motion::kTeleport, 1.0)), 10);
  EXPECT_NEAR(angle(head_pose(Motion::kTeleport, 1.999).rotation, head_pose(Motion::kTeleport, 2.0).rotation),
              180 * kDegree, 1e-5);
  EXPECT_EQ(way(head_pose(Motion::kTeleport, 1.0), head_pose(Motion::kTeleport, 60)), 0);
}

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

constexpr double kAngle = -0.8, kTurnSeconds = 0.4;

class HeldTurnTest : public testing::Test {
 protected:
  [[nodiscard]] double angle_at(double seconds) const { return Eigen::AngleAxisd(path_->at(seconds).rotation).angle(); }
  const std::unique_ptr<HeadPath> path_ = held_turn(Eigen::Vector3d::UnitX(), kAngle, kTurnSeconds);
};

TEST_F(HeldTurnTest, GoesFromRestToItsAngleAndStays) {
  EXPECT_EQ(angle_at(0), 0);
  EXPECT_NEAR(angle_at(0.5 * kTurnSeconds), 0.5 * std::abs(kAngle), 1e-12);
  for (const double t : {kTurnSeconds, kTurnSeconds + 0.01, 30.0}) {
    EXPECT_NEAR(angle_at(t), std::abs(kAngle), 1e-12) << t;
    EXPECT_LT(path_->at(t, t).angular_velocity.norm(), 1e-12) << t;
  }
  EXPECT_EQ(path_->at(-1).angular_velocity.norm(), 0);
}

TEST_F(HeldTurnTest, NeverTurnsBack) {
  for (double t = 0.01; t < kTurnSeconds; t += 0.01) EXPECT_GT(angle_at(t), angle_at(t - 0.01)) << t;
}

TEST_F(HeldTurnTest, DerivativesAreThoseOfItsPoses) {
  constexpr double kShort = 1e-5;
  for (double t = 0.02; t < kTurnSeconds - 0.01; t += 0.03) {
    const HeadState before = path_->at(t - kShort), now = path_->at(t), after = path_->at(t + kShort);
    const double rate = std::copysign((angle_at(t + kShort) - angle_at(t - kShort)) / (2 * kShort), kAngle);
    EXPECT_NEAR(now.angular_velocity.x(), rate, 1e-5) << t;
    const Eigen::Vector3d spin_up = (after.angular_velocity - before.angular_velocity) / (2 * kShort);
    EXPECT_LT((now.angular_acceleration - spin_up).norm(), 1e-3) << t;
  }
}

TEST_F(HeldTurnTest, NeitherEndJerksTheHead) {
  for (const double end : {0.0, kTurnSeconds}) {
    for (const double t : {end + 1e-9, end - 1e-9}) {
      EXPECT_LT(path_->at(std::max(t, 0.0)).angular_acceleration.norm(), 1e-4) << t;
    }
  }
}

TEST_F(HeldTurnTest, BreaksWhereItStops) {
  EXPECT_TRUE(path_->breaks(kTurnSeconds - 0.01).empty());
  ASSERT_EQ(path_->breaks(1).size(), 1u);
  EXPECT_EQ(path_->breaks(1).front().seconds, kTurnSeconds);
  EXPECT_FALSE(path_->breaks(1).front().jumps);
}

TEST(HeldAttitude, PointsTheHeadsUpAxisThereAndTurnsNoFurtherThanItTakes) {
  for (int cell = 0; cell < 27; ++cell) {
    const Eigen::Vector3d up(cell / 9 - 1, cell / 3 % 3 - 1, cell % 3 - 1);
    if (up.isZero()) continue;
    const Eigen::Quaterniond turn(held_attitude(up)->at(kAttitudeSeconds + 1).rotation);
    EXPECT_LT((turn * Eigen::Vector3d::UnitY() - up.normalized()).norm(), 1e-12) << up.transpose();
    EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), std::acos(std::clamp(up.normalized().y(), -1.0, 1.0)), 1e-7)
        << up.transpose();
  }
}

}  // namespace coif::motion::motion_test
