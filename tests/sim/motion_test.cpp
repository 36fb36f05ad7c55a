#include "motion/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

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
  ASSERT_EQ(all_motions().size(), 8u);
  for (const MotionInfo& info : all_motions()) EXPECT_EQ(find_motion(info.name), info.motion) << info.name;
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

TEST(Motion, TeleportJumpsTwice) {
  EXPECT_EQ(way(head_pose(Motion::kTeleport, 0.999), head_pose(Motion::kTeleport, 1.0)), 10);
  EXPECT_NEAR(angle(head_pose(Motion::kTeleport, 1.999).rotation, head_pose(Motion::kTeleport, 2.0).rotation),
              180 * kDegree, 1e-5);
  EXPECT_EQ(way(head_pose(Motion::kTeleport, 1.0), head_pose(Motion::kTeleport, 60)), 0);
}

}  // namespace
}  // namespace coif
