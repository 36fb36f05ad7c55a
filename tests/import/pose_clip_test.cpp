#include "import/clip_file.h"

#include "import/model_files.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::importer::test::pose_clip_test {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using nlohmann::json;
using Kind = ToolError::Kind;

const std::vector<float> kTimes{0, 0.5f, 1};

double turn_of(double seconds) { return 0.8 * seconds; }

/// A head with hair on it: head > a > b.
ClipDocument hair() {
  ClipDocument clip;
  clip.document["nodes"] =
      json::array({{{"name", "head"}, {"children", {1}}},
                   {{"name", "a"}, {"children", {2}}, {"rotation", {0, 0, std::sqrt(0.5), std::sqrt(0.5)}}},
                   {{"name", "b"}}});
  return clip;
}

const std::vector<PosedBone> kBones{{"head", -1}, {"a", 0}, {"b", 1}, {"c", 2}};

class PoseClipTest : public testing::Test {
 protected:
  tl::expected<std::shared_ptr<const PoseClip>, ToolError> read(const ClipDocument& clip,
                                                                std::span<const PosedBone> bones = kBones) {
    return read_pose_clip(folder_.write("clip.gltf", clip.text()), bones);
  }
  static void expect_turn(const Quaterniond& rotation, double radians, const Vector3d& axis) {
    EXPECT_LT(rotation.angularDistance(Quaterniond(AngleAxisd(radians, axis))), 1e-6);
  }

  TemporaryFolder folder_;
};

TEST_F(PoseClipTest, TurnsBonesInTheModelsAxesFromRest) {
  // b turns about its own X, which at rest is the model's Y, as a is turned a quarter about Z.
  auto clip = hair();
  const auto read_back = read(clip.animate(2, "rotation", kTimes, turns_about_x(kTimes, turn_of)));
  ASSERT_TRUE(read_back) << read_back.error().message;
  EXPECT_EQ((*read_back)->found(), 3u);
  for (const double seconds : {0.0, 0.5, 0.8, 1.0, 7.0}) {
    const auto rotations = (*read_back)->at(seconds);
    ASSERT_EQ(rotations.size(), 4u);
    expect_turn(rotations[1], 0, Vector3d::UnitX());
    expect_turn(rotations[2], turn_of(std::min(seconds, 1.0)), Vector3d::UnitY());
    expect_turn(rotations[3], 0, Vector3d::UnitX());
  }
}

TEST_F(PoseClipTest, WhatTheHeadDoesIsNotTheHairs) {
  auto clip = hair();
  clip.animate(0, "rotation", kTimes, turns_about_x(kTimes, [](double t) { return 2 * t; }));
  clip.animate(2, "rotation", kTimes, turns_about_x(kTimes, turn_of));
  for (const bool knows_head : {true, false}) {
    std::vector<PosedBone> bones = kBones;
    if (!knows_head) bones[0].name = "Kopf";
    const auto read_back = read(clip, bones);
    ASSERT_TRUE(read_back);
    const auto rotations = (*read_back)->at(1);
    expect_turn(rotations[1], 0, Vector3d::UnitX());
    expect_turn(rotations[2], turn_of(1), Vector3d::UnitY());
  }
}

TEST_F(PoseClipTest, NodesBetweenABoneAndItsParentCount) {
  auto clip = hair();
  clip.animate(1, "rotation", {0, 1}, {0, 0, std::sqrt(0.5f), std::sqrt(0.5f), 0, 0, 1, 0});
  const std::vector<PosedBone> bones{{"head", -1}, {"b", 0}};
  const auto read_back = read(clip, bones);
  EXPECT_FALSE(read_back) << "a's turning is of no bone that was asked for";
  clip.animate(2, "rotation", kTimes, turns_about_x(kTimes, [](double) { return 0.0; }));
  const auto with_b = read(clip, bones);
  ASSERT_TRUE(with_b);
  expect_turn((*with_b)->at(1)[1], std::acos(-1.0) / 2, Vector3d::UnitZ());
}

TEST_F(PoseClipTest, RefusesClipsThatSayNothingOfTheHair) {
  auto clip = hair();
  clip.animate(0, "rotation", kTimes, turns_about_x(kTimes, turn_of));
  const auto refusal = [&](const ClipDocument& bad, std::span<const PosedBone> bones) {
    const auto read_back = read(bad, bones);
    EXPECT_FALSE(read_back);
    EXPECT_EQ(read_back.error().kind, Kind::kBadInput);
    return read_back.error().message;
  };
  const std::vector<PosedBone> others{{"x", -1}, {"", 0}};
  EXPECT_NE(refusal(clip, others).find("no node has the name of one of the hair's 2 bones"), std::string::npos);
  const std::vector<PosedBone> still{{"a", -1}, {"b", 0}};
  EXPECT_NE(refusal(clip, still).find("no animation turns a bone of the hair"), std::string::npos);
  EXPECT_EQ(read_pose_clip(folder_.path() / "absent.glb", kBones).error().kind, Kind::kFileAccess);
  EXPECT_EQ(read_pose_clip(folder_.write("a.fbx", "Kaydara"), kBones).error().kind, Kind::kUnsupported);
}

TEST_F(PoseClipTest, ABufferThatIsNamedOtherwiseIsTold) {
  const auto clip = hair().animate(2, "rotation", kTimes, turns_about_x(kTimes, turn_of));
  folder_.write("Turn.bin", clip.buffer());
  const auto read_back = read_pose_clip(folder_.write("c.gltf", clip.text_beside("turn.bin")), kBones);
  ASSERT_TRUE(read_back) << read_back.error().message;
  ASSERT_EQ((*read_back)->notes().size(), 1u);
  EXPECT_NE((*read_back)->notes().front().find("'Turn.bin' is taken for it"), std::string::npos);
}

TEST_F(PoseClipTest, FollowsNoNameThatTwoNodesHave) {
  auto clip = hair();
  clip.document["nodes"][2]["name"] = "a";
  clip.animate(0, "rotation", kTimes, turns_about_x(kTimes, turn_of));
  const auto read_back = read(clip);
  ASSERT_TRUE(read_back);
  EXPECT_EQ((*read_back)->found(), 1u);
  ASSERT_EQ((*read_back)->notes().size(), 1u);
  EXPECT_NE((*read_back)->notes().front().find("2 nodes are called 'a'"), std::string::npos);
}

}  // namespace coif::importer::test::pose_clip_test
