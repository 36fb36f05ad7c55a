// Spring bones, colliders and the head as both versions of VRM write them.

#include "import/imported_model.h"
#include "import/model_files.h"
#include "import/source_model.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::importer::vrm_springs_test {

using Eigen::Vector3d;
using test::import_or_fail;
using test::small_vrm;
using test::SmallGltf;
using test::spring_bone_0;
using test::spring_bone_1;
using test::TemporaryFolder;
using test::warnings_of;
using test::warns;

const std::string kTwoJoints = R"("joints": [{"node": 3}, {"node": 4}])";

class VrmSprings : public testing::Test {
 protected:
  SourceModel import_with(const std::string& extensions, const ImportSettings& settings = {}) {
    return import_or_fail(small_vrm(extensions).write(folder_, "m.gltf"), settings);
  }
  static std::string name_of(const SourceModel& model, std::uint32_t node) {
    return node < model.nodes.size() ? model.nodes[node].name : "none";
  }
  static std::string joints_of(const SourceModel& model, const SourceSpring& spring) {
    std::string names;
    for (const SourceSpringJoint& joint : spring.joints) names += name_of(model, joint.node) + " ";
    return names;
  }
  TemporaryFolder folder_;
};

TEST_F(VrmSprings, AVersion1SpringCarriesItsJointsSettings) {
  const SourceModel model = import_with(spring_bone_1(R"([{"name": "tail", "center": 2, "joints": [
      {"node": 3, "stiffness": 0.5, "gravityPower": 0.25, "gravityDir": [1, 0, 0], "dragForce": 0.75,
       "hitRadius": 0.02}, {"node": 4}, {"node": 5}]}])"));
  ASSERT_EQ(model.springs.size(), 1u) << warnings_of(model);
  EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
  const SourceSpring& spring = model.springs[0];
  EXPECT_EQ(spring.name, "tail");
  EXPECT_EQ(name_of(model, spring.center), "head");
  EXPECT_EQ(joints_of(model, spring), "hair_1 hair_2 hair_end ");
  EXPECT_EQ(spring.joints[0].stiffness, 0.5);
  EXPECT_EQ(spring.joints[0].gravity_power, 0.25);
  EXPECT_EQ(spring.joints[0].gravity_direction, Vector3d::UnitX());
  EXPECT_EQ(spring.joints[0].drag, 0.75);
  EXPECT_EQ(spring.joints[0].hit_radius, 0.02);
  EXPECT_NEAR(spring.joints[0].length, 0.1, 1.0e-7);
  EXPECT_EQ(spring.joints[2].length, 0.0) << "the last joint is an end";
  const SourceSpringJoint& by_default = spring.joints[1];
  EXPECT_EQ(by_default.stiffness, 1.0);
  EXPECT_EQ(by_default.gravity_power, 0.0);
  EXPECT_EQ(by_default.gravity_direction, Vector3d(0, -1, 0));
  EXPECT_EQ(by_default.drag, 0.5);
  EXPECT_EQ(by_default.hit_radius, 0.0);
}

TEST_F(VrmSprings, AJointThatSkipsNodesReachesToTheNextOne) {
  const SourceModel model = import_with(spring_bone_1(R"([{"joints": [{"node": 3}, {"node": 5}]}])"));
  ASSERT_EQ(model.springs.size(), 1u);
  EXPECT_NEAR(model.springs[0].joints[0].length, 0.2, 1.0e-7);
}

TEST_F(VrmSprings, Version1CollidersComeInModelSpace) {
  const SourceModel model =
      import_with(spring_bone_1("[{" + kTwoJoints + R"(, "colliderGroups": [1, 0]}])",
                                R"([{"node": 2, "shape": {"sphere": {"offset": [0.1, 0.2, 0.3], "radius": 0.5}}},
          {"node": 1, "shape": {"capsule": {"offset": [0, 0, 0], "radius": 0.25, "tail": [0, 2, 0]}}}])",
                                R"([{"colliders": [1]}, {"colliders": [0]}])"));
  ASSERT_EQ(model.colliders.size(), 2u) << warnings_of(model);
  EXPECT_EQ(model.colliders[0].shape, SourceCollider::Shape::kSphere);
  EXPECT_TRUE(model.colliders[0].center.isApprox(Vector3d(0.1, 1.2, 0.3), 1.0e-6));
  EXPECT_EQ(name_of(model, model.colliders[0].node), "head");
  EXPECT_EQ(model.colliders[1].shape, SourceCollider::Shape::kCapsule);
  EXPECT_TRUE(model.colliders[1].tail.isApprox(Vector3d(0, 2, 0), 1.0e-6));
  ASSERT_EQ(model.springs.size(), 1u);
  EXPECT_EQ(model.springs[0].colliders, (std::vector<std::uint32_t>{0, 1}));
}

TEST_F(VrmSprings, ExtendedShapesReplaceThePlainOnes) {
  const auto extended = [](const std::string& shape) {
    return R"({"node": 2, "shape": {"sphere": {"offset": [0, -10000, 0], "radius": 0}}, "extensions":
        {"VRMC_springBone_extended_collider": {"specVersion": "1.0", "shape": )" +
           shape + "}}}";
  };
  const SourceModel model = import_with(
      spring_bone_1("[]", "[" + extended(R"({"sphere": {"radius": 0.5, "inside": true}})") + "," +
                              extended(R"({"capsule": {"radius": 0.1, "tail": [0, 1, 0], "inside": true}})") + "," +
                              extended(R"({"plane": {"offset": [0, 1, 0], "normal": [0, 2, 0]}})") + "," +
                              extended(R"({"cone": {}})") + "]"));
  ASSERT_EQ(model.colliders.size(), 4u) << warnings_of(model);
  EXPECT_TRUE(model.colliders[0].keeps_inside);
  EXPECT_TRUE(model.colliders[0].center.isApprox(Vector3d(0, 1, 0)));
  EXPECT_EQ(model.colliders[1].shape, SourceCollider::Shape::kCapsule);
  EXPECT_TRUE(model.colliders[1].keeps_inside);
  EXPECT_EQ(model.colliders[2].shape, SourceCollider::Shape::kPlane);
  EXPECT_TRUE(model.colliders[2].normal.isApprox(Vector3d::UnitY()));
  EXPECT_FALSE(model.colliders[2].keeps_inside);
  EXPECT_NEAR(model.colliders[3].center.y(), -9999, 1.0) << "an unknown shape falls back to the plain one";
}

TEST_F(VrmSprings, AVersion0RootSwingsWithEverythingBelowIt) {
  SmallGltf file = small_vrm(spring_bone_0(
      R"([{"stiffiness": 2, "gravityPower": 0.5, "gravityDir": {"x": 0, "y": 0, "z": 1}, "dragForce": 0.25,
           "hitRadius": 0.03, "center": -1, "bones": [3]}])"));
  file.nodes = R"([{"name": "strip", "mesh": 0}, {"name": "body", "children": [2]},
    {"name": "head", "children": [3], "translation": [0, 1, 0]},
    {"name": "hair", "children": [4, 5], "translation": [0, -0.1, 0]},
    {"name": "left", "translation": [0.2, 0, 0]},
    {"name": "right", "children": [6], "translation": [-0.2, 0, 0]}, {"name": "right_end", "translation": [0, -1, 0]}])";
  const SourceModel model = import_or_fail(file.write(folder_, "m.gltf"));
  ASSERT_EQ(model.springs.size(), 2u) << warnings_of(model);
  EXPECT_EQ(joints_of(model, model.springs[0]), "hair left ") << "a joint's tail is its first child";
  EXPECT_EQ(joints_of(model, model.springs[1]), "right right_end ") << "a further child starts a spring of its own";
  EXPECT_NEAR(model.springs[0].joints[0].length, 0.2, 1.0e-7);
  EXPECT_NEAR(model.springs[0].joints[1].length, 0.07, 1.0e-7) << "a leaf has a tail of 7 cm";
  EXPECT_NEAR(model.springs[1].joints[0].length, 1.0, 1.0e-7);
  const SourceSpringJoint& joint = model.springs[1].joints[1];
  EXPECT_EQ(joint.stiffness, 2.0);
  EXPECT_EQ(joint.gravity_power, 0.5);
  EXPECT_EQ(joint.gravity_direction, Vector3d(0, 0, -1)) << "left-handed in the file";
  EXPECT_EQ(joint.drag, 0.25);
  EXPECT_EQ(joint.hit_radius, 0.03);
  EXPECT_EQ(model.springs[0].center, kNoIndex);
  EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
}

TEST_F(VrmSprings, Version0CollidersAreLeftHandedSpheres) {
  const SourceModel model = import_with(
      spring_bone_0(R"([{"bones": [3], "colliderGroups": [0]}])",
                    R"([{"node": 2, "colliders": [{"offset": {"x": 0.1, "y": 0.2, "z": 0.3}, "radius": 0.4}]}])"));
  ASSERT_EQ(model.colliders.size(), 1u);
  EXPECT_TRUE(model.colliders[0].center.isApprox(Vector3d(0.1, 1.2, -0.3), 1.0e-6));
  EXPECT_NEAR(model.colliders[0].radius, 0.4, 1.0e-9);
  ASSERT_EQ(model.springs.size(), 1u);
  EXPECT_EQ(model.springs[0].colliders, (std::vector<std::uint32_t>{0}));
}

TEST_F(VrmSprings, TheHumanoidsHeadIsTheHeadInBothVersions) {
  EXPECT_EQ(import_with(R"("KHR_nothing": {})").head_node, kNoIndex);
  const SourceModel old = import_with(spring_bone_0("[]"));
  EXPECT_EQ(name_of(old, old.head_node), "head");
  EXPECT_EQ(old.facing, Facing::kBackwards) << "VRM 0.x looks along -Z";
  const SourceModel now = import_with(R"("VRMC_vrm": {"humanoid": {"humanBones": {"head": {"node": 3}}}})");
  EXPECT_EQ(name_of(now, now.head_node), "hair_1");
  EXPECT_EQ(now.facing, Facing::kForwards) << "VRM 1.0 looks along +Z";
  const SourceModel wrong = import_with(R"("VRMC_vrm": {"humanoid": {"humanBones": {"head": {"node": 99}}}})");
  EXPECT_EQ(wrong.head_node, kNoIndex);
  EXPECT_TRUE(warns(wrong, "head is found by its name")) << warnings_of(wrong);
}

TEST_F(VrmSprings, UnitsAndAxesOfTheImportReachSpringsToo) {
  ImportSettings settings = test::with_unit(0.5);
  settings.up_axis = UpAxis::kZ;
  const SourceModel model =
      import_with(spring_bone_1(R"([{"joints": [{"node": 3, "stiffness": 1, "gravityPower": 2, "gravityDir": [0, 0, -1],
                         "hitRadius": 0.02}, {"node": 4}], "colliderGroups": [0]}])",
                                R"([{"node": 2, "shape": {"sphere": {"offset": [0, 0, 1], "radius": 0.5}}}])",
                                R"([{"colliders": [0]}])"),
                  settings);
  ASSERT_EQ(model.springs.size(), 1u);
  const SourceSpringJoint& joint = model.springs[0].joints[0];
  EXPECT_TRUE(joint.gravity_direction.isApprox(Vector3d(0, -1, 0)));
  EXPECT_NEAR(joint.length, 0.05, 1.0e-7);
  EXPECT_NEAR(joint.hit_radius, 0.01, 1.0e-9);
  EXPECT_NEAR(joint.stiffness, 0.5, 1.0e-9);
  EXPECT_NEAR(joint.gravity_power, 1.0, 1.0e-9);
  EXPECT_NEAR(model.colliders[0].radius, 0.25, 1.0e-7);
  EXPECT_TRUE(model.colliders[0].center.isApprox(Vector3d(0, 0.5, -0.5), 1.0e-6)) << model.colliders[0].center;
}

TEST_F(VrmSprings, ScaledNodesScaleTheirColliders) {
  SmallGltf file =
      small_vrm(spring_bone_1("[]", R"([{"node": 1, "shape": {"sphere": {"offset": [1, 0, 0], "radius": 0.5}}}])"));
  file.nodes = R"([{"name": "strip", "mesh": 0}, {"name": "body", "scale": [2, 3, 2]}])";
  const SourceModel model = import_or_fail(file.write(folder_, "m.gltf"));
  ASSERT_EQ(model.colliders.size(), 1u);
  EXPECT_NEAR(model.colliders[0].radius, 1.5, 1.0e-6);
  EXPECT_NEAR(model.colliders[0].center.x(), 2.0, 1.0e-6);
}

TEST_F(VrmSprings, BinaryFilesAreReadAlike) {
  const std::string glb = test::as_glb(small_vrm(spring_bone_1("[{" + kTwoJoints + "}]")).write(folder_, "m.gltf"));
  for (const char* name : {"m.glb", "m.vrm"}) {
    const SourceModel model = import_or_fail(folder_.write(name, glb));
    ASSERT_EQ(model.springs.size(), 1u) << name;
    EXPECT_EQ(joints_of(model, model.springs[0]), "hair_1 hair_2 ");
  }
}

}  // namespace coif::importer::vrm_springs_test
