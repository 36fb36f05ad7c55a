// The default solver's promise: hair moves the same at every frame rate.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::time_test {

constexpr float kLength = 0.3f;
constexpr double kSeconds = 5;

struct NamedMotion {
  const char* name;
  HeadMotion motion;
};

const NamedMotion kMotions[] = {{"nod", nod}, {"turn", turn}, {"run", run}};

TEST(FrameRate, PathsDifferByLessThanOnePercentOfTheLength) {
  const TestRig rig = calm_strand(4, kLength);
  for (const NamedMotion& head : kMotions) {
    std::vector<Playback> takes;
    for (const double fps : {24.0, 30.0, 60.0, 90.0, 120.0, 144.0, 240.0})
      takes.push_back(play(rig, head.motion, even_frames(fps, kSeconds)));
    takes.push_back(play(rig, head.motion, uneven_frames(1.0 / 240, 1.0 / 20, kSeconds)));
    double spread = 0;
    for (const Playback& a : takes) {
      for (const Playback& b : takes) spread = std::max(spread, rms_tip_difference(a, b));
    }
    EXPECT_LT(spread, 0.01 * kLength) << head.name;
    // And there was something to differ in: the tip moved by more than that.
    EXPECT_GT(rms_tip_difference(takes[0], play(rig, still, even_frames(24, kSeconds))), 0.03 * kLength) << head.name;
  }
}

TEST(FrameRate, ThesisSolverDiffersTenTimesAsMuch) {
  const TestRig rig = calm_strand(3, kLength);
  const auto spread = [&](const Solver* solver) {
    TestHair test(rig, {.solver = solver});
    const Playback slow = play(test, nod, even_frames(30, kSeconds));
    return rms_tip_difference(slow, play(test, nod, even_frames(144, kSeconds)));
  };
  EXPECT_GT(spread(&kThesisSolver), 10 * spread(&kCoifSolver));
}

TEST(FrameRate, HalvingTheStepQuartersTheErrorOfFreeMotion) {
  TestRig rig = calm_strand(3, kLength);
  for (DynamicsRecord& bone : rig.dynamics) bone.friction = 20;
  for (const NamedMotion& head : kMotions) {
    const Playback fine = play(rig, head.motion, even_frames(1920, kSeconds));
    const auto error = [&](double fps) {
      return rms_tip_difference(play(rig, head.motion, even_frames(fps, kSeconds)), fine);
    };
    for (const double fps : {60.0, 120.0}) EXPECT_LT(3 * error(2 * fps), error(fps)) << head.name << ", " << fps;
  }
}

TEST(FrameRate, SubStepsReduceTheError) {
  const TestRig rig = calm_strand(4, kLength);
  for (const NamedMotion& head : kMotions) {
    const Playback fine = play(rig, head.motion, even_frames(960, kSeconds));
    const auto error = [&](std::uint32_t substeps) {
      return rms_tip_difference(play(rig, head.motion, even_frames(30, kSeconds), {.substeps = substeps}), fine);
    };
    const double one = error(1), two = error(2), four = error(4);
    EXPECT_LT(two, 0.5 * one) << head.name;
    EXPECT_LT(four, 0.6 * two) << head.name;
  }
}

TEST(FrameRate, SubStepsOfASteadyHeadAreSmallerFrames) {
  // Nothing to interpolate: four parts of a frame are four frames.
  const TestRig rig = calm_strand(4, kLength);
  StepSettings sideways, in_parts;
  sideways.environment.gravity = in_parts.environment.gravity = {5, -5, 0};
  in_parts.substeps = 4;
  EXPECT_LT(rms_tip_difference(play(rig, still, even_frames(30, 2), in_parts),
                               play(rig, still, even_frames(120, 2), sideways)),
            1e-6);
}

TEST(FrameRate, ContactsAreTheSameAtEveryFrameRate) {
  TestRig rig = calm_strand(4, kLength);
  rig.add_ellipsoid({0, 0, 0}, {0.09f, 0.13f, 0.11f});
  rig.add_plane({0, -0.18f, 0}, {0, 1, 0});
  const Playback fine = play(rig, nod, even_frames(960, kSeconds));
  for (const double fps : {24.0, 30.0, 60.0, 144.0})
    EXPECT_LT(rms_tip_difference(play(rig, nod, even_frames(fps, kSeconds)), fine), 0.02 * kLength) << fps;
}

bool all_equal(const Playback& a, const Playback& b) {
  bool equal = a.ends.size() == b.ends.size();
  for (std::size_t f = 0; equal && f < a.ends.size(); ++f) equal = largest_distance(a.ends[f], b.ends[f]) == 0;
  return equal;
}

TEST(TunedSubsteps, AreTakenWhereNoneAreAskedFor) {
  const TestRig plain = calm_strand(4, kLength);
  TestRig tuned = plain;
  tuned.substep_rate = 120;
  struct Expected {
    double fps;
    std::uint32_t substeps;
  };
  for (const Expected& expected : {Expected{24, 5}, {30, 4}, {50, 3}, {60, 2}, {90, 2}, {120, 1}, {240, 1}}) {
    const std::vector<double> frames = even_frames(expected.fps, 1);
    const auto with = [&](const TestRig& rig, std::uint32_t substeps) {
      return play(rig, wander, frames, {.substeps = substeps});
    };
    EXPECT_TRUE(all_equal(with(tuned, 0), with(plain, expected.substeps))) << expected.fps << " frames per second";
    EXPECT_TRUE(all_equal(with(plain, 0), with(plain, 1))) << "an asset that was not tuned";
    EXPECT_TRUE(all_equal(with(tuned, 3), with(plain, 3))) << "what the game asks for counts";
    EXPECT_FALSE(all_equal(with(plain, expected.substeps), with(plain, expected.substeps + 1)))
        << "or all are the same";
  }
}

/// A step that is longer by rounding has no part more, one that is longer by a few percent has.
TEST(TunedSubsteps, OfAPartThatIsBegunAreOneMore) {
  TestRig rig = calm_strand(2, kLength);
  rig.substep_rate = 240;
  TestHair test(rig);
  EXPECT_EQ(tuned_substeps(test.asset, 4.0f / 240), 4u);
  EXPECT_EQ(tuned_substeps(test.asset, 4.0008f / 240), 4u);
  EXPECT_EQ(tuned_substeps(test.asset, 4.005f / 240), 5u);
  EXPECT_EQ(tuned_substeps(test.asset, 4.05f / 240), 5u);
}

std::vector<Vec3> after_one_step(float dt, std::uint32_t substeps) {
  TestHair test(calm_strand(3, kLength));
  EXPECT_EQ(test.hair.step({.dt = dt, .substeps = substeps}), Status::kOk);
  return test.ends();
}

TEST(LongSteps, HaveNoPartLongerThanMayBeComputedAtOnce) {
  EXPECT_EQ(largest_distance(after_one_step(0.205f, 1), after_one_step(0.205f, 3)), 0.0f);
  EXPECT_EQ(largest_distance(after_one_step(0.2001f, 1), after_one_step(0.2001f, 2)), 0.0f);
  EXPECT_GT(largest_distance(after_one_step(0.205f, 3), after_one_step(0.205f, 2 * 3)), 0.0f);
}

/// Two frames of unlike length together have as many parts as the asked-for length of one goes into them, begun ones
/// included.
TEST(LongSteps, OfSeveralFramesHaveThePartsOfTheLast) {
  TestHair together(calm_strand(3, kLength), {.longest_interval = 2}), at_once(calm_strand(3, kLength));
  ASSERT_EQ(together.hair.set_detail(0, {.interval = 2}), Status::kOk);
  const float first = 0.0105f, last = 0.01f;
  for (const float dt : {first, last}) ASSERT_EQ(together.hair.step({.dt = dt, .substeps = 1}), Status::kOk);
  ASSERT_EQ(at_once.hair.step({.dt = last + first, .substeps = 3}), Status::kOk);
  EXPECT_EQ(largest_distance(together.ends(), at_once.ends()), 0.0f);
  EXPECT_GT(largest_distance(at_once.ends(), calm_strand(3, kLength).rest_ends()), 0.0f);
}

TEST(TunedSubsteps, AreNoMoreThanAStepMayHave) {
  TestRig tuned = calm_strand(2, kLength);
  tuned.substep_rate = 1.0e5f;
  const std::vector<double> frames = even_frames(30, 0.5);
  EXPECT_TRUE(all_equal(play(tuned, wander, frames), play(tuned, wander, frames, {.substeps = kMaxSubsteps})));
}

// Paused, slowed and stepped games, and scenes far away.

TEST(TimeControl, SlowMotionFollowsTheSamePath) {
  const TestRig rig = calm_strand(4, 0.3f);
  for (const HeadMotion& motion : {HeadMotion(nod), HeadMotion(turn), HeadMotion(run)}) {
    std::vector<double> frames;
    for (const double now : even_frames(600, 4)) {
      // A tenth of the speed between the first and the second second.
      const bool slow = now > 1 && now <= 2, at_sixtieth = std::fabs(now * 60 - std::round(now * 60)) < 1e-6;
      if (slow || at_sixtieth) frames.push_back(now);
    }
    const Playback normal = play(rig, motion, even_frames(60, 4)), slowed = play(rig, motion, frames);
    EXPECT_LT(rms_tip_difference(normal, slowed), 0.002 * 0.3);
    EXPECT_GT(rms_tip_difference(normal, play(rig, still, even_frames(60, 4))), 0.03 * 0.3);
  }
}

TEST(TimeControl, APausedGameMaySetTheSamePoseAsOftenAsItLikes) {
  TestHair paused(calm_strand(4, 0.3f)), running(calm_strand(4, 0.3f));
  for (int frame = 1; frame <= 100; ++frame) {
    const HeadPose pose = wander(frame / 60.0);
    for (int i = 0; i < (frame % 10 == 0 ? 50 : 1); ++i) ASSERT_EQ(paused.hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(running.hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(paused.hair.step({}), Status::kOk);
    ASSERT_EQ(running.hair.step({}), Status::kOk);
  }
  EXPECT_EQ(largest_distance(paused.ends(), running.ends()), 0.0f);
}

TEST(TimeControl, AHitchDoesNotThrowHair) {
  // One frame of a tenth of a second among those of a sixtieth.
  std::vector<double> frames = even_frames(60, 3);
  frames.erase(frames.begin() + 60, frames.begin() + 65);
  const TestRig rig = calm_strand(4, 0.3f);
  for (const HeadMotion& motion : {HeadMotion(nod), HeadMotion(turn), HeadMotion(run)})
    EXPECT_LT(rms_tip_difference(play(rig, motion, frames), play(rig, motion, even_frames(60, 3))), 0.01 * 0.3);
}

TEST(TimeControl, StepsOfAMicrosecondLeaveHairWhereItRests) {
  TestHair test(calm_strand(4, 0.3f));
  StepSettings settings;
  const Playback settled = play(test, still, even_frames(60, 5));
  settings.dt = 1e-6f;
  for (int i = 0; i < 20000; ++i) ASSERT_EQ(test.hair.step(settings), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(), settled.ends.back()), 2e-4f);
}

TEST(TimeControl, AMillionMetresFromTheOriginHairMovesAsAtIt) {
  const HeadMotion far = [](double t) {
    HeadPose pose = wander(t);
    for (double& metres : pose.position) metres -= 1e6;
    return pose;
  };
  const TestRig rig = calm_strand(4, 0.3f);
  for (const std::uint32_t substeps : {1u, 4u}) {
    const StepSettings settings{.substeps = substeps};
    const Playback here = play(rig, wander, even_frames(60, 4), settings);
    const Playback there = play(rig, far, even_frames(60, 4), settings);
    for (std::size_t i = 0; i < here.ends.size(); ++i)
      ASSERT_LT(largest_distance(here.ends[i], there.ends[i]), 1e-4f) << here.seconds[i];
  }
}

}  // namespace coif::time_test
