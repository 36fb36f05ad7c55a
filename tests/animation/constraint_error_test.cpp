#include "animation/constraint_error.h"

#include "animation/open_asset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace coif {
namespace {

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

}  // namespace
}  // namespace coif
