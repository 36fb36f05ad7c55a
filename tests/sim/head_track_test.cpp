// The smooth path that is made of a head's poses.

#include <coif/head_track.h>

#include "sim/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coif {
namespace {

Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec3 times(const Vec3& a, double s) { return {float(a.x * s), float(a.y * s), float(a.z * s)}; }
Vec3 plus(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

/// One sub-step, and when it ended.
struct Part {
  double from, to;
  HeadMove move;
};

/// The track over all frames, each in `count` parts.
std::vector<Part> parts_of(const HeadMotion& motion, const std::vector<double>& frames, std::uint32_t count) {
  HeadTrack track;
  EXPECT_EQ(track.reset(motion(0)), Status::kOk);
  std::vector<Part> parts;
  double last = 0;
  for (const double now : frames) {
    EXPECT_EQ(track.set_next(motion(now)), Status::kOk);
    track.begin(float(now - last));
    const double part = (now - last) / count;
    for (std::uint32_t i = 0; i < count; ++i)
      parts.push_back({last + i * part, last + (i + 1) * part, track.move(i, count)});
    track.finish();
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

TEST(HeadTrack, PassesThroughEveryPose) {
  for (const std::uint32_t count : {1u, 2u, 5u, 64u}) {
    const std::vector<double> frames = uneven_frames(1.0 / 240, 1.0 / 20, 3);
    const std::vector<Part> parts = parts_of(wander, frames, count);
    double last = 0;
    for (std::size_t f = 0; f < frames.size(); ++f) {
      const Part *first = &parts[f * count], *end = first + count;
      EXPECT_LT(angle_between(first->move.rotation_before, wander(last).rotation), 1e-6);
      EXPECT_LT(angle_between(end[-1].move.rotation, wander(frames[f]).rotation), 1e-6);
      Vec3 way;
      for (const Part* part = first; part != end; ++part) way = plus(way, part->move.displacement);
      EXPECT_LT(distance(way, minus(place(wander(frames[f])), place(wander(last)))), 5e-7f);
      last = frames[f];
    }
  }
}

TEST(HeadTrack, EachPartBeginsWhereTheLastEnded) {
  const std::vector<Part> parts = parts_of(wander, uneven_frames(1.0 / 240, 1.0 / 20, 3), 4);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    ASSERT_LT(angle_between(parts[i].move.rotation_before, parts[i - 1].move.rotation), 2e-6) << i;
  }
}

TEST(HeadTrack, VelocitiesAreThePathsOwnSlopesAndNeverJump) {
  const std::vector<Part> parts = parts_of(wander, even_frames(30, 3), 16);
  const double h = parts[0].to - parts[0].from;
  for (std::size_t i = 1; i + 1 < parts.size(); ++i) {
    const HeadMove &before = parts[i].move, &after = parts[i + 1].move;
    const Vec3 slope = times(plus(before.displacement, after.displacement), 0.5 / h);
    ASSERT_LT(distance(before.velocity, slope), 0.01f) << "m/s, where a polygon's jumps by 0.1, at " << parts[i].to;
    const double turn = angle_between(after.rotation, before.rotation_before);
    ASSERT_NEAR(distance(before.angular_velocity, {}), turn / (2 * h), 0.03)
        << "rad/s, where a polygon's jumps by 0.4, at " << parts[i].to;
  }
}

TEST(HeadTrack, AngularVelocityTurnsTheRotationWhereItsAxisTurnsToo) {
  const std::vector<Part> parts = parts_of(yaw_and_pitch, even_frames(10, 3), 64);
  const double h = parts[0].to - parts[0].from;
  for (std::size_t i = 64; i + 1 < parts.size(); ++i) {
    if (i % 64 > 61) continue;  // where frames meet, the acceleration jumps
    const Quat &from = parts[i].move.rotation_before, &to = parts[i + 1].move.rotation;
    const Quat turn = product(to, {-from.x, -from.y, -from.z, from.w});
    const Vec3 rate{float(turn.x / h), float(turn.y / h), float(turn.z / h)};  // half the angle, in twice the time
    ASSERT_LT(distance(parts[i].move.angular_velocity, rate), 0.02f) << parts[i].to;
  }
}

TEST(HeadTrack, ParabolasAreExactAtUnevenFrames) {
  const auto parabola = [](double t) {
    return HeadPose{{t * (3 - 2 * t), 4 * t * t, 1 - t}, turned_about({0, 0.6f, 0.8f}, t * (1.5 - t))};
  };
  const std::vector<double> frames = uneven_frames(1.0 / 240, 1.0 / 15, 1);
  for (const Part& part : parts_of(parabola, frames, 5)) {
    if (part.from < frames[2]) continue;  // three poses make a parabola, and the step from the third begins with it
    const double t = part.to;
    ASSERT_LT(distance(part.move.velocity, {float(3 - 4 * t), float(8 * t), -1}), 2e-3f) << t;
    ASSERT_LT(distance(part.move.displacement, minus(place(parabola(t)), place(parabola(part.from)))), 1e-6f) << t;
    ASSERT_LT(angle_between(part.move.rotation, parabola(t).rotation), 2e-6) << t;
    ASSERT_LT(distance(part.move.angular_velocity, times({0, 0.6f, 0.8f}, 1.5 - 2 * t)), 2e-3f) << t;
  }
}

/// Worst error of the velocity, or of the angular one, over a second of frames that begins after half of one.
double worst_velocity(const HeadMotion& motion, double fps) {
  double worst = 0;
  for (const Part& part : parts_of(motion, even_frames(fps, 1.5), 2)) {
    if (part.from > 0.5) worst = std::max(worst, double(distance(part.move.velocity, velocity(motion, part.to))));
  }
  return worst;
}
double worst_angular_velocity(double fps) {
  double worst = 0;
  for (const Part& part : parts_of(yaw_and_pitch, even_frames(fps, 1.5), 2)) {
    const double error = distance(part.move.angular_velocity, yaw_and_pitch_rate(part.to));
    if (part.from > 0.5) worst = std::max(worst, error);
  }
  return worst;
}

TEST(HeadTrack, VelocitiesAreOfSecondOrder) {
  for (const double fps : {24.0, 30.0, 60.0}) {
    EXPECT_LT(worst_velocity(wander, 2 * fps), 0.3 * worst_velocity(wander, fps)) << fps;
    EXPECT_LT(worst_angular_velocity(2 * fps), 0.3 * worst_angular_velocity(fps)) << fps;
  }
  EXPECT_LT(worst_velocity(wander, 240), 2e-3);
  EXPECT_LT(worst_angular_velocity(240), 1e-2);
}

TEST(HeadTrack, ADoubledFrameIsAHalt) {
  HeadTrack track;
  ASSERT_EQ(track.reset({}), Status::kOk);
  ASSERT_EQ(track.set_next({{0, 0, 1}, {}}), Status::kOk);
  for (int i = 0; i < 3; ++i) {
    track.begin(0.1f);
    track.finish();
  }
  EXPECT_LT(distance(track.here().velocity, {}), 1e-6f);
}

TEST(HeadTrack, JumpsKeepTheMotionInTheHeadsOwnDirections) {
  const HeadMotion glide = [](double t) { return HeadPose{{2 * t, t, 0}, turned_about({1, 0, 0}, 3 * t)}; };
  HeadTrack track;
  ASSERT_EQ(track.reset(glide(0)), Status::kOk);
  for (int i = 1; i <= 5; ++i) {
    ASSERT_EQ(track.set_next(glide(0.02 * i)), Status::kOk);
    track.begin(0.02f);
    track.finish();
  }
  const HeadMove before = track.here();
  const Quat turn = turned_about({0, 0.6f, 0.8f}, 1.1);
  ASSERT_EQ(track.set_next({{1e6, -7, 3}, product(turn, before.rotation)}), Status::kOk);
  EXPECT_LT(angle_between(track.jump(0), turn), 1e-6);
  const HeadMove after = track.here();
  EXPECT_LT(angle_between(after.rotation, product(turn, before.rotation)), 1e-6);
  EXPECT_LT(distance(after.velocity, rotated(turn, before.velocity)), 1e-5f);
  EXPECT_LT(distance(after.angular_velocity, rotated(turn, before.angular_velocity)), 1e-5f);
  EXPECT_EQ(track.pose().position[0], 1e6);
  // Gliding on from there is a motion without acceleration.
  const Vec3 way = rotated(turn, {0.04f, 0.02f, 0});
  const Quat step = turned_about(rotated(turn, {1, 0, 0}), 0.06);
  ASSERT_EQ(track.set_next({{1e6 + way.x, -7.0 + way.y, 3.0 + way.z}, product(step, after.rotation)}), Status::kOk);
  track.begin(0.02f);
  EXPECT_LT(distance(track.move(0, 1).velocity, after.velocity), 1e-4f);
  EXPECT_LT(distance(track.move(0, 1).angular_velocity, after.angular_velocity), 1e-4f);
}

TEST(HeadTrack, AJumpWithinAStepContinuesASteadyMotion) {
  const HeadMotion steady = [](double t) {
    return HeadPose{{3 * t, 4 * t, 1 - t}, turned_about({0, 0.6f, 0.8f}, 1.5 * t)};
  };
  HeadTrack stays, jumps;
  ASSERT_EQ(stays.reset(steady(0)), Status::kOk);
  ASSERT_EQ(jumps.reset(steady(0)), Status::kOk);
  double t = 0;
  for (const double dt : {0.03, 0.02, 0.04}) {
    t += dt;
    for (HeadTrack* track : {&stays, &jumps}) {
      ASSERT_EQ(track->set_next(steady(t)), Status::kOk);
      track->begin(float(dt));
      track->finish();
    }
  }
  const Quat turn = turned_about({0.8f, 0, 0.6f}, 2);
  const HeadPose next = steady(t + 0.025);
  ASSERT_EQ(stays.set_next(next), Status::kOk);
  ASSERT_EQ(jumps.set_next({{100, 200, 300}, product(turn, next.rotation)}), Status::kOk);
  EXPECT_LT(angle_between(jumps.jump(0.025f), turn), 1e-5);
  stays.begin(0.025f);
  jumps.begin(0.025f);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const HeadMove a = stays.move(i, 3), b = jumps.move(i, 3);
    EXPECT_LT(distance(b.displacement, rotated(turn, a.displacement)), 1e-5f);
    EXPECT_LT(distance(b.velocity, rotated(turn, a.velocity)), 1e-3f);
    EXPECT_LT(angle_between(b.rotation, product(turn, a.rotation)), 1e-5);
    EXPECT_LT(distance(b.angular_velocity, rotated(turn, a.angular_velocity)), 1e-3f);
  }
  jumps.finish();
  EXPECT_EQ(jumps.pose().position[2], 300);
}

TEST(HeadTrack, ResetsToRest) {
  HeadTrack track;
  ASSERT_EQ(track.set_next({{0, 0, 1}, {}}), Status::kOk);
  track.begin(0.1f);
  track.finish();
  ASSERT_GT(distance(track.here().velocity, {}), 1.0f);
  ASSERT_EQ(track.reset({{5, 6, 7}, turned_about({0, 1, 0}, 1)}), Status::kOk);
  EXPECT_EQ(distance(track.here().velocity, {}), 0.0f);
  EXPECT_EQ(track.distance(), 0.0);
  EXPECT_LT(track.angle(), 1e-6f);
  track.begin(0.1f);
  EXPECT_EQ(distance(track.move(0, 1).velocity, {}), 0.0f);
}

TEST(HeadTrack, RefusesBadPosesAndStaysAsItIs) {
  HeadTrack track;
  ASSERT_EQ(track.reset({{1, 2, 3}, {}}), Status::kOk);
  ASSERT_EQ(track.set_next({{1, 2, 5}, {}}), Status::kOk);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(track.set_next({{kNan, 0, 0}, {}}), Status::kBadPose);
  EXPECT_EQ(track.set_next({{}, {0, 0, 0, 0.9f}}), Status::kBadPose);
  EXPECT_EQ(track.reset({{}, {1, 1, 1, 1}}), Status::kBadPose);
  EXPECT_EQ(track.distance(), 2.0);
  EXPECT_EQ(track.pose().position[2], 3.0);
}

TEST(HeadTrack, MeasuresTheWayToTheNextPose) {
  HeadTrack track;
  ASSERT_EQ(track.set_next({{3, 0, 4}, turned_about({0, 1, 0}, -2)}), Status::kOk);
  EXPECT_EQ(track.distance(), 5.0);
  EXPECT_NEAR(track.angle(), 2.0f, 1e-6f);
  EXPECT_TRUE(track.can_move());
  ASSERT_EQ(track.set_next({{1e200, 0, 0}, {}}), Status::kOk);
  EXPECT_FALSE(track.can_move());
}

}  // namespace
}  // namespace coif
