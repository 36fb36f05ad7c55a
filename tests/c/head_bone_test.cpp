// Poses from an engine's bones in C: the same bits as in C++, and a status for null.

#include <coif.h>
#include <coif/head_bone.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace coif::c_head_bone_test {

/// A head that is turned about the vertical, in a rig of centimetres; as columns.
constexpr float kTurned[16] = {0, 0, -0.01f, 0, 0, 0.01f, 0, 0, 0.01f, 0, 0, 0, 0.5f, 1.6f, -2, 1};
constexpr float kAtRest[16] = {0.01f, 0, 0, 0, 0, 0.01f, 0, 0, 0, 0, 0.01f, 0, 0, 1.6f, 0, 1};

TEST(CHeadBone, GivesTheBitsOfCpp) {
  coif_bone_matrix bone;
  coif_head_bone head_bone;
  coif_head_bone_init(&head_bone);
  EXPECT_EQ(head_bone.metres_per_unit, 1);
  EXPECT_EQ(head_bone.largest_stretch, HeadBone{}.largest_stretch);
  coif_bone_matrix_of_columns(&bone, kTurned);
  coif_bone_matrix_of_columns(&head_bone.rest, kAtRest);
  head_bone.origin[1] = 0.125;
  head_bone.metres_per_unit = 2;
  coif_head_pose pose;
  ASSERT_EQ(coif_head_pose_of_bone(&bone, &head_bone, &pose), COIF_OK);
  HeadPose same;
  const HeadBone its{.rest = bone_matrix_of_columns(kAtRest), .origin = {0, 0.125, 0}, .metres_per_unit = 2};
  ASSERT_EQ(head_pose_of_bone(bone_matrix_of_columns(kTurned), its, same), Status::kOk);
  EXPECT_EQ(std::memcmp(&pose, &same, sizeof pose), 0);
  EXPECT_NEAR(pose.rotation[1], std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(pose.scale, 1, 1e-6);
  EXPECT_NEAR(pose.position[1], 3.325, 1e-6);

  EXPECT_EQ(coif_bone_is_mirrored(&bone, &head_bone), 0);
  for (double(&row)[4] : bone.m) row[2] = -row[2];
  EXPECT_EQ(coif_bone_is_mirrored(&bone, &head_bone), 1);
  EXPECT_EQ(coif_head_pose_of_bone(&bone, &head_bone, &pose), COIF_OK);
}

TEST(CHeadBone, ReadsAndInvertsMatrices) {
  const float rows[12] = {0, 0, 0.01f, 0.5f, 0, 0.01f, 0, 1.6f, -0.01f, 0, 0, -2};
  coif_bone_matrix matrix, same, inverse;
  coif_bone_matrix_of_rows(&matrix, rows);
  coif_bone_matrix_of_columns(&same, kTurned);
  EXPECT_EQ(std::memcmp(&matrix, &same, sizeof matrix), 0);
  ASSERT_EQ(coif_invert_bone_matrix(&matrix, &inverse), COIF_OK);
  EXPECT_NEAR(inverse.m[0][2], -100, 1e-4);
  EXPECT_NEAR(inverse.m[0][3], -200, 1e-4);
  EXPECT_NEAR(inverse.m[2][3], -50, 1e-4);
}

TEST(CHeadBone, RefusesWhatItCannotUse) {
  coif_bone_matrix bone, kept;
  coif_bone_matrix_of_columns(&bone, kTurned);
  kept = bone;
  coif_head_bone head_bone;
  coif_head_bone_init(&head_bone);
  coif_head_pose pose;
  coif_head_pose_init(&pose);
  pose.position[0] = 7;
  const coif_head_pose before = pose;
  EXPECT_EQ(coif_head_pose_of_bone(nullptr, &head_bone, &pose), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_head_pose_of_bone(&bone, nullptr, &pose), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_head_pose_of_bone(&bone, &head_bone, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_head_pose_of_bone(&bone, &head_bone, &pose), COIF_BAD_SCALE) << "0.01, which the rest lacks";
  bone.m[1][3] = NAN;
  EXPECT_EQ(coif_head_pose_of_bone(&bone, &head_bone, &pose), COIF_BAD_POSE);
  EXPECT_EQ(coif_invert_bone_matrix(&bone, &kept), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_invert_bone_matrix(nullptr, &kept), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_invert_bone_matrix(&kept, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(std::memcmp(&pose, &before, sizeof pose), 0);
  EXPECT_EQ(kept.m[0][3], 0.5);
  EXPECT_EQ(coif_bone_is_mirrored(nullptr, &head_bone), 0);
  EXPECT_EQ(coif_bone_is_mirrored(&kept, nullptr), 0);
  coif_head_bone_init(nullptr);
  coif_bone_matrix_of_columns(nullptr, kTurned);
  coif_bone_matrix_of_columns(&kept, nullptr);
  coif_bone_matrix_of_rows(&kept, nullptr);
  EXPECT_EQ(kept.m[0][3], 0.5);
}

}  // namespace coif::c_head_bone_test
