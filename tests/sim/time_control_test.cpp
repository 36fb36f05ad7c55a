// Paused, slowed and stepped games, and scenes far away.

#include "sim/playback.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

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

}  // namespace
}  // namespace coif
