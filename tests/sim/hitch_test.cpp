// Frames that take long, and frames in which no time passes.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::hitch_test {

constexpr float kLength = 0.3f;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
const float kHitches[] = {0.11f, 0.25f, 0.5f, 0.6f, 1.0f, 3.0f, 100.0f};

TestRig rig() {
  TestRig rig = calm_strand(4, kLength);
  rig.add_sphere({0, 0, 0}, 0.115f);
  return rig;
}

/// Sixty frames a second, with one of `hitch` seconds after three seconds, then one second more.
std::vector<double> frames_with(double hitch) {
  std::vector<double> frames = even_frames(60, 3);
  frames.push_back(3 + hitch);
  for (const double later : even_frames(60, 1)) frames.push_back(3 + hitch + later);
  return frames;
}

/// How far any bone's end is at most from where it was just before the hitch, metres.
float largest_swing(TestHair& test, const HeadMotion& motion, float hitch, const StepSettings& settings) {
  const Playback take = play(test, motion, frames_with(double(hitch)), settings);
  float worst = 0;
  for (std::size_t i = 180; i < take.ends.size(); ++i) {
    worst = std::max(worst, largest_distance(take.ends[i], take.ends[179]));
  }
  return worst;
}

HeadPose glide(double t) { return {{5 * t, 0, 0}, {}}; }

/// A runner's circle: 5 m/s, 1 radian a second.
HeadPose circle(double t) { return {{5 * std::sin(t), 0, 5 * std::cos(t)}, turned_about({0, 1, 0}, t)}; }

TEST(Hitch, AtASteadySpeedMovesNoHair) {
  for (const float teleport : {5.0f, kInfinity}) {  // noticed as a jump, or believed
    for (const float hitch : kHitches) {
      TestHair test(rig());
      EXPECT_LT(largest_swing(test, glide, hitch, {.teleport_distance = teleport}), 1e-4f) << hitch << " s";
    }
  }
  TestRig stiff = rig();  // so that Algorithm 1 has come to rest in three seconds
  for (DynamicsRecord& bone : stiff.dynamics) bone.resistance = 0.3f;
  TestHair thesis(stiff, HairDesc{.solver = &kThesisSolver});
  StepSettings weightless;  // Algorithm 1 sags by more in longer steps
  weightless.environment.gravity = {};
  EXPECT_LT(largest_swing(thesis, glide, 0.25f, weightless), 1e-3f);
}

TEST(Hitch, OnACircleThrowsNoHair) {
  for (const auto& [hitch, share] : {std::pair{0.11f, 0.005f}, {0.25f, 0.02f}, {0.5f, 0.1f}}) {
    TestHair test(rig());
    EXPECT_LT(largest_swing(test, circle, hitch, {}), share * kLength) << hitch << " s";
  }
}

TEST(Hitch, FollowsTheMotionOfItsTime) {
  for (const HeadMotion& motion : {HeadMotion(nod), HeadMotion(turn), HeadMotion(run)}) {
    const Playback fine = play(rig(), motion, even_frames(60, 4.25));
    const Playback hitched = play(rig(), motion, frames_with(0.25));
    EXPECT_LT(rms_tip_difference(hitched, fine), 0.05 * kLength);
    EXPECT_GT(rms_tip_difference(play(rig(), still, even_frames(60, 4.25)), fine), 0.03 * kLength)
        << "or there was nothing to follow";
  }
}

HeadPose spin(double t) { return {{0, 0, 0}, turned_about({0, 1, 0}, 6 * t)}; }

TEST(Hitch, AHeadThatWasHeldStopsAsIfItHadStopped) {
  for (const HeadMotion& motion : {HeadMotion(glide), HeadMotion(spin)}) {
    const HeadMotion held = until(3, motion);
    TestHair hitched(rig()), smooth(rig());
    const float swing = largest_swing(hitched, held, 0.25f, {});
    const float usual = largest_swing(smooth, held, 1.0f / 60, {});
    EXPECT_GT(usual, 0.02f) << "or it had not moved";
    EXPECT_LT(swing, usual);
  }
}

/// How far any bone's end is at most from where frames of 1/600 s instead of the hitch would have it, metres.
float largest_distance_from_fine(const HeadMotion& motion, double hitch) {
  std::vector<double> frames = even_frames(60, 3);
  for (const double later : even_frames(600, hitch)) frames.push_back(3 + later);
  const std::size_t end = frames.size() - 1;
  for (const double later : even_frames(60, 1)) frames.push_back(3 + hitch + later);
  const Playback fine = play(rig(), motion, frames), hitched = play(rig(), motion, frames_with(hitch));
  float worst = 0;
  for (std::size_t i = 0; end + i < fine.ends.size(); ++i) {
    worst = std::max(worst, largest_distance(hitched.ends[180 + i], fine.ends[end + i]));
  }
  return worst;
}

TEST(Hitch, AHeadThatWasHeldIsNotTakenToFlyBack) {
  // That it stopped at once or halfway is not known; that it turned round at full speed would be made up.
  for (const double hitch : {0.25, 0.5}) {
    EXPECT_LT(largest_distance_from_fine(until(3, glide), hitch), 0.8 * kLength) << hitch;
    EXPECT_LT(largest_distance_from_fine(until(3, spin), hitch), 0.28 * kLength) << hitch;
  }
}

TEST(Hitch, CostsNoMoreThanTheLongestPart) {
  TestRig tuned = rig();
  tuned.substep_rate = 120;
  const auto ends = [&](const TestRig& of, float dt, std::uint32_t substeps) {
    return play(of, wander, {double(dt)}, {.substeps = substeps, .teleport_distance = kInfinity}).ends;
  };
  for (const float dt : {0.1f, 0.2f, 0.5f, 7.0f}) {
    EXPECT_EQ(largest_distance(ends(tuned, dt, 0)[0], ends(rig(), dt, 12)[0]), 0) << dt;
    EXPECT_EQ(tuned_substeps(TestHair(tuned).asset, dt), 12u);
  }
  // Without a tuning: parts of a tenth of a second.
  EXPECT_EQ(largest_distance(ends(rig(), 0.5f, 0)[0], ends(rig(), 0.5f, 5)[0]), 0);
  EXPECT_NE(largest_distance(ends(rig(), 0.5f, 5)[0], ends(rig(), 0.5f, 6)[0]), 0) << "or all are the same";
}

TEST(Hitch, OfHeadsThatAreSteppedLessOftenMovesNoHairEither) {
  for (const float hitch : {0.25f, 2.0f}) {
    TestHair test(rig(), HairDesc{.instances = 1, .longest_interval = 4});
    ASSERT_EQ(test.hair.set_detail(0, {.interval = 4}), Status::kOk);
    const std::vector<double> frames = frames_with(double(hitch));
    EXPECT_LT(largest_swing(test, glide, hitch, {.teleport_distance = kInfinity}), 1e-4f) << hitch;
  }
}

TEST(Hitch, BeyondWhatIsSimulatedHairGoesRoundWithItsHead) {
  const HeadMotion spin = [](double t) { return HeadPose{{0, 0, 0}, turned_about({0, 1, 0}, 1.2 * t)}; };
  for (const float inertia : {1.0f, 0.5f}) {
    TestHair test(rig());
    StepSettings settings{.inertia = inertia, .teleport_angle = kInfinity};
    settings.environment.gravity = {};
    EXPECT_LT(largest_swing(test, spin, 2.0f, settings), 0.01f * kLength) << "seen from the head";
  }
}

TEST(Hitch, AnyFiniteTimeIsTaken) {
  for (const float dt : {1e-45f, 1e-30f, 1e-9f, 1e-7f, 1e5f, std::numeric_limits<float>::max()}) {
    TestHair test(rig());
    for (int i = 1; i <= 4; ++i) {
      ASSERT_EQ(test.hair.set_head(0, wander(i * 0.01)), Status::kOk);
      ASSERT_EQ(test.hair.step({.dt = i % 2 == 0 ? dt : 0.01f}), Status::kOk);
      EXPECT_LT(worst_stretch(rig(), test.ends()), 1e-5f) << dt;
    }
  }
}

/// A hair in motion, in the middle of a game.
TestHair& playing(TestHair& test) {
  (void)play(test, wander, even_frames(60, 1));
  return test;
}

TEST(NoTime, ChangesNothing) {
  TestHair paused(rig(), 2), running(rig(), 2);
  (void)playing(paused);
  (void)playing(running);
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(paused.hair.set_head(0, wander(1)), Status::kOk);
    ASSERT_EQ(paused.hair.step({.dt = 0}), Status::kOk);
  }
  EXPECT_EQ(largest_distance(paused.ends(), running.ends()), 0.0f);
  for (int frame = 61; frame < 80; ++frame) {
    for (TestHair* const test : {&paused, &running}) {
      ASSERT_EQ(test->hair.set_head(0, wander(frame / 60.0)), Status::kOk);
      ASSERT_EQ(test->hair.step({}), Status::kOk);
    }
    ASSERT_EQ(largest_distance(paused.ends(), running.ends()), 0.0f) << frame;
  }
}

TEST(NoTime, AHeadThatIsMovedInItHasBeenPutThere) {
  const HeadPose there{{0.4, 0, 1}, turned_about({0, 1, 0}, 0.7)};
  TestHair paused(rig()), told(rig());
  (void)playing(paused);
  (void)playing(told);
  const std::vector<Vec3> before = paused.ends();
  ASSERT_EQ(paused.hair.set_head(0, there), Status::kOk);
  ASSERT_EQ(paused.hair.step({.dt = 0}), Status::kOk);
  EXPECT_EQ(largest_distance(paused.ends(), before), 0.0f) << "its hair is carried along";
  ASSERT_EQ(told.hair.teleport(0, there), Status::kOk);
  for (int i = 0; i < 20; ++i) {
    ASSERT_EQ(paused.hair.step({}), Status::kOk);
    ASSERT_EQ(told.hair.step({}), Status::kOk);
    ASSERT_EQ(largest_distance(paused.ends(), told.ends()), 0.0f) << i;
  }
}

TEST(NoTime, NobodyWakes) {
  TestHair test(rig(), 3);
  for (int i = 0; i < 600; ++i) ASSERT_EQ(test.hair.step({}), Status::kOk);
  ASSERT_TRUE(test.hair.is_asleep(1));
  ASSERT_EQ(test.hair.set_head(1, {}), Status::kOk);
  ASSERT_EQ(test.hair.step({.dt = 0}), Status::kOk);
  EXPECT_EQ(test.hair.job_count(), 0u);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_TRUE(test.hair.is_asleep(i));
}

}  // namespace coif::hitch_test
