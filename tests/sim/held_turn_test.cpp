#include "motion/held_turn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

constexpr double kAngle = -0.8, kSeconds = 0.4;

class HeldTurnTest : public testing::Test {
 protected:
  [[nodiscard]] double angle_at(double seconds) const { return Eigen::AngleAxisd(path_->at(seconds).rotation).angle(); }
  const std::unique_ptr<HeadPath> path_ = held_turn(Eigen::Vector3d::UnitX(), kAngle, kSeconds);
};

TEST_F(HeldTurnTest, GoesFromRestToItsAngleAndStays) {
  EXPECT_EQ(angle_at(0), 0);
  EXPECT_NEAR(angle_at(0.5 * kSeconds), 0.5 * std::abs(kAngle), 1e-12);
  for (const double t : {kSeconds, kSeconds + 0.01, 30.0}) {
    EXPECT_NEAR(angle_at(t), std::abs(kAngle), 1e-12) << t;
    EXPECT_LT(path_->at(t, t).angular_velocity.norm(), 1e-12) << t;
  }
  EXPECT_EQ(path_->at(-1).angular_velocity.norm(), 0);
}

TEST_F(HeldTurnTest, NeverTurnsBack) {
  for (double t = 0.01; t < kSeconds; t += 0.01) EXPECT_GT(angle_at(t), angle_at(t - 0.01)) << t;
}

TEST_F(HeldTurnTest, DerivativesAreThoseOfItsPoses) {
  constexpr double kStep = 1e-5;
  for (double t = 0.02; t < kSeconds - 0.01; t += 0.03) {
    const HeadState before = path_->at(t - kStep), now = path_->at(t), after = path_->at(t + kStep);
    const double rate = std::copysign((angle_at(t + kStep) - angle_at(t - kStep)) / (2 * kStep), kAngle);
    EXPECT_NEAR(now.angular_velocity.x(), rate, 1e-5) << t;
    const Eigen::Vector3d spin_up = (after.angular_velocity - before.angular_velocity) / (2 * kStep);
    EXPECT_LT((now.angular_acceleration - spin_up).norm(), 1e-3) << t;
  }
}

TEST_F(HeldTurnTest, NeitherEndJerksTheHead) {
  for (const double end : {0.0, kSeconds}) {
    for (const double t : {end + 1e-9, end - 1e-9}) {
      EXPECT_LT(path_->at(std::max(t, 0.0)).angular_acceleration.norm(), 1e-4) << t;
    }
  }
}

TEST_F(HeldTurnTest, BreaksWhereItStops) {
  EXPECT_TRUE(path_->breaks(kSeconds - 0.01).empty());
  ASSERT_EQ(path_->breaks(1).size(), 1u);
  EXPECT_EQ(path_->breaks(1).front().seconds, kSeconds);
  EXPECT_FALSE(path_->breaks(1).front().jumps);
}

}  // namespace
}  // namespace coif
