// Spring bones that lie: what is wrong is left out and told, the rest comes through; and nodes that are hard to tell.

#include "import/imported_model.h"
#include "import/model_files.h"
#include "import/source_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace coif::importer::vrm_damage_test {

using test::import_or_fail;
using test::small_vrm;
using test::SmallGltf;
using test::spring_bone_0;
using test::spring_bone_1;
using test::TemporaryFolder;
using test::warnings_of;
using test::warns;

class VrmDamage : public testing::Test {
 protected:
  SourceModel import_file(const SmallGltf& file) { return import_or_fail(file.write(folder_, "m.gltf")); }
  SourceModel import_with(const std::string& extensions) { return import_file(small_vrm(extensions)); }

  /// Distance from the origin of every joint of the first spring, which tells nodes without names apart.
  static std::vector<double> heights_of_joints(const SourceModel& model) {
    std::vector<double> heights;
    if (model.springs.empty()) return heights;
    for (const SourceSpringJoint& joint : model.springs[0].joints) {
      heights.push_back(std::round(model.nodes[joint.node].model_from_node.translation().y() * 1000) / 1000);
    }
    return heights;
  }
  TemporaryFolder folder_;
};

TEST_F(VrmDamage, ReferencesToNothingAreLeftOutOfVersion1) {
  const SourceModel model = import_with(spring_bone_1(
      R"([{"name": "tail", "center": 77, "colliderGroups": [9, 0], "joints": [{"node": 3}, {"node": 99}, {"node": 4}]}])",
      R"([{"node": -1, "shape": {"sphere": {}}}, {"node": 2}, {"node": 2, "shape": {"sphere": {"radius": 0.1}}}])",
      R"([{"colliders": [0, 1, 2, 3]}])"));
  ASSERT_EQ(model.springs.size(), 1u) << warnings_of(model);
  EXPECT_EQ(model.springs[0].joints.size(), 2u);
  EXPECT_EQ(model.springs[0].center, kNoIndex);
  EXPECT_EQ(model.colliders.size(), 1u);
  EXPECT_EQ(model.springs[0].colliders.size(), 1u);
  for (const char* told :
       {"collider 0: its node is not in the scene", "collider 1: its shape is not known",
        "collider group 0: a collider is absent", "spring 'tail': a collider group is absent",
        "spring 'tail': its center is not in the scene", "spring 'tail': node '?' is not in the scene"}) {
    EXPECT_TRUE(warns(model, told)) << told << " is not in\n" << warnings_of(model);
  }
}

TEST_F(VrmDamage, ReferencesToNothingAreLeftOutOfVersion0) {
  const SourceModel model = import_with(spring_bone_0(R"([{"bones": [42, 3], "colliderGroups": [0, 7]}])",
                                                      R"([{"node": 50, "colliders": [{"radius": 1}]}])"));
  ASSERT_EQ(model.springs.size(), 1u) << warnings_of(model);
  EXPECT_TRUE(model.colliders.empty());
  EXPECT_TRUE(warns(model, "bone group 0: a root bone is not in the scene"));
  EXPECT_TRUE(warns(model, "bone group 0: a collider group is absent"));
  EXPECT_TRUE(warns(model, "collider group 0: its node is not in the scene"));
}

TEST_F(VrmDamage, ANodeSwingsOnce) {
  const std::string twice = R"({"joints": [{"node": 3}, {"node": 4}]})";
  const SourceModel now = import_with(spring_bone_1("[" + twice + "," + twice + "]"));
  EXPECT_EQ(now.springs.size(), 1u);
  EXPECT_TRUE(warns(now, "joint of two springs")) << warnings_of(now);
  const SourceModel old = import_with(spring_bone_0(R"([{"bones": [4, 3]}, {"bones": [4]}])"));
  ASSERT_EQ(old.springs.size(), 2u);
  EXPECT_EQ(old.springs[1].joints.size(), 1u) << "hair_1 alone: what is below it swings already";
  EXPECT_TRUE(warns(old, "'hair_2' is listed twice")) << warnings_of(old);
}

TEST_F(VrmDamage, JointsThatDoNotHangFromEachOtherAreLeftOut) {
  const SourceModel model = import_with(spring_bone_1(R"([{"joints": [{"node": 4}, {"node": 3}, {"node": 5}]}])"));
  ASSERT_EQ(model.springs.size(), 1u);
  EXPECT_EQ(model.springs[0].joints.size(), 2u);
  EXPECT_TRUE(warns(model, "'hair_1' is not below the joint before it")) << warnings_of(model);
}

TEST_F(VrmDamage, ASpringOfOneJointIsNone) {
  const SourceModel model = import_with(spring_bone_1(R"([{"name": "stub", "joints": [{"node": 3}]}, {}, 7])"));
  EXPECT_TRUE(model.springs.empty());
  EXPECT_TRUE(warns(model, "spring 'stub' is ignored")) << warnings_of(model);
}

TEST_F(VrmDamage, SettingsOutOfRangeAreLimited) {
  const SourceModel model = import_with(spring_bone_1(R"([{"name": "tail", "joints": [
      {"node": 3, "stiffness": -1, "gravityPower": 1e300, "gravityDir": [0, 0, 0], "dragForce": 3, "hitRadius": -2},
      {"node": 4}]}])"));
  ASSERT_EQ(model.springs.size(), 1u);
  const SourceSpringJoint& joint = model.springs[0].joints[0];
  EXPECT_EQ(joint.stiffness, 0.0);
  EXPECT_EQ(joint.drag, 1.0);
  EXPECT_EQ(joint.hit_radius, 0.0);
  EXPECT_LT(joint.gravity_power, 1.0e9);
  EXPECT_EQ(joint.gravity_direction, Eigen::Vector3d(0, -1, 0));
  EXPECT_TRUE(warns(model, "out of range were limited")) << warnings_of(model);
  EXPECT_TRUE(warns(model, "gravity has no direction")) << warnings_of(model);
}

TEST_F(VrmDamage, CollidersWithoutASizeOrPlaceAreLeftOut) {
  const SourceModel model = import_with(spring_bone_1("[]", R"([
      {"node": 2, "shape": {"sphere": {"radius": -1}}}, {"node": 2, "shape": {"sphere": {"offset": [1e200, 0, 0]}}},
      {"node": 2, "extensions": {"VRMC_springBone_extended_collider": {"shape": {"plane": {"normal": [0, 0, 0]}}}}}])"));
  EXPECT_TRUE(model.colliders.empty());
  for (const char* told : {"radius is no length", "place is not in the model", "normal has no direction"}) {
    EXPECT_TRUE(warns(model, told)) << told << " is not in\n" << warnings_of(model);
  }
}

TEST_F(VrmDamage, ValuesOfOtherTypesAreAsGoodAsAbsent) {
  for (const char* wrong : {"null", "true", "-3", "1e9", "0.5", "\"text\"", "[]", "{}", "[[[]]]", "[null, {}, 5]"}) {
    for (const char* key : {"springs", "colliders", "colliderGroups", "specVersion"}) {
      import_with(R"("VRMC_springBone": {")" + std::string(key) + "\": " + wrong + "}");
    }
    const std::string value = wrong;
    import_with(spring_bone_1("[{\"joints\": " + value + ", \"center\": " + value + ", \"name\": " + value + "}]"));
    import_with(spring_bone_1("[{\"joints\": [{\"node\": 3, \"gravityDir\": " + value + ", \"stiffness\": " + value +
                              "}, {\"node\": " + value + "}]}]"));
    import_with(spring_bone_1("[]", "[{\"node\": 2, \"shape\": " + value + ", \"extensions\": " + value + "}]"));
    import_with(spring_bone_0("[{\"bones\": " + value + ", \"gravityDir\": " + value + "}]",
                              "[{\"node\": " + value + ", \"colliders\": " + value + "}]"));
    import_with("\"VRM\": " + value + ", \"VRMC_vrm\": {\"humanoid\": " + value + "}");
  }
}

TEST_F(VrmDamage, AThousandFaultsGiveADozenWarnings) {
  std::string springs = "[{}";
  for (int i = 0; i < 1000; ++i) springs += ", {}";
  const SourceModel model = import_with(spring_bone_1(springs + "]"));
  EXPECT_LT(model.warnings.size(), 20u);
  EXPECT_TRUE(warns(model, "989 more faults")) << warnings_of(model);
}

TEST_F(VrmDamage, MoreCollidersThanAreReadAreCounted) {
  std::string colliders = "[";
  for (int i = 0; i < 1500; ++i) colliders += R"({"node": 2, "shape": {"sphere": {"radius": 1}}},)";
  colliders.back() = ']';
  const SourceModel model = import_with(spring_bone_1("[]", colliders));
  EXPECT_EQ(model.colliders.size(), kMaxSourceColliders);
  EXPECT_TRUE(warns(model, "there are too many")) << warnings_of(model);
}

TEST_F(VrmDamage, DeepNestingInAnExtensionIsSkipped) {
  const std::string deep = std::string(20000, '[') + std::string(20000, ']');
  const SourceModel model = import_with(
      "\"A\": " + deep + ", " + spring_bone_1(R"([{"joints": [{"node": 3}, {"node": 4}], "extras": )" + deep + "}]"));
  EXPECT_EQ(model.springs.size(), 1u) << warnings_of(model);
}

TEST_F(VrmDamage, NodesWithoutNamesAreToldByTheirPlaceInTheTree) {
  SmallGltf file = small_vrm(spring_bone_1(R"([{"joints": [{"node": 3}, {"node": 1}]}])"));
  file.nodes = R"([{"mesh": 0, "children": [2, 3]}, {"translation": [0, 5, 0]}, {"translation": [0, 9, 0]},
                   {"children": [1], "translation": [0, 2, 0]}])";
  file.roots = "[0]";
  EXPECT_EQ(heights_of_joints(import_file(file)), (std::vector<double>{2, 7}));
}

TEST_F(VrmDamage, NodesOfOneNameAreToldByTheirPlaceInTheTree) {
  SmallGltf file = small_vrm(spring_bone_1(R"([{"joints": [{"node": 4}, {"node": 2}]}])"));
  file.nodes = R"([{"name": "hair", "mesh": 0}, {"name": "hair", "children": [3, 4], "translation": [0, 1, 0]},
                   {"name": "hair", "translation": [0, 4, 0]}, {"name": "hair", "translation": [0, 20, 0]},
                   {"name": "hair", "children": [2], "translation": [0, 2, 0]}])";
  const SourceModel model = import_file(file);
  EXPECT_EQ(heights_of_joints(model), (std::vector<double>{3, 7})) << warnings_of(model);
}

TEST_F(VrmDamage, NodesOutsideTheSceneAreAbsent) {
  SmallGltf file = small_vrm(spring_bone_1(R"([{"joints": [{"node": 3}, {"node": 4}]}])"));
  file.roots = "[0]";
  const SourceModel model = import_file(file);
  EXPECT_TRUE(model.springs.empty());
  EXPECT_TRUE(warns(model, "is not in the scene")) << warnings_of(model);
}

TEST_F(VrmDamage, RandomDamageGivesAModelOrAnErrorOfTheFile) {
  const std::string good =
      spring_bone_1(R"([{"name": "tail", "center": 2, "colliderGroups": [0], "joints": [
          {"node": 3, "stiffness": 0.5, "gravityDir": [0, -1, 0]}, {"node": 4}, {"node": 5}]}])",
                    R"([{"node": 2, "shape": {"capsule": {"offset": [0, 0, 0], "radius": 0.1, "tail": [0, 1, 0]}}}])",
                    R"([{"colliders": [0]}])") +
      ", " +
      spring_bone_0(R"([{"bones": [3], "colliderGroups": [0]}])", R"([{"node": 2, "colliders": [{"radius": 1}]}])");
  ASSERT_EQ(import_with(good).springs.size(), 1u);
  std::mt19937 random(7);
  std::size_t came_through = 0;
  for (int round = 0; round < 120; ++round) {
    std::string text = good;
    for (int i = 0; i < 2; ++i) {
      char& byte = text[random() % text.size()];
      byte = random() % 2 == 0 ? "0123456789-.eE[]{},:\""[random() % 21] : static_cast<char>(random() % 256);
    }
    const auto model = import_model(small_vrm(text).write(folder_, "m.gltf"));
    if (model) {
      EXPECT_EQ(find_model_fault(*model), "");
      ++came_through;
    } else {
      EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput) << model.error().message;
    }
  }
  EXPECT_GT(came_through, 20u);
}

}  // namespace coif::importer::vrm_damage_test
