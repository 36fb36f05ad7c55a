#include "cook/select/head_landmarks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace coif::cook::head_landmarks_test {

using Eigen::Vector3d;

const HeadEllipsoid kHead{{0.02, 1.65, 0.04}, {0.08, 0.092, 0.093}};

/// A point in semi-axes from the head's centre, the face at +1, in metres.
Vector3d at(const HeadEllipsoid& head, const Vector3d& in_axes) {
  return head.center + in_axes.cwiseProduct(head.radii);
}

/// Where rigs have their joints, for a head that looks along `forwards` Z.
HeadLandmarks usual_landmarks(const HeadEllipsoid& head, double forwards) {
  HeadLandmarks marks;
  marks.forwards = forwards;
  marks.joint = at(head, {0, -0.95, -0.15 * forwards});
  marks.neck = *marks.joint - Vector3d(0, 0.7 * head.radii.y(), 0);
  marks.eyes = {at(head, {0.4, -0.14, 0.6 * forwards}), at(head, {-0.4, -0.14, 0.6 * forwards})};
  return marks;
}

void expect_close(const HeadEllipsoid& found, const HeadEllipsoid& head, double most) {
  EXPECT_LT((found.center - head.center).cwiseQuotient(head.radii).norm(), most);
  for (int k = 0; k < 3; ++k) EXPECT_LT(std::abs(std::log(found.radii[k] / head.radii[k])), most) << "axis " << k;
}

HeadEllipsoid scaled(double size) { return {size * kHead.center, size * kHead.radii}; }

TEST(HeadLandmarks, JointsAloneShowAHeadOfAnySize) {
  for (const double size : {0.2, 1.0, 5.0}) {
    for (const double forwards : {1.0, -1.0})
      expect_close(likeliest_head(usual_landmarks(scaled(size), forwards)), scaled(size), 0.12);
  }
}

TEST(HeadLandmarks, AFaceWhoseSkullIsCutAwayIsStillAHead) {
  HeadLandmarks marks;
  marks.forwards = 1;
  marks.joint = at(kHead, {0, -0.95, -0.15});
  marks.mesh = Eigen::AlignedBox3d(at(kHead, {-1, -1, -0.1}), at(kHead, {1, 0.3, 1.05}));
  marks.mesh_vertices = 200;
  expect_close(likeliest_head(marks), kHead, 0.25);
}

TEST(HeadLandmarks, OneThatIsOffCountsLittle) {
  HeadLandmarks marks = usual_landmarks(kHead, 1);
  marks.end = at(kHead, {0, 4, 0});  // The tip of a hat.
  expect_close(likeliest_head(marks), kHead, 0.2);
  marks = usual_landmarks(kHead, 1);
  marks.neck = *marks.joint - Vector3d(0, 3 * kHead.radii.y(), 0);  // A giraffe's.
  expect_close(likeliest_head(marks), kHead, 0.2);
}

TEST(HeadLandmarks, ALikelierHeadIsLessOfASurprise) {
  const HeadLandmarks marks = usual_landmarks(kHead, 1);
  const double best = surprise(likeliest_head(marks), marks);
  EXPECT_LE(best, surprise(kHead, marks) + 1e-6);
  for (const double size : {0.5, 2.0}) EXPECT_GT(surprise({kHead.center, size * kHead.radii}, marks), best + 5);
}

/// Hips, neck and head, with a few triangles of hair above.
importer::SourceModel rig(const std::vector<std::pair<std::string, Vector3d>>& below_head) {
  importer::SourceModel model;
  const auto add = [&](const std::string& name, std::uint32_t parent, const Vector3d& place) {
    model.nodes.push_back({name, parent, Eigen::Affine3d(Eigen::Translation3d(place))});
  };
  add("Hips", importer::kNoIndex, {0, 1, 0});
  add("Neck", 0, {0, 1.48, 0});
  add("Head", 1, {0, 1.56, 0});
  for (const auto& [name, place] : below_head) add(name, name.starts_with("Toe") ? 0 : 2, place);
  return model;
}

HairMesh tuft() {
  HairMesh hair;
  hair.positions = {{-0.05f, 1.75f, 0}, {0.05f, 1.75f, 0}, {0, 1.75f, 0.05f}};
  hair.triangles = {0, 1, 2};
  return hair;
}

HeadLandmarks landmarks_of(const importer::SourceModel& model) {
  HeadBone bone;
  bone.node = 2;
  bone.name = "Head";
  bone.joint = {0, 1.56, 0};
  return find_landmarks(model, tuft(), bone);
}

TEST(HeadLandmarks, EyesSayWhichWayAHeadLooks) {
  for (const double z : {0.06, -0.06}) {
    const HeadLandmarks marks = landmarks_of(rig({{"LeftEye", {0.03, 1.63, z}}, {"RightEye", {-0.03, 1.63, z}}}));
    ASSERT_TRUE(marks.joint && marks.neck && marks.eyes && marks.show_size());
    EXPECT_EQ(marks.forwards, z > 0 ? 1 : -1);
  }
}

TEST(HeadLandmarks, WhatIsNoPairOfEyeballsIsNotTakenForOne) {
  for (const auto& nodes : std::vector<std::vector<std::pair<std::string, Vector3d>>>{
           {{"LeftEye", {0.03, 1.63, 0.06}}},
           {{"LeftEye", {0.03, 1.63, 0.06}}, {"RightEye", {-0.06, 1.68, 0.02}}},
           {{"LeftEyelid", {0.03, 1.63, 0.06}}, {"RightEyelid", {-0.03, 1.63, 0.06}}},
           {{"EyeTarget_L", {0.03, 1.63, 1}}, {"EyeTarget_R", {-0.03, 1.63, 1}}}}) {
    EXPECT_FALSE(landmarks_of(rig(nodes)).eyes) << nodes[0].first;
  }
}

TEST(HeadLandmarks, ABoneOfHairIsNoJointOfAHead) {
  importer::SourceModel model = rig({});
  model.nodes[0].name = model.nodes[1].name = "Armature";
  model.nodes[2].name = "hair_root";
  EXPECT_FALSE(landmarks_of(model).joint);
  EXPECT_FALSE(landmarks_of(model).show_size());
}

}  // namespace coif::cook::head_landmarks_test
