#include "animation/recording.h"
#include "animation/glb_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace coif::animation::recording_test {

class Recorded : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(asset().is_open()); }
  [[nodiscard]] const Asset& asset() const { return file_.asset(); }

 private:
  OpenAsset file_{small_asset()};
};

float largest_move(const RecordedFrame& a, const RecordedFrame& b) {
  float largest = 0;
  for (std::size_t i = 0; i < a.bone_ends.size(); ++i) {
    const Vec3& p = a.bone_ends[i];
    const Vec3& q = b.bone_ends[i];
    largest = std::max(largest, std::hypot(p.x - q.x, p.y - q.y, p.z - q.z));
  }
  return largest;
}

TEST_F(Recorded, HasOneFrameMoreThanStepsAndTheirTimes) {
  const auto recording = record(asset(), {.motion = motion::Motion::kNod, .fps = 24, .seconds = 1.5});
  ASSERT_TRUE(recording);
  ASSERT_EQ(recording->frames.size(), 37u);
  for (std::size_t i = 0; i < recording->frames.size(); ++i) {
    EXPECT_DOUBLE_EQ(recording->frames[i].seconds, double(i) / 24);
    EXPECT_EQ(recording->frames[i].palette.size(), asset().bones().size());
    EXPECT_EQ(recording->frames[i].bone_ends.size(), asset().bones().size());
  }
}

TEST(FrameEnds, GoByTurns) {
  const RecordingSettings settings{.lengths = {.seconds = {0.25, 0.125, 0.5}}, .seconds = 1.25};
  EXPECT_EQ(frame_ends(settings), (std::vector<double>{0, 0.25, 0.375, 0.875, 1.125, 1.25}));
}

TEST(FrameEnds, JitterIsBoundedAndTheSameForASeed) {
  RecordingSettings settings{.fps = 50, .lengths = {.jitter = 0.4, .seed = 7}, .seconds = 100};
  const auto ends = frame_ends(settings);
  EXPECT_EQ(frame_ends(settings), ends);
  double shortest = 1, longest = 0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    shortest = std::min(shortest, ends[i] - ends[i - 1]), longest = std::max(longest, ends[i] - ends[i - 1]);
  }
  EXPECT_NEAR(shortest, 0.02 * 0.6, 1e-4);
  EXPECT_NEAR(longest, 0.02 * 1.4, 1e-4);
  EXPECT_GE(shortest, 0.02 * 0.6 - 1e-9);
  EXPECT_LE(longest, 0.02 * 1.4 + 1e-9);
  EXPECT_NEAR(double(ends.size()), 5000, 100);
  EXPECT_LE(ends.back(), 100);
  settings.lengths.seed = 8;
  EXPECT_NE(frame_ends(settings), ends);
}

TEST_F(Recorded, InUnevenFramesIsTheSameMotion) {
  RecordingSettings settings{.motion = motion::Motion::kNod, .fps = 200, .seconds = 1};
  const auto even = record(asset(), settings);
  settings.lengths = {.seconds = {0.004, 0.006, 0.003, 0.007}, .jitter = 0.2, .seed = 3};
  const auto uneven = record(asset(), settings);
  ASSERT_TRUE(even && uneven);
  ASSERT_EQ(uneven->frames.size(), frame_ends(settings).size());
  float moved = 0, apart = 0;
  for (const RecordedFrame& frame : uneven->frames) {
    const RecordedFrame& near = even->frames[std::size_t(std::lround(frame.seconds * 200))];
    moved = std::max(moved, largest_move(frame, even->frames.front()));
    apart = std::max(apart, largest_move(frame, near));  // up to half a frame of 5 ms
  }
  EXPECT_GT(moved, 2e-3f);
  EXPECT_LT(apart, 0.15f * moved);
}

TEST_F(Recorded, SaysHowFarHairIsFromItsRestPoseAndHowFastAtTheEnd) {
  RecordingSettings settings{.motion = motion::Motion::kStill, .seconds = 0, .settle_seconds = 0};
  const auto fresh = record(asset(), settings);
  ASSERT_TRUE(fresh);
  EXPECT_EQ(fresh->from_rest, 0);
  settings.seconds = 4, settings.step.environment.wind = {20, 0, 0};
  const auto blown = record(asset(), settings);
  ASSERT_TRUE(blown);
  float longest = 0, fastest = 0;
  std::vector<float> reach(asset().bones().size());
  for (std::size_t i = 0; i < reach.size(); ++i) {
    if (asset().bones()[i].kind != BoneKind::kSimulated) continue;
    reach[i] = asset().bones()[i].length + reach[asset().bones()[i].parent];
    longest = std::max(longest, reach[i]);
  }
  for (std::size_t i = 181; i < blown->frames.size(); ++i) {
    fastest = std::max(fastest, largest_move(blown->frames[i], blown->frames[i - 1]) * 60);
  }
  EXPECT_GT(blown->from_rest, 0.01f);
  EXPECT_FLOAT_EQ(blown->from_rest, largest_move(blown->frames.back(), fresh->frames.front()) / longest);
  EXPECT_NEAR(blown->last_speed, fastest, 1e-6f + 1e-4f * fastest);
}

TEST_F(Recorded, IsAlikeAtEveryScale) {
  RecordingSettings settings{.clip = motion::held_turn(Eigen::Vector3d::UnitX(), 1.5, 0.8), .seconds = 2};
  const auto own = record(asset(), settings);
  for (const float scale : {0.1f, 10.0f}) {
    settings.company.scale = scale;
    const auto scaled = record(asset(), settings);
    ASSERT_TRUE(own && scaled);
    EXPECT_EQ(largest_move(own->frames.back(), scaled->frames.back()), 0);
  }
  for (const float scale : {0.049f, 20.1f, std::nanf("")}) {
    settings.company.scale = scale;
    EXPECT_FALSE(record(asset(), settings)) << scale;
  }
}

TEST_F(Recorded, RefusesFramesOfNoLength) {
  for (const FrameLengths& lengths : {FrameLengths{.seconds = {0.02, 0}},
                                      {.seconds = {1.1}},
                                      {.seconds = {std::nan("")}},
                                      {.jitter = -0.1},
                                      {.jitter = 0.91}}) {
    EXPECT_FALSE(record(asset(), {.lengths = lengths, .seconds = 0.1}));
  }
}

TEST_F(Recorded, OfNoSecondsIsTheSettledPose) {
  const auto recording = record(asset(), {.motion = motion::Motion::kTurn, .seconds = 0});
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->frames.size(), 1u);
}

TEST_F(Recorded, AtWeightZeroIsThePose) {
  RecordingSettings settings{.motion = motion::Motion::kTurn, .seconds = 0.5};
  settings.company.pose_weight = 0;
  settings.company.pose = [this](double) { return std::vector<Quat>(asset().bones().size()); };
  const auto held = record(asset(), settings);
  ASSERT_TRUE(held);
  EXPECT_LT(largest_move(held->frames.front(), held->frames.back()), 1e-6f) << "the rest pose, whatever the head does";
  settings.company.pose_weight = 1;
  const auto free = record(asset(), settings);
  ASSERT_TRUE(free);
  EXPECT_GT(largest_move(free->frames.front(), free->frames.back()), 1e-4f);
}

TEST_F(Recorded, FollowsAPoseByOurSolverAlone) {
  RecordingSettings settings{.seconds = 0.1, .solver = &kThesisSolver};
  settings.company.pose = [this](double) { return std::vector<Quat>(asset().bones().size()); };
  EXPECT_FALSE(record(asset(), settings));
}

TEST_F(Recorded, HasAHandThatMovesTheHair) {
  RecordingSettings settings{.motion = motion::Motion::kStill, .seconds = 0.5};
  const auto alone = record(asset(), settings);
  ASSERT_TRUE(alone);
  const Vec3 tip = alone->frames.back().bone_ends.back();
  settings.company.colliders = [tip](double) {
    MovingCollider ball;
    ball.center[0] = double(tip.x) + 0.01, ball.center[1] = double(tip.y), ball.center[2] = double(tip.z);
    ball.radius = 0.03f;
    return std::vector{ball};
  };
  const auto touched = record(asset(), settings);
  ASSERT_TRUE(touched);
  EXPECT_GT(largest_move(alone->frames.back(), touched->frames.back()), 0.01f);
}

TEST_F(Recorded, SettlesBeforeTheFirstFrame) {
  RecordingSettings settings{.motion = motion::Motion::kStill, .seconds = 1};
  const auto settled = record(asset(), settings);
  settings.settle_seconds = 0;
  const auto unsettled = record(asset(), settings);
  ASSERT_TRUE(settled && unsettled);
  const float drift = largest_move(settled->frames.front(), settled->frames.back());
  const float sag = largest_move(unsettled->frames.front(), unsettled->frames.back());
  EXPECT_LT(drift, 1e-3f);
  EXPECT_GT(sag, 2 * drift);
}

TEST_F(Recorded, FollowsTheMotionsPoses) {
  const auto recording = record(asset(), {.motion = motion::Motion::kTurn, .fps = 30, .seconds = 1});
  ASSERT_TRUE(recording);
  for (const RecordedFrame& frame : recording->frames) {
    const HeadPose pose = motion::head_pose(motion::Motion::kTurn, frame.seconds);
    EXPECT_EQ(frame.head.rotation.y, pose.rotation.y);
    EXPECT_EQ(frame.head.position[1], pose.position[1]);
  }
}

TEST_F(Recorded, TwiceGivesTheSameBytes) {
  const RecordingSettings settings{.motion = motion::Motion::kTumble, .fps = 60, .seconds = 1};
  const auto a = record(asset(), settings);
  const auto b = record(asset(), settings);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(to_csv(asset(), *a), to_csv(asset(), *b));
  EXPECT_EQ(to_glb(asset(), *a), to_glb(asset(), *b));
}

TEST_F(Recorded, FollowsAClipInsteadOfTheMotion) {
  const auto built_in = record(asset(), {.motion = motion::Motion::kRun, .seconds = 1});
  const auto clip =
      record(asset(), {.motion = motion::Motion::kStill, .clip = motion::path_of(motion::Motion::kRun), .seconds = 1});
  ASSERT_TRUE(built_in && clip);
  EXPECT_EQ(to_csv(asset(), *clip), to_csv(asset(), *built_in));
}

TEST_F(Recorded, RefusesSettingsOutsideTheirRanges) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double fps : {0.0, -60.0, 9.9, 1000.5, nan}) EXPECT_FALSE(record(asset(), {.fps = fps})) << fps;
  for (const double seconds : {-1.0, 3601.0, nan}) {
    EXPECT_FALSE(record(asset(), {.seconds = seconds})) << seconds;
    EXPECT_FALSE(record(asset(), {.settle_seconds = seconds})) << seconds;
  }
  RecordingSettings many_passes;
  many_passes.step.iterations = 1000;
  EXPECT_FALSE(record(asset(), many_passes));
}

TEST_F(Recorded, TakesTheSlowestRateThatTheRuntimeAllows) {
  EXPECT_TRUE(record(asset(), {.motion = motion::Motion::kNod, .fps = 10, .seconds = 1}));
}

TEST_F(Recorded, RefusesWhatDoesNotFitInMemory) {
  const auto recording = record(asset(), {.fps = 1000, .seconds = 3600});
  ASSERT_FALSE(recording);
  EXPECT_NE(recording.error().message.find("1 GiB"), std::string::npos);
}

std::vector<Vec3> resting_ends(const Asset& asset) {
  std::vector<Vec3> ends;
  for (const BoneRecord& bone : asset.bones()) {
    ends.push_back({bone.joint[0] + bone.length * bone.rest_direction[0],
                    bone.joint[1] + bone.length * bone.rest_direction[1],
                    bone.joint[2] + bone.length * bone.rest_direction[2]});
  }
  return ends;
}

AssetContents with_collider(const ColliderRecord& collider) {
  AssetContents contents = small_asset();
  contents.colliders = {collider};
  for (BoneRecord& bone : contents.bones) bone.colliders = bone.kind == BoneKind::kSimulated ? 1 : 0;
  return contents;
}

TEST(WorstStretch, IsZeroInTheRestPose) {
  const OpenAsset file(small_asset());
  ASSERT_TRUE(file.asset().is_open());
  EXPECT_NEAR(worst_stretch(file.asset(), resting_ends(file.asset())), 0.0f, 1e-6f);
}

TEST(WorstStretch, MeasuresFromTheBonesOwnJointUnderARigidBone) {
  AssetContents contents = small_asset();
  contents.bones[2].joint[0] = contents.bones[3].joint[0] = 0.3f;  // the scalp's joint stays where it is
  const OpenAsset file(contents);
  ASSERT_TRUE(file.asset().is_open());
  EXPECT_NEAR(worst_stretch(file.asset(), resting_ends(file.asset())), 0.0f, 1e-6f);
}

TEST(WorstStretch, CountsLongerAndShorterBonesAlike) {
  const OpenAsset file(small_asset());
  ASSERT_TRUE(file.asset().is_open());
  for (const float factor : {1.5f, 0.5f}) {
    std::vector<Vec3> ends = resting_ends(file.asset());
    ends[4].y *= factor;  // the lone bone hangs from the head's joint, the origin
    EXPECT_NEAR(worst_stretch(file.asset(), ends), 0.5f, 1e-5f) << factor;
  }
}

TEST(WorstPenetration, IsOneAtTheCentreAndZeroOnTheSurfaceOfASphere) {
  const OpenAsset file(
      with_collider({ColliderShape::kSphere, 0, {}, 0, {1, 2, 3}, 0, {0.5f, 0.5f, 0.5f}, 0, {0, 0, 0, 1}, {}, 0}));
  ASSERT_TRUE(file.asset().is_open());
  std::vector<Vec3> ends(file.asset().bones().size(), Vec3{9, 9, 9});
  EXPECT_EQ(worst_penetration(file.asset(), ends), 0.0f);
  ends[3] = {1, 2, 3.5f};
  EXPECT_NEAR(worst_penetration(file.asset(), ends), 0.0f, 1e-6f);
  ends[3] = {1, 2, 3.4f};
  EXPECT_NEAR(worst_penetration(file.asset(), ends), 0.2f, 1e-5f);
  ends[3] = {1, 2, 3};
  EXPECT_NEAR(worst_penetration(file.asset(), ends), 1.0f, 1e-6f);
}

TEST(WorstPenetration, FollowsTheEllipsoidsRotation) {
  const float half = std::sqrt(0.5f);  // a quarter turn about Z: the long X axis points along Y
  const OpenAsset file(with_collider(
      {ColliderShape::kEllipsoid, 0, {}, 0, {0, 0, 0}, 0, {0.4f, 0.1f, 0.1f}, 0, {0, 0, half, half}, {}, 0}));
  ASSERT_TRUE(file.asset().is_open());
  std::vector<Vec3> ends(file.asset().bones().size(), Vec3{9, 9, 9});
  ends[2] = {0.3f, 0, 0};
  EXPECT_EQ(worst_penetration(file.asset(), ends), 0.0f);
  ends[2] = {0, 0.3f, 0};
  EXPECT_NEAR(worst_penetration(file.asset(), ends), 0.25f, 1e-5f);
}

TEST(WorstPenetration, MeasuresCapsulesFromTheirSegment) {
  const OpenAsset file(with_collider(
      {ColliderShape::kCapsule, 0, 0, 0, {0, 1, 0}, 0, {0.5f, 0.5f, 0.5f}, 0, {0, 0, 0, 1}, {2, 0, 0}, 0}));
  ASSERT_TRUE(file.asset().is_open());
  std::vector<Vec3> ends(file.asset().bones().size(), Vec3{9, 9, 9});
  ends[3] = {1.5f, 1.6f, 0};
  EXPECT_EQ(worst_penetration(file.asset(), ends), 0.0f);
  ends[3] = {1.5f, 1.4f, 0};
  EXPECT_NEAR(worst_penetration(file.asset(), ends), 0.2f, 1e-5f);
  ends[3] = {2.4f, 1, 0};
  EXPECT_NEAR(worst_penetration(file.asset(), ends), 0.2f, 1e-5f) << "the round end";
}

TEST(WorstPenetration, OfAnEnclosingShapeIsHowFarHairLeavesIt) {
  const OpenAsset file(with_collider(
      {ColliderShape::kSphere, 0, kColliderKeepsInside, 0, {0, 0, 0}, 0, {0.5f, 0.5f, 0.5f}, 0, {0, 0, 0, 1}, {}, 0}));
  ASSERT_TRUE(file.asset().is_open());
  std::vector<Vec3> ends(file.asset().bones().size(), Vec3{0.1f, 0, 0});
  EXPECT_EQ(worst_penetration(file.asset(), ends), 0.0f);
  ends[4] = {0, 0.6f, 0};
  EXPECT_NEAR(worst_penetration(file.asset(), ends), 0.2f, 1e-5f);
}

TEST(WorstPenetration, OfAPlaneIsInHeads) {
  const OpenAsset file(
      with_collider({ColliderShape::kPlane, 0, 0, 0, {0, 1, 0}, 0, {}, 0, {0, 0, 0, 1}, {0, 0, 1}, 0}));
  ASSERT_TRUE(file.asset().is_open());
  std::vector<Vec3> ends(file.asset().bones().size(), Vec3{0, -9, 0.1f});
  EXPECT_EQ(worst_penetration(file.asset(), ends), 0.0f);
  ends[2].z = -0.05f;
  EXPECT_NEAR(worst_penetration(file.asset(), ends), 0.5f, 1e-5f);
}

TEST(WorstPenetration, CountsOnlyCollidersOfTheBonesSet) {
  AssetContents contents =
      with_collider({ColliderShape::kSphere, 0, 0, 0, {0, 0, 0}, 0, {1, 1, 1}, 0, {0, 0, 0, 1}, {}, 0});
  contents.bones[3].colliders = 0;
  const OpenAsset file(contents);
  ASSERT_TRUE(file.asset().is_open());
  std::vector<Vec3> ends(file.asset().bones().size(), Vec3{9, 9, 9});
  ends[3] = {0, 0, 0};
  EXPECT_EQ(worst_penetration(file.asset(), ends), 0.0f);
}

TEST(WorstPenetration, LeavesRigidBonesOut) {
  const OpenAsset file(
      with_collider({ColliderShape::kSphere, 0, 0, 0, {0, 0, 0}, 0, {1, 1, 1}, 0, {0, 0, 0, 1}, {}, 0}));
  ASSERT_TRUE(file.asset().is_open());
  std::vector<Vec3> ends(file.asset().bones().size(), Vec3{9, 9, 9});
  ends[0] = ends[1] = {0, 0, 0};
  EXPECT_EQ(worst_penetration(file.asset(), ends), 0.0f);
}

}  // namespace coif::animation::recording_test
