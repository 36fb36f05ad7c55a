#include "compare/rig_difference.h"

#include "animation/open_asset.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

/// small_asset() with this much of each vertex's weight, of 255, on the bone that moves it; the rest follows the head.
AssetContents moving_by(std::uint8_t weight) {
  AssetContents contents = small_asset();
  for (SkinRecord& skin : contents.skin) {
    skin.weight[0] = weight;
    skin.weight[1] = std::uint8_t(255 - weight);
  }
  return contents;
}

RigDifference difference(const AssetContents& a, const AssetContents& b, const RecordingSettings& settings) {
  const OpenAsset file_a(a), file_b(b);
  const auto match = match_surfaces(file_a.asset(), file_b.asset());
  EXPECT_TRUE(match) << match.error().message;
  const auto result = compare_rigs(file_a.asset(), file_b.asset(), *match, settings);
  EXPECT_TRUE(result) << result.error().message;
  return *result;
}

TEST(RigDifference, OfEqualRigsIsNothing) {
  for (const MotionInfo& info : all_motions()) {
    const auto d = difference(small_asset(), small_asset(), {.motion = info.motion, .seconds = 1});
    EXPECT_EQ(d.rms, 0) << info.name;
    EXPECT_EQ(d.max, 0) << info.name;
    EXPECT_EQ(d.ratio, 0) << info.name;
    EXPECT_GT(d.moved, 0) << info.name;
  }
}

TEST(RigDifference, OfARigidRigIsOneOfWhatTheOtherMoves) {
  const auto d = difference(moving_by(255), moving_by(0), {.motion = Motion::kTurn, .seconds = 1});
  EXPECT_GT(d.moved, 0.001);
  EXPECT_NEAR(d.rms, d.moved, 1.0e-9);
  EXPECT_NEAR(d.ratio, 1, 1.0e-9);
  EXPECT_GE(d.max, d.rms);
}

TEST(RigDifference, GrowsWithTheWeightThatIsMissing) {
  for (const int missing : {51, 102, 204}) {
    const auto d =
        difference(moving_by(255), moving_by(std::uint8_t(255 - missing)), {.motion = Motion::kNod, .seconds = 1});
    EXPECT_NEAR(d.ratio, missing / 255.0, 1.0e-4);
  }
}

TEST(RigDifference, HasNoRatioWhereNothingMoves) {
  const auto d = difference(moving_by(0), moving_by(255), {.motion = Motion::kTurn, .seconds = 1});
  EXPECT_LT(d.moved, 1.0e-6);
  EXPECT_GT(d.rms, 0);
}

TEST(RigDifference, TellsSagFromSwing) {
  const auto sag = difference(small_asset(), small_asset(), {.motion = Motion::kStill, .seconds = 1});
  EXPECT_LT(sag.still_ratio, 0.05) << "settled hair holds its mean pose";
  // Where no collider and no weight holds hair off its pose, all it does is swing.
  AssetContents free = small_asset();
  for (BoneRecord& bone : free.bones) bone.colliders = 0;
  for (DynamicsRecord& bone : free.dynamics) bone.gravity_scale = 0;
  const auto swing = difference(free, free, {.motion = Motion::kNod, .seconds = 2});
  EXPECT_GT(swing.still_ratio, 0.9);
  EXPECT_LE(swing.still_ratio, 1);
}

TEST(RigDifference, RefusesWhatTheRecordingRefuses) {
  const OpenAsset file(small_asset());
  const auto match = match_surfaces(file.asset(), file.asset());
  ASSERT_TRUE(match);
  EXPECT_FALSE(compare_rigs(file.asset(), file.asset(), *match, {.fps = 1}));
}

TEST(HairSize, IsTheDiagonalOfTheBoxAroundTheFinestLevel) {
  const OpenAsset file(small_asset());
  // Vertices of level 0: x 0 .. 0.15, y -0.1 .. 0.
  EXPECT_NEAR(hair_size(file.asset()), std::hypot(0.15, 0.1), 1.0e-6);
}

}  // namespace
}  // namespace coif
