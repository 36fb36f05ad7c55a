// Hair at rest costs nothing, and nobody can see that it sleeps.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace coif::sleep_test {

constexpr float kNever = std::numeric_limits<float>::infinity();
const Solver* const kSolvers[] = {&kCoifSolver, &kPassiveSolver, &kThesisSolver};

TestRig rig() {
  TestRig rig = calm_strand(4, 0.3f);
  for (DynamicsRecord& bone : rig.dynamics) bone.friction = 2, bone.resistance = 0.3f;
  return rig;
}

/// Swings for minutes.
TestRig loose_rig() {
  TestRig rig;
  rig.add({.rest_direction = {0.6f, -0.8f, 0}, .length = 0.3f, .stiffness = 0, .damping = 0.02f});
  return rig;
}

StepSettings weightless(float sleep_after = 0.5f) {
  StepSettings settings;
  settings.environment.gravity = {};
  settings.sleep_after = sleep_after;
  return settings;
}

void step(TestHair& test, const StepSettings& settings, int count = 1) {
  for (int i = 0; i < count; ++i) ASSERT_EQ(test.hair.step(settings), Status::kOk);
}

/// Lets it hang until it sleeps.
void put_to_sleep(TestHair& test, const StepSettings& settings = {}) {
  step(test, settings, 600);
  for (std::uint32_t i = 0; i < test.hair.instance_count(); ++i) ASSERT_TRUE(test.hair.is_asleep(i)) << i;
}

std::uint32_t jobs_of_a_step(Hair& hair) {
  EXPECT_EQ(hair.begin_step({}), Status::kOk);
  const std::uint32_t count = hair.job_count();
  for (std::uint32_t job = 0; job < count; ++job) hair.run_job(job);
  hair.finish_step();
  return count;
}

bool same_bits(std::span<const Mat34> a, std::span<const Mat34> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

TEST(Sleep, BeginsAfterTheTimeAskedFor) {
  for (const Solver* const solver : kSolvers) {
    for (const float seconds : {0.1f, 0.5f, 2.0f}) {
      TestHair test(rig(), {.solver = solver});
      float rested = 0;
      while (rested < seconds - 0.02f) {
        step(test, weightless(seconds));
        rested += 1.0f / 60;
        ASSERT_FALSE(test.hair.is_asleep(0)) << rested << " of " << seconds;
      }
      step(test, weightless(seconds), 3);
      EXPECT_TRUE(test.hair.is_asleep(0)) << seconds;
    }
  }
}

TEST(Sleep, NeverBeginsWhereTheTimeIsInfinite) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(rig(), {.solver = solver});
    step(test, weightless(kNever), 5000);
    EXPECT_FALSE(test.hair.is_asleep(0));
  }
}

TEST(Sleep, NeverBeginsWhileHeadOrHairMoves) {
  TestHair test(rig());
  for (int frame = 1; frame < 300; ++frame) {  // steady: the hair has nothing to do
    ASSERT_EQ(test.hair.set_head(0, {{0.01 * frame, 0, 0}, {}}), Status::kOk);
    step(test, weightless());
    ASSERT_FALSE(test.hair.is_asleep(0)) << frame;
  }
  for (int frame = 1; frame < 300; ++frame) {
    ASSERT_EQ(test.hair.set_head(0, {{3, 0, 0}, turned_about({0, 1, 0}, 0.01 * frame)}), Status::kOk);
    step(test, weightless());
    ASSERT_FALSE(test.hair.is_asleep(0)) << frame;
  }
  TestHair swings(loose_rig());
  for (int frame = 1; frame < 600; ++frame) {
    step(swings, {});
    ASSERT_FALSE(swings.hair.is_asleep(0)) << frame;
  }
}

TEST(Sleep, OfEveryoneLeavesNoJobAndNoChange) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(rig(), {.instances = 40, .solver = solver});
    EXPECT_EQ(jobs_of_a_step(test.hair), 3u);
    put_to_sleep(test);
    const std::vector<Mat34> matrices(test.hair.palette(17).begin(), test.hair.palette(17).end());
    for (int i = 0; i < 100; ++i) ASSERT_EQ(jobs_of_a_step(test.hair), 0u);
    EXPECT_TRUE(same_bits(test.hair.palette(17), matrices));
    ASSERT_EQ(test.hair.set_head(17, {{0, 0, 0.01}, {}}), Status::kOk);
    EXPECT_EQ(jobs_of_a_step(test.hair), 1u);
  }
}

TEST(Sleep, HoldsThroughTheSamePose) {
  TestHair test(rig());
  const HeadPose pose{{1, 2, 3}, turned_about({0.6f, 0, 0.8f}, 0.7)};
  ASSERT_EQ(test.hair.reset(0, pose), Status::kOk);
  put_to_sleep(test);
  for (int i = 0; i < 10; ++i) {
    ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
    step(test, {});
    ASSERT_TRUE(test.hair.is_asleep(0));
  }
}

/// A sleeper and one that has never slept, from the step on at which `change` happens to both.
void expect_wakes_as_if_awake(const Solver* solver, const std::function<void(Hair&)>& change, StepSettings settings,
                              const char* what) {
  TestHair sleeper(rig(), {.solver = solver}), awake(rig(), {.solver = solver});
  StepSettings sleepless;
  sleepless.sleep_after = kNever;
  put_to_sleep(sleeper);
  step(awake, sleepless, 600);
  ASSERT_LT(largest_distance(sleeper.ends(), awake.ends()), 2e-5f) << what;
  float moved = 0;
  const std::vector<Vec3> start = awake.ends();
  for (int frame = 0; frame < 60; ++frame) {
    if (frame == 0) change(sleeper.hair), change(awake.hair);
    settings.sleep_after = 0.5f;
    step(sleeper, settings);
    settings.sleep_after = kNever;
    step(awake, settings);
    ASSERT_FALSE(frame < 29 && sleeper.hair.is_asleep(0)) << what << ", frame " << frame;
    ASSERT_LT(largest_distance(sleeper.ends(), awake.ends()), 5e-5f) << what << ", frame " << frame;
    moved = std::max(moved, largest_distance(awake.ends(), start));
  }
  EXPECT_GT(moved, 1e-5f) << what << " does something";
}

TEST(Sleep, EndsWithoutAJumpWhenTheHeadMoves) {
  for (const Solver* const solver : kSolvers) {
    const auto move = [](Hair& hair) { EXPECT_EQ(hair.set_head(0, {{0, 0, 0.02}, {}}), Status::kOk); };
    const auto turn = [](Hair& hair) { EXPECT_EQ(hair.set_head(0, wander(0.4)), Status::kOk); };
    const auto jump = [](Hair& hair) {
      EXPECT_EQ(hair.teleport(0, {{50, 0, 0}, turned_about({1, 0, 0}, 1)}), Status::kOk);
    };
    expect_wakes_as_if_awake(solver, move, {}, "a step forward");
    expect_wakes_as_if_awake(solver, turn, {}, "a turn");
    expect_wakes_as_if_awake(solver, jump, {}, "a teleport");
  }
}

TEST(Sleep, EndsWithoutAJumpWhenTheSurroundingsChange) {
  const auto nothing = [](Hair&) {};
  for (const Solver* const solver : kSolvers) {
    expect_wakes_as_if_awake(solver, nothing, {.environment = {.gravity = {3, -9, 0}}}, "gravity");
    expect_wakes_as_if_awake(solver, nothing, {.environment = {.wind = {0, 0, -2}}}, "wind");
    expect_wakes_as_if_awake(solver, nothing, {.environment = {.wind = {0, 0, -0.02f}}}, "a breath");
  }
  expect_wakes_as_if_awake(&kCoifSolver, nothing, {.dynamics = {.stiffness = 0.5f}}, "softer");
}

TEST(Sleep, GivesAChangeTooSlowToBeSeenItsWholeTime) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(rig(), {.solver = solver});
    StepSettings settings;
    settings.sleep_speed = 0.05f;
    put_to_sleep(test, settings);
    settings.environment.wind = {0, 0, -0.05f};
    for (int frame = 0; frame < 28; ++frame) {
      step(test, settings);
      ASSERT_FALSE(test.hair.is_asleep(0)) << frame;
    }
    step(test, settings, 4);
    EXPECT_TRUE(test.hair.is_asleep(0));
  }
}

TEST(Sleep, EndsWhereWhatItTakesToSleepIsAnother) {
  for (const Solver* const solver : kSolvers) {
    const auto wakes_under = [&](float after, float speed) {
      TestHair test(rig(), {.solver = solver});
      put_to_sleep(test);
      StepSettings settings;
      settings.sleep_after = after;
      settings.sleep_speed = speed;
      step(test, settings);
      return !test.hair.is_asleep(0);
    };
    const StepSettings usual;
    EXPECT_FALSE(wakes_under(usual.sleep_after, usual.sleep_speed));
    EXPECT_TRUE(wakes_under(usual.sleep_after * 2, usual.sleep_speed));
    EXPECT_TRUE(wakes_under(kNever, usual.sleep_speed));
    EXPECT_TRUE(wakes_under(usual.sleep_after, usual.sleep_speed / 2));
  }
}

/// A head that only turns is still where a decimetre from its axis goes slower than sleep_speed.
TEST(Sleep, OfAHeadThatTurnsIsMeasuredADecimetreFromItsAxis) {
  const auto sleeps_at = [](double radians_per_second) {
    TestRig stiff;  // on the axis: it moves as little as may be
    stiff.add({.joint = {0, 0, -0.01f}, .length = 0.05f, .stiffness = 2000, .damping = 100, .torsion = 20});
    TestHair test(stiff);
    StepSettings settings = weightless(0.2f);
    settings.sleep_speed = 0.01f;
    for (int frame = 1; frame <= 120; ++frame) {
      const HeadPose pose{{}, turned_about({0, 1, 0}, radians_per_second * frame / 60)};
      EXPECT_EQ(test.hair.set_head(0, pose), Status::kOk);
      step(test, settings);
      if (test.hair.is_asleep(0)) return true;
    }
    return false;
  };
  EXPECT_TRUE(sleeps_at(0.098));
  EXPECT_FALSE(sleeps_at(0.102));
}

TEST(Sleep, EndsWithAReset) {
  TestHair test(rig());
  put_to_sleep(test);
  ASSERT_EQ(test.hair.reset(0, {}), Status::kOk);
  EXPECT_FALSE(test.hair.is_asleep(0));
  EXPECT_LT(largest_distance(test.ends(), rig().rest_ends()), 1e-6f);
  step(test, {});
  EXPECT_GT(largest_distance(test.ends(), rig().rest_ends()), 1e-5f) << "gravity pulls again";
}

TEST(Sleep, OfNeighboursChangesNoBit) {
  for (const Solver* const solver : kSolvers) {
    constexpr std::uint32_t kCount = 40;
    TestHair sleepy(rig(), {.instances = kCount, .solver = solver});
    TestHair lively(rig(), {.instances = kCount, .solver = solver});
    std::uint32_t sleepers = 0;
    for (int frame = 1; frame <= 300; ++frame) {
      for (std::uint32_t i = 0; i < kCount; ++i) {
        const HeadPose pose = wander(frame / 60.0 + i);
        ASSERT_EQ(lively.hair.set_head(i, pose), Status::kOk);
        const bool moves = i % 3 == 0 || frame > 270;
        ASSERT_EQ(sleepy.hair.set_head(i, moves ? pose : wander(i)), Status::kOk);
      }
      step(sleepy, {});
      step(lively, {});
      for (std::uint32_t i = 0; i < kCount; ++i) {
        const bool differ = i % 3 == 0 && !same_bits(sleepy.hair.palette(i), lively.hair.palette(i));
        ASSERT_FALSE(differ) << frame << " " << i;
        sleepers += sleepy.hair.is_asleep(i) ? 1 : 0;
      }
    }
    EXPECT_GT(sleepers, 1000u);
  }
}

TEST(Sleep, BadIndicesAreAwake) {
  const TestHair test(rig());
  EXPECT_FALSE(test.hair.is_asleep(1));
  EXPECT_FALSE(test.hair.is_asleep(kNone));
  EXPECT_FALSE(Hair{}.is_asleep(0));
}

}  // namespace coif::sleep_test
