// Limits of spring bones as VRM 1.0 writes them. Expected numbers are worked out by hand from the text of
// VRMC_springBone_limit-1.0: the shortest turn of +Y to the bone, in the joint's own space, and `rotation` inside of
// it.

#include "import/imported_model.h"
#include "import/model_files.h"
#include "import/source_model.h"

#include <gtest/gtest.h>

#include <numbers>

namespace coif::importer::vrm_limits_test {

using Eigen::Vector3d;
using Kind = SourceLimit::Kind;
using test::import_or_fail;
using test::small_vrm;
using test::SmallGltf;
using test::spring_bone_1;
using test::TemporaryFolder;
using test::warnings_of;
using test::warns;

std::string joint(int node, const std::string& limit) {
  return R"({"node": )" + std::to_string(node) +
         R"(, "extensions": {"VRMC_springBone_limit": {"specVersion": "1.0-draft", "limit": )" + limit + "}}}";
}

class VrmLimits : public testing::Test {
 protected:
  SourceModel import_joints(const std::string& joints) {
    return import_or_fail(
        small_vrm(spring_bone_1(R"([{"name": "tail", "joints": [)" + joints + "]}]")).write(folder_, "m.gltf"));
  }
  /// The limit of hair_1, which hangs straight down; the model is kept in `model_`.
  const SourceLimit& first_limit(const std::string& limit) {
    model_ = import_joints(joint(3, limit) + R"(, {"node": 4})");
    return model_.springs.at(0).joints.at(0).limit;
  }
  TemporaryFolder folder_;
  SourceModel model_;
};

void expect_axes(const Eigen::Quaterniond& rotation, const Vector3d& x, const Vector3d& y) {
  EXPECT_LT((rotation * Vector3d::UnitX() - x).norm(), 1.0e-6) << (rotation * Vector3d::UnitX()).transpose();
  EXPECT_LT((rotation * Vector3d::UnitY() - y).norm(), 1.0e-6) << (rotation * Vector3d::UnitY()).transpose();
}

TEST_F(VrmLimits, EachKindHasItsAngles) {
  SourceLimit limit = first_limit(R"({"cone": {"angle": 0.7}})");
  EXPECT_EQ(limit.kind, Kind::kCone);
  EXPECT_EQ(limit.angles[0], 0.7);
  EXPECT_EQ(limit.angles[1], 0);
  limit = first_limit(R"({"hinge": {"angle": 0}})");
  EXPECT_EQ(limit.kind, Kind::kHinge);
  EXPECT_EQ(limit.angles[0], 0);
  limit = first_limit(R"({"spherical": {"pitch": 0.5, "yaw": 0.25}})");
  EXPECT_EQ(limit.kind, Kind::kSpherical);
  EXPECT_EQ(limit.angles[0], 0.5);
  EXPECT_EQ(limit.angles[1], 0.25);
  EXPECT_TRUE(model_.warnings.empty()) << warnings_of(model_);
  EXPECT_EQ(import_joints(R"({"node": 3}, {"node": 4})").springs[0].joints[0].limit.kind, Kind::kUnlimited);
}

TEST_F(VrmLimits, AnglesBeyondTheMostAreTheMost) {
  EXPECT_EQ(first_limit(R"({"cone": {"angle": 9}})").angles[0], std::numbers::pi);
  const SourceLimit limit = first_limit(R"({"spherical": {"pitch": 9, "yaw": 3}})");
  EXPECT_EQ(limit.angles[0], std::numbers::pi);
  EXPECT_EQ(limit.angles[1], std::numbers::pi / 2);
}

TEST_F(VrmLimits, ABoneStraightDownIsHalfATurnAboutXAndItsRotationLiesWithin) {
  expect_axes(first_limit(R"({"hinge": {"angle": 1}})").rotation, Vector3d::UnitX(), -Vector3d::UnitY());
  // A quarter turn about the limit's own y takes its x to -z, and half a turn about x that to +z.
  expect_axes(first_limit(R"({"hinge": {"angle": 1, "rotation": [0, 0.70710678, 0, 0.70710678]}})").rotation,
              Vector3d::UnitZ(), -Vector3d::UnitY());
}

TEST_F(VrmLimits, AxesAreThoseOfTheJointAtRestAndTheBonesDirectionInIt) {
  SmallGltf file =
      small_vrm(spring_bone_1(R"([{"joints": [)" + joint(3, R"({"hinge": {"angle": 1}})") + R"(, {"node": 4}]}])"));
  // The head is turned a quarter about Z, so that the hair's own +X is the model's +Y, and its own +Z is the model's.
  file.nodes = R"([{"name": "strip", "mesh": 0}, {"name": "body", "children": [2]},
    {"name": "head", "children": [3], "translation": [0, 1, 0], "rotation": [0, 0, 0.70710678, 0.70710678]},
    {"name": "hair", "children": [4], "translation": [0.1, 0, 0]}, {"name": "tip", "translation": [0, 0, 0.2]},
    {"name": "unused"}])";
  const SourceModel model = import_or_fail(file.write(folder_, "m.gltf"));
  ASSERT_EQ(model.springs.size(), 1u) << warnings_of(model);
  // In its own space the bone leads along +Z: the shortest turn of +Y there is about X, which in the model is +Y.
  expect_axes(model.springs[0].joints[0].limit.rotation, Vector3d::UnitY(), Vector3d::UnitZ());
}

TEST_F(VrmLimits, TheLastJointHasNone) {
  const SourceModel model = import_joints(R"({"node": 3}, )" + joint(4, R"({"cone": {"angle": 1}})"));
  EXPECT_EQ(model.springs[0].joints[1].limit.kind, Kind::kUnlimited);
  EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
}

TEST_F(VrmLimits, WhatIsNoLimitIsIgnoredWithAWarning) {
  for (const char* limit :
       {"{}", "3", R"({"cone": {"angle": 1}, "hinge": {"angle": 1}})", R"({"cone": {}})", R"({"cone": {"angle": -1}})",
        R"({"spherical": {"pitch": 1}})", R"({"hinge": {"angle": 1, "rotation": [0, 0, 0, 0]}})",
        R"({"hinge": {"angle": 1, "rotation": [0, 1]}})", R"({"hinge": {"angle": 1, "rotation": [0, 0, 0, 2]}})"}) {
    EXPECT_EQ(first_limit(limit).kind, Kind::kUnlimited) << limit;
    EXPECT_TRUE(warns(model_, "spring 'tail': a joint's limit")) << limit << ": " << warnings_of(model_);
    EXPECT_EQ(find_model_fault(model_), "");
  }
}

}  // namespace coif::importer::vrm_limits_test
