// Files that parse but lie: what is wrong is dropped and counted, the rest comes through.

#include "import/import.h"
#include "import/imported_model.h"
#include "import/model_files.h"
#include "import/source_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>

namespace coif::importer::damage_test {

using test::SmallGltf;
using test::TemporaryFolder;
using test::warnings_of;
using test::warns;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

SmallGltf two_triangles() {
  SmallGltf file;
  file.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  file.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  file.uvs = {0, 0, 1, 0, 0, 1, 1, 1};
  file.indices = {0, 1, 2, 2, 1, 3};
  return file;
}

class Damage : public testing::Test {
 protected:
  SourceModel import_or_fail(const SmallGltf& file) { return test::import_or_fail(file.write(folder_, "m.gltf")); }
  TemporaryFolder folder_;
};

TEST_F(Damage, TriangleWithANanVertexIsDroppedAndTheVertexWithIt) {
  SmallGltf file = two_triangles();
  file.positions[10] = kNan;
  const SourceModel model = import_or_fail(file);
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.meshes[0].triangles.size(), 3u);
  EXPECT_EQ(model.meshes[0].positions.size(), 3u);
  EXPECT_TRUE(warns(model, "mesh 'card': 1 triangles dropped")) << warnings_of(model);
}

TEST_F(Damage, ModelWithoutAnyFinitePositionIsRefused) {
  SmallGltf file;
  file.positions = {kNan, 0, 0, kNan, 0, 0, kNan, 0, 0};
  const auto model = import_model(file.write(folder_, "m.gltf"));
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(model.error().message.find("m.gltf"), std::string::npos);
}

TEST_F(Damage, IndexOutOfRangeNeverReachesTheModel) {
  SmallGltf file = two_triangles();
  file.indices[5] = 60000;
  const auto model = import_model(file.write(folder_, "m.gltf"));
  if (model) {
    EXPECT_EQ(find_model_fault(*model), "");
    EXPECT_EQ(model->meshes.at(0).triangles.size(), 3u);
  } else {
    EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput);
  }
}

TEST_F(Damage, UnusableNormalsAreTakenFromTheSurface) {
  SmallGltf file = two_triangles();
  file.normals = {0, 0, 0, kNan, 0, 0, 0, 0, 1, 0, 0, 1};
  const SourceModel model = import_or_fail(file);
  ASSERT_EQ(model.meshes.size(), 1u);
  for (const auto& normal : model.meshes[0].normals) EXPECT_TRUE(normal.isApprox(Eigen::Vector3f(0, 0, 1)));
  EXPECT_TRUE(warns(model, "2 unusable normals")) << warnings_of(model);
}

TEST_F(Damage, UvsThatAreNotFiniteBecomeZero) {
  SmallGltf file = two_triangles();
  file.uvs[1] = std::numeric_limits<float>::infinity();
  const SourceModel model = import_or_fail(file);
  EXPECT_TRUE(model.meshes.at(0).uvs[0].isZero());
  EXPECT_TRUE(warns(model, "1 UVs")) << warnings_of(model);
}

// An asset holds none that large, and would be refused when all the work was done.
TEST_F(Damage, AUvBeyondAllReasonIsNamedWithItsMeshVertexAndPlace) {
  SmallGltf file = two_triangles();
  file.uvs[6] = -3e30f;
  const SourceModel model = import_or_fail(file);
  EXPECT_TRUE(model.meshes.at(0).uvs[3].isZero());
  EXPECT_FALSE(model.meshes.at(0).uvs[2].isZero());
  EXPECT_TRUE(warns(model, "mesh 'card': 1 UVs set to (0, 0): vertex 3 at (1, 1, 0) m has (-3e+30, 1), V from the top"))
      << warnings_of(model);
  EXPECT_TRUE(warns(model, "unwrap it anew")) << warnings_of(model);
}

TEST_F(Damage, AVertexFartherThanAnAssetReachesIsNamedWithItsMeshAndPlace) {
  SmallGltf file = two_triangles();
  file.positions[9] = 5e5f;
  const SourceModel model = import_or_fail(file);
  EXPECT_EQ(model.meshes.at(0).triangles.size(), 3u);
  EXPECT_TRUE(warns(model, "mesh 'card': 1 triangles dropped: vertex 3 stands at (500000, 1, 0) m"))
      << warnings_of(model);
}

SmallGltf skinned_strip() {
  SmallGltf file;
  file.nodes = R"([{"name": "strip", "mesh": 0, "skin": 0}, {"name": "a", "translation": [0, 1, 0]}])";
  file.roots = "[0, 1]";
  file.joints = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  file.weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  return file;
}

TEST_F(Damage, WeightsThatAreNotNumbersOrBelowZeroAreDropped) {
  SmallGltf file = skinned_strip();
  file.weights[0] = kNan;
  file.weights[4] = -1;
  const SourceModel model = import_or_fail(file);
  const SourceMesh& mesh = model.meshes.at(0);
  ASSERT_EQ(mesh.influence_begin.size(), 4u);
  EXPECT_EQ(model.nodes[mesh.influences[0].node].name, "strip");  // follows the mesh's node instead
  EXPECT_EQ(model.nodes[mesh.influences[2].node].name, "a");
  EXPECT_TRUE(warns(model, "2 vertices without a bone weight")) << warnings_of(model);
}

TEST_F(Damage, SkinWithoutAnyWeightIsRigid) {
  SmallGltf file = skinned_strip();
  std::ranges::fill(file.weights, 0.0f);
  const SourceModel model = import_or_fail(file);
  EXPECT_TRUE(model.meshes.at(0).influence_begin.empty());
  EXPECT_TRUE(warns(model, "taken as rigid")) << warnings_of(model);
}

TEST_F(Damage, JointOutOfRangeNeverReachesTheModel) {
  SmallGltf file = skinned_strip();
  file.joints[0] = 7;
  const auto model = import_model(file.write(folder_, "m.gltf"));
  if (model)
    EXPECT_EQ(find_model_fault(*model), "");
  else
    EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput);
}

TEST_F(Damage, FirstOfTwoNodesOfABonesNameIsTheJoint) {
  SmallGltf file = skinned_strip();
  file.nodes = R"([{"name": "strip", "mesh": 0, "skin": 0}, {"name": "a", "translation": [0, 1, 0]},
                   {"name": "a", "translation": [0, 9, 0]}])";
  file.roots = "[0, 1, 2]";
  const SourceModel model = import_or_fail(file);
  EXPECT_FLOAT_EQ(model.meshes.at(0).positions[0].y(), 1.0f);
}

TEST_F(Damage, DeepNodeTreesDoNotExhaustTheStackOfTheTool) {
  SmallGltf file;
  file.nodes = R"([{"name": "strip", "mesh": 0})";
  for (int i = 1; i < 2000; ++i) file.nodes += R"(, {"children": [)" + std::to_string(i - 1) + "]}";
  file.nodes += "]";
  file.roots = "[1999]";
  const SourceModel model = import_or_fail(file);
  EXPECT_EQ(model.nodes.size(), 2000u);
}

TEST_F(Damage, RandomDamageGivesAModelOrAnErrorOfTheFile) {
  const std::filesystem::path path = skinned_strip().write(folder_, "m.gltf");
  std::ifstream file(path, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(file)), {});
  std::mt19937 random(1);
  std::size_t refused = 0;
  for (int round = 0; round < 60; ++round) {
    std::string text = good;
    for (int i = 0; i < 2; ++i) text[random() % text.size()] = static_cast<char>(random() % 256);
    const auto model = import_model(folder_.write("m.gltf", text));
    if (model) {
      EXPECT_EQ(find_model_fault(*model), "");
    } else {
      EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput) << model.error().message;
      ++refused;
    }
  }
  EXPECT_GT(refused, 10u);
}

TEST_F(Damage, NamesAreCleanedForMessages) {
  SmallGltf file;
  file.nodes = "[{\"name\": \"str\\u0001ip\\n\", \"mesh\": 0}]";
  const SourceModel model = import_or_fail(file);
  EXPECT_EQ(model.nodes.at(0).name, "str?ip ");
}

}  // namespace coif::importer::damage_test
