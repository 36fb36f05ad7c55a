// The smooth path that is made of a head's poses. What hair does when its head jumps is in teleport_test.cpp.

#include "sim/lanes/lane_code.h"

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace coif::head_lanes_test {

Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 times(const Vec3& a, double s) { return {float(a.x * s), float(a.y * s), float(a.z * s)}; }
Vec3 plus(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// What the head does during one sub-step.
struct HeadPart {
  Quat rotation_before, rotation;
  Vec3 displacement, velocity, angular_velocity;
};

struct Part : HeadPart {
  double from, to;
};

constexpr std::uint32_t kLane = 11;  // of a block whose other heads stand still

/// One head among sixteen, with the code of one instruction set.
class HeadOnItsWay {
 public:
  HeadOnItsWay(InstructionSet set, const HeadPose& start) : code_(head_code(set)) {
    for (float& w : heads_.rotation.w.v) w = 1;
    for (float& w : heads_.next_rotation.w.v) w = 1;
    for (float& per_scale : heads_.per_scale.v) per_scale = 1;
    set_lane(heads_.rotation, kLane, start.rotation);
    last_ = start;
  }

  /// Moves on to `pose` in `count` parts.
  std::vector<Part> go(const HeadPose& pose, double from, double to, std::uint32_t count) {
    Vec3 way;
    way.x = float(pose.position[0] - last_.position[0]);
    way.y = float(pose.position[1] - last_.position[1]);
    way.z = float(pose.position[2] - last_.position[2]);
    set_lane(heads_.way, kLane, way);
    set_lane(heads_.next_rotation, kLane, pose.rotation);
    last_ = pose;
    StepParts parts;
    parts.dt = float(to - from);
    parts.count = count;
    parts.teleport_distance2 = parts.teleport_angle2 = std::numeric_limits<float>::infinity();
    HeadStepLanes step{};
    code_.look_ahead(heads_, kLanes, parts, step);
    code_.begin(heads_, kLanes, parts, step);
    std::vector<Part> made;
    MoveLanes move{};
    Lanes4 carried{};
    const double part = (to - from) / count;
    for (std::uint32_t i = 0; i < count; ++i) {
      code_.move(heads_, kLanes, step, parts, i, move, carried);
      made.push_back({{lane(move.rotation_before, kLane), lane(move.rotation, kLane), lane(move.way, kLane),
                       lane(move.velocity, kLane), lane(move.angular_velocity, kLane)},
                      from + i * part,
                      from + (i + 1) * part});
    }
    code_.finish(heads_, kLanes, step, Lanes{}, {});
    return made;
  }

 private:
  HeadCode code_;
  HeadLanes heads_{};
  HeadPose last_;
};

/// The path over all frames, each in `count` parts.
std::vector<Part> parts_of(const HeadMotion& motion, const std::vector<double>& frames, std::uint32_t count,
                           InstructionSet set = plainest_set()) {
  HeadOnItsWay head(set, motion(0));
  std::vector<Part> parts;
  double last = 0;
  for (const double now : frames) {
    for (const Part& part : head.go(motion(now), last, now, count)) parts.push_back(part);
    last = now;
  }
  return parts;
}

Vec3 place(const HeadPose& pose) { return {float(pose.position[0]), float(pose.position[1]), float(pose.position[2])}; }

/// Mean velocity and angular velocity of a motion around a time.
Vec3 velocity(const HeadMotion& motion, double t) {
  constexpr double kShort = 1e-4;
  Vec3 v;
  const HeadPose a = motion(t - kShort), b = motion(t + kShort);
  v.x = float((b.position[0] - a.position[0]) / (2 * kShort));
  v.y = float((b.position[1] - a.position[1]) / (2 * kShort));
  v.z = float((b.position[2] - a.position[2]) / (2 * kShort));
  return v;
}

/// Yaw and pitch at their own rates, and its exact angular velocity: about an axis that itself turns.
HeadPose yaw_and_pitch(double t) {
  return {{}, product(turned_about({0, 1, 0}, 0.8 * std::sin(3 * t)), turned_about({1, 0, 0}, 0.5 * std::sin(4 * t)))};
}
Vec3 yaw_and_pitch_rate(double t) {
  const Vec3 pitch = rotated(turned_about({0, 1, 0}, 0.8 * std::sin(3 * t)), {float(2 * std::cos(4 * t)), 0, 0});
  return plus({0, float(2.4 * std::cos(3 * t)), 0}, pitch);
}

TEST(HeadLanes, PassesThroughEveryPose) {
  for (const std::uint32_t count : {1u, 2u, 5u, 64u}) {
    const std::vector<double> frames = uneven_frames(1.0 / 240, 1.0 / 20, 3);
    const std::vector<Part> parts = parts_of(wander, frames, count);
    double last = 0;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const Part *first = &parts[f * count], *end = first + count;
      EXPECT_LT(angle_between(first->rotation_before, wander(last).rotation), 1e-6);
      EXPECT_LT(angle_between(end[-1].rotation, wander(frames[f]).rotation), 1e-6);
      Vec3 way;
      for (const Part* part = first; part != end; ++part) way = plus(way, part->displacement);
      EXPECT_LT(distance(way, minus(place(wander(frames[f])), place(wander(last)))), 5e-7f);
      last = frames[f];
    }
  }
}

TEST(HeadLanes, EachPartBeginsWhereTheLastEnded) {
  const std::vector<Part> parts = parts_of(wander, uneven_frames(1.0 / 240, 1.0 / 20, 3), 4);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    ASSERT_LT(angle_between(parts[i].rotation_before, parts[i - 1].rotation), 2e-6) << i;
  }
}

TEST(HeadLanes, VelocitiesAreThePathsOwnSlopesAndNeverJump) {
  const std::vector<Part> parts = parts_of(wander, even_frames(30, 3), 16);
  const double h = parts[0].to - parts[0].from;
  for (std::size_t i = 1; i + 1 < parts.size(); ++i) {
    const Part &before = parts[i], &after = parts[i + 1];
    const Vec3 slope = times(plus(before.displacement, after.displacement), 0.5 / h);
    ASSERT_LT(distance(before.velocity, slope), 0.01f) << "m/s, where a polygon's jumps by 0.1, at " << parts[i].to;
    const double turn = angle_between(after.rotation, before.rotation_before);
    ASSERT_NEAR(distance(before.angular_velocity, {}), turn / (2 * h), 0.03)
        << "rad/s, where a polygon's jumps by 0.4, at " << parts[i].to;
  }
}

TEST(HeadLanes, AngularVelocityTurnsTheRotationWhereItsAxisTurnsToo) {
  const std::vector<Part> parts = parts_of(yaw_and_pitch, even_frames(10, 3), 64);
  const double h = parts[0].to - parts[0].from;
  for (std::size_t i = 64; i + 1 < parts.size(); ++i) {
    if (i % 64 > 61) continue;  // where frames meet, the acceleration jumps
    const Quat &from = parts[i].rotation_before, &to = parts[i + 1].rotation;
    const Quat turn = product(to, {-from.x, -from.y, -from.z, from.w});
    const Vec3 rate{float(turn.x / h), float(turn.y / h), float(turn.z / h)};  // half the angle, in twice the time
    ASSERT_LT(distance(parts[i].angular_velocity, rate), 0.02f) << parts[i].to;
  }
}

// A head that was thrown round in a millisecond and then has fifty to come back flies on round and round at first.
TEST(HeadLanes, PathsOfSeveralTurnsInOneFrameTurnAsTheirRatesSay) {
  constexpr std::uint32_t kParts = 4096;
  const auto whirl = [](double t) { return HeadPose{{}, turned_about({0, 1, 0}, t > 5e-4 && t < 0.01 ? 2.9 : 0.0)}; };
  for (const InstructionSet set : runnable_sets()) {
    const std::vector<Part> parts = parts_of(whirl, {0.001, 0.051}, kParts, set);
    const double h = parts.back().to - parts.back().from;
    double turned = 0, farthest = 0;
    for (std::size_t i = kParts; i + 1 < parts.size(); ++i) {
      const Quat &from = parts[i].rotation_before, &to = parts[i + 1].rotation;
      const Quat turn = product(to, {-from.x, -from.y, -from.z, from.w});
      const double rate = std::atan2(double(turn.y), double(turn.w)) / h;  // half the angle, in twice the time
      ASSERT_NEAR(parts[i].angular_velocity.y, rate, 0.3 + 0.002 * std::fabs(rate)) << name_of(set) << ", part " << i;
      turned += double(parts[i].angular_velocity.y) * h;
      farthest = std::max(farthest, std::fabs(turned));
    }
    EXPECT_GT(farthest, 4 * 3.14159) << "or it was not several turns";
  }
}

TEST(HeadLanes, ParabolasAreExactAtUnevenFrames) {
  const auto parabola = [](double t) {
    return HeadPose{{t * (3 - 2 * t), 4 * t * t, 1 - t}, turned_about({0, 0.6f, 0.8f}, t * (1.5 - t))};
  };
  const std::vector<double> frames = uneven_frames(1.0 / 240, 1.0 / 15, 1);
  for (const Part& part : parts_of(parabola, frames, 5)) {
    if (part.from < frames[2]) continue;  // three poses make a parabola, and the step from the third begins with it
    const double t = part.to;
    ASSERT_LT(distance(part.velocity, {float(3 - 4 * t), float(8 * t), -1}), 2e-3f) << t;
    ASSERT_LT(distance(part.displacement, minus(place(parabola(t)), place(parabola(part.from)))), 1e-6f) << t;
    ASSERT_LT(angle_between(part.rotation, parabola(t).rotation), 2e-6) << t;
    ASSERT_LT(distance(part.angular_velocity, times({0, 0.6f, 0.8f}, 1.5 - 2 * t)), 2e-3f) << t;
  }
}

/// Worst error of the velocity, or of the angular one, over a second of frames that begins after half of one.
double worst_velocity(const HeadMotion& motion, double fps) {
  double worst = 0;
  for (const Part& part : parts_of(motion, even_frames(fps, 1.5), 2)) {
    if (part.from > 0.5) worst = std::max(worst, double(distance(part.velocity, velocity(motion, part.to))));
  }
  return worst;
}
double worst_angular_velocity(double fps) {
  double worst = 0;
  for (const Part& part : parts_of(yaw_and_pitch, even_frames(fps, 1.5), 2)) {
    const double error = distance(part.angular_velocity, yaw_and_pitch_rate(part.to));
    if (part.from > 0.5) worst = std::max(worst, error);
  }
  return worst;
}

TEST(HeadLanes, VelocitiesAreOfSecondOrder) {
  for (const double fps : {24.0, 30.0, 60.0}) {
    EXPECT_LT(worst_velocity(wander, 2 * fps), 0.3 * worst_velocity(wander, fps)) << fps;
    EXPECT_LT(worst_angular_velocity(2 * fps), 0.3 * worst_angular_velocity(fps)) << fps;
  }
  EXPECT_LT(worst_velocity(wander, 240), 2e-3);
  EXPECT_LT(worst_angular_velocity(240), 1e-2);
}

TEST(HeadLanes, ADoubledFrameIsAHalt) {
  HeadOnItsWay head(plainest_set(), {});
  const HeadPose there{{0, 0, 1}, turned_about({0, 1, 0}, 1)};
  for (int i = 0; i < 2; ++i) (void)head.go(there, 0.1 * i, 0.1 * (i + 1), 1);
  const Part last = head.go(there, 0.2, 0.3, 1)[0];
  EXPECT_LT(distance(last.velocity, {}), 1e-6f);
  EXPECT_LT(distance(last.angular_velocity, {}), 1e-6f);
}

/// Radians that a head which turns by `radians` in a step is told to have turned by.
double measured(InstructionSet set, const Vec3& axis, double radians) {
  HeadLanes heads{};
  set_lane(heads.rotation, kLane, Quat{});
  set_lane(heads.next_rotation, kLane, turned_about(axis, radians));
  HeadStepLanes step{};
  head_code(set).look_ahead(heads, kLanes, {}, step);
  return distance(lane(step.turn, kLane), {});
}

TEST(HeadLanes, TurnsOfEverySizeAreMeasuredExactly) {
  for (const InstructionSet set : runnable_sets()) {
    for (double radians = 1e-4; radians < 3.1415; radians += 0.003) {
      ASSERT_NEAR(measured(set, {0.36f, 0.8f, 0.48f}, radians), radians, 2e-6) << name_of(set);
      ASSERT_NEAR(measured(set, {0.36f, 0.8f, 0.48f}, 6.28318530718 - radians), radians, 2e-6) << "the shorter way";
    }
    EXPECT_EQ(measured(set, {1, 0, 0}, 0), 0.0) << name_of(set);
  }
}

TEST(HeadLanes, IsFarBeyondTheLimitsOfAMovement) {
  StepParts parts;
  parts.teleport_distance2 = 5 * 5;
  parts.teleport_angle2 = 2 * 2;
  const auto is_far = [&](const Vec3& way, double radians) {
    HeadLanes heads{};
    set_lane(heads.rotation, kLane, Quat{});
    set_lane(heads.next_rotation, kLane, turned_about({0, 1, 0}, radians));
    set_lane(heads.way, kLane, way);
    HeadStepLanes step{};
    const bool some_are_far = head_code(best_instruction_set()).look_ahead(heads, kLanes, parts, step);
    EXPECT_EQ(some_are_far, step.is_far.v[kLane] == 1.0f);
    return some_are_far;
  };
  EXPECT_FALSE(is_far({3, 0, 3.999f}, 0));
  EXPECT_TRUE(is_far({3, 0, 4.001f}, 0));
  EXPECT_FALSE(is_far({}, -1.999));
  EXPECT_TRUE(is_far({}, -2.001));
}

TEST(HeadLanes, EveryInstructionSetFindsTheSamePath) {
  const std::vector<double> frames = uneven_frames(1.0 / 240, 1.0 / 20, 2);
  for (const std::uint32_t count : {1u, 3u}) {
    const std::vector<Part> expected = parts_of(wander, frames, count);
    for (const InstructionSet set : runnable_sets()) {
      const std::vector<Part> found = parts_of(wander, frames, count, set);
      for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(std::memcmp(static_cast<const HeadPart*>(&found[i]), static_cast<const HeadPart*>(&expected[i]),
                              sizeof(HeadPart)),
                  0)
            << name_of(set) << " " << i;
      }
    }
  }
}

/// Sixteen heads of which each is still, turns, moves, has hair that moves or flies, in all combinations.
HeadLanes heads_that_may_rest(Lanes& motion) {
  HeadLanes heads{};
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    heads.per_scale.v[i] = 1;
    heads.quiet.v[i] = 0.5f;
    set_lane(heads.mean_velocity, i, {(i & 1u) != 0 ? 0.02f : 0.0f, 0, 0});
    set_lane(heads.mean_angular_velocity, i, {0, (i & 2u) != 0 ? 0.2f : 0.0f, 0});
    motion.v[i] = (i & 4u) != 0 ? 0.0002f : 0.0f;
    if ((i & 8u) != 0) motion.v[i] = (i & 4u) != 0 ? std::numeric_limits<float>::quiet_NaN() : 1e17f;
  }
  return heads;
}

TEST(HeadLanes, OnlyThoseAtRestForLongEnoughMaySleep) {
  for (const InstructionSet set : runnable_sets()) {
    for (const float sleep_after : {0.51f, 0.49f}) {
      Lanes motion;
      HeadLanes heads = heads_that_may_rest(motion);
      const RestWatch watch{0.005f, 0.0001f, sleep_after};  // a centimetre a second
      const RestingHeads resting = head_code(set).finish(heads, kLanes, HeadStepLanes{}, motion, watch);
      EXPECT_EQ(resting.may_sleep, sleep_after < 0.5f ? 1u : 0u) << name_of(set);
      EXPECT_EQ(resting.flies, 0xFF00u) << name_of(set);
      for (std::uint32_t i = 0; i < kLanes; ++i)
        EXPECT_EQ(heads.quiet.v[i], i == 0 ? 0.505f : 0.0f) << name_of(set) << " " << i;
    }
  }
}

TEST(HeadLanes, RestIsInMetresOfTheHair) {
  Lanes motion{};
  HeadLanes heads{};
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    heads.per_scale.v[i] = float(i);
    set_lane(heads.mean_velocity, i, {0, 0, 0.0022f});
  }
  const RestingHeads resting =
      head_code(best_instruction_set()).finish(heads, kLanes, HeadStepLanes{}, motion, {0.1f, 1e-4f, 0.1f});
  EXPECT_EQ(resting.may_sleep, 0x1Fu);  // four times as fast as in the world, not six times
}

}  // namespace coif::head_lanes_test
