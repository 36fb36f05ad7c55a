#include "motion/head_path.h"
#include "motion/motion_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <vector>

namespace coif::motion::clip_path_test {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kStep = 1.0e-4;  // seconds, of the differences

/// Uneven times, large turns about changing axes, a quaternion of the other sign, and one that is not unit.
std::vector<ClipKey> lively_keys() {
  std::vector<ClipKey> keys;
  const double times[] = {0.25, 0.4, 0.7, 0.75, 1.2, 1.3};
  for (std::size_t i = 0; i < std::size(times); ++i) {
    const double x = double(i);
    const Vector3d axis = Vector3d(1, std::sin(2 * x), std::cos(3 * x)).normalized();
    keys.push_back({times[i], Vector3d(std::sin(x), 0.3 * x, 0.1 * x * x), Quaterniond(AngleAxisd(0.9 * x, axis))});
  }
  keys[2].rotation.coeffs() *= -1;
  keys[3].rotation.coeffs() *= 3;
  return keys;
}

std::vector<ClipKey> sampled(Motion motion, double rate, double seconds) {
  const auto path = path_of(motion);
  std::vector<ClipKey> keys;
  for (int i = 0; i <= int(std::lround(seconds * rate)); ++i) {
    const HeadState state = path->at(i / rate);
    keys.push_back({i / rate, state.position, state.rotation});
  }
  return keys;
}

double apart(const Quaterniond& a, const Quaterniond& b) { return vector_of((a.conjugate() * b).normalized()).norm(); }

TEST(ClipPath, GoesThroughEveryKey) {
  const auto path = path_of(lively_keys());
  ASSERT_TRUE(path);
  for (const ClipKey& key : lively_keys()) {
    EXPECT_LT((path->at(key.seconds).position - key.position).norm(), 1e-12);
    EXPECT_LT(apart(path->at(key.seconds).rotation, key.rotation.normalized()), 1e-9) << key.seconds;
  }
}

TEST(ClipPath, DerivativesAreThoseOfItsPoses) {
  const auto path = path_of(lively_keys());
  ASSERT_TRUE(path);
  double fastest = 0;
  for (double t = 0.2513; t < 1.4; t += 0.0107) {
    const HeadState before = path->at(t - kStep, t), now = path->at(t), after = path->at(t + kStep, t);
    const Vector3d velocity = (after.position - before.position) / (2 * kStep);
    const Vector3d acceleration = (after.velocity - before.velocity) / (2 * kStep);
    const Vector3d turned = vector_of((after.rotation * before.rotation.conjugate()).normalized());
    const Vector3d spin_up = (after.angular_velocity - before.angular_velocity) / (2 * kStep);
    ASSERT_LT((now.velocity - velocity).norm(), 1e-5 * (10 + velocity.norm())) << t;
    ASSERT_LT((now.acceleration - acceleration).norm(), 1e-5 * (10 + acceleration.norm())) << t;
    ASSERT_LT((now.angular_velocity - turned / (2 * kStep)).norm(), 1e-4 * (1 + now.angular_velocity.norm())) << t;
    ASSERT_LT((now.angular_acceleration - spin_up).norm(), 1e-4 * (10 + spin_up.norm())) << t;
    fastest = std::max(fastest, now.angular_velocity.norm());
  }
  EXPECT_GT(fastest, 3) << "the keys turn too little to tell anything";
}

TEST(ClipPath, PoseAndVelocityMeetAtEveryKeyAndItRestsOutside) {
  const auto path = path_of(lively_keys());
  ASSERT_TRUE(path);
  for (const ClipKey& key : lively_keys()) {
    const double t = key.seconds;
    const HeadState left = path->at(t, t - 1e-6), right = path->at(t, t + 1e-6);
    EXPECT_LT((left.position - right.position).norm(), 1e-12) << t;
    EXPECT_LT(apart(left.rotation, right.rotation), 1e-9) << t;
    EXPECT_LT((left.velocity - right.velocity).norm(), 1e-9) << t;
    EXPECT_LT((left.angular_velocity - right.angular_velocity).norm(), 1e-9) << t;
  }
  for (const double t : {-1.0, 0.1, 1.5, 100.0}) {
    const HeadState state = path->at(t);
    const ClipKey key = t < 1 ? lively_keys().front() : lively_keys().back();
    EXPECT_EQ(state.position, key.position) << t;
    EXPECT_LT(apart(state.rotation, key.rotation), 1e-9) << t;
    for (const Vector3d& rate :
         {state.velocity, state.acceleration, state.angular_velocity, state.angular_acceleration}) {
      EXPECT_EQ(rate, Vector3d::Zero()) << t;
    }
  }
}

TEST(ClipPath, TakesTheShortestWayWhateverTheSigns) {
  const Quaterniond end(AngleAxisd(1.0, Vector3d::UnitX()));
  for (const double sign : {1.0, -1.0}) {
    Quaterniond signed_end = end;
    signed_end.coeffs() *= sign;
    const auto path = path_of({{.seconds = 0}, {.seconds = 1, .rotation = signed_end}});
    ASSERT_TRUE(path);
    EXPECT_NEAR(apart(path->at(0.5).rotation, Quaterniond::Identity()), 0.5, 1e-9) << sign;
  }
}

TEST(ClipPath, BreaksAtItsKeys) {
  const auto breaks = path_of(lively_keys())->breaks(1.2);
  ASSERT_EQ(breaks.size(), 5u);
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    EXPECT_EQ(breaks[i].seconds, lively_keys()[i].seconds);
    EXPECT_FALSE(breaks[i].jumps);
  }
  EXPECT_TRUE(path_of(std::vector<ClipKey>(1))->breaks(1).empty()) << "0 is no break";
}

TEST(ClipPath, IsTheMotionThatWasSampled) {
  for (const Motion motion : {Motion::kNod, Motion::kTurn, Motion::kRun}) {
    const auto exact = path_of(motion);
    const auto path = path_of(sampled(motion, 120, 3));
    ASSERT_TRUE(path);
    for (double t = 0.1; t < 2.9; t += 0.0107) {
      const HeadState a = exact->at(t), b = path->at(t);
      EXPECT_LT((a.position - b.position).norm(), 1e-5) << t;
      EXPECT_LT(apart(a.rotation, b.rotation), 1e-5) << t;
      EXPECT_LT((a.velocity - b.velocity).norm(), 5e-3) << t;
      EXPECT_LT((a.angular_velocity - b.angular_velocity).norm(), 3e-2) << t;
    }
  }
}

TEST(ClipPath, RefusesKeysThatMakeNoPath) {
  EXPECT_FALSE(path_of(std::vector<ClipKey>{}));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const auto spoil :
       {+[](ClipKey&key, double bad) { key.seconds = bad; }, +[](ClipKey&key, double bad) { key.position.y() = bad; },
        +[](ClipKey&key, double bad) { key.rotation.z() = bad; }}) {
    for (const double bad : {nan, infinity, -infinity}) {
      std::vector<ClipKey> keys = lively_keys();
      spoil(keys[3], bad);
      EXPECT_FALSE(path_of(keys));
    }
  }
  std::vector<ClipKey> keys = lively_keys();
  keys[2].seconds = keys[1].seconds + 0.5 * kLeastKeySpan;
  EXPECT_FALSE(path_of(keys)) << "too close";
  keys[2].seconds = keys[0].seconds;
  EXPECT_FALSE(path_of(keys)) << "backwards";
  keys = lively_keys();
  keys[0].seconds = -0.1;
  EXPECT_FALSE(path_of(keys)) << "before 0";
  keys = lively_keys();
  keys[4].rotation.coeffs().setZero();
  EXPECT_FALSE(path_of(keys)) << "no rotation";
}

TEST(RotationVector, IsInverseToItsRotationAndItsRateToItsSpin) {
  const Vector3d axis = Vector3d(1, -2, 0.5).normalized(), velocity(0.3, 1, -2);
  for (const double angle : {0.0, 1e-9, 1e-4, 0.03, 0.032, 1.0, 3.0, std::numbers::pi - 1e-6}) {
    const Vector3d vector = angle * axis;
    EXPECT_LT((vector_of(rotation_of(vector)) - vector).norm(), 1e-9) << angle;
    const Vector3d rate = rate_of(vector, velocity);
    EXPECT_LT((spin_of({vector, rate, Vector3d::Zero()}).velocity - velocity).norm(), 1e-8) << angle;
  }
}

}  // namespace coif::motion::clip_path_test
