// Where an FBX says that meshes stand, and which of them it shows.

#include "import/imported_model.h"
#include "import/model_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace coif::fbx_scene_test {

using test::import_or_fail;
using test::TemporaryFolder;

/// A model of the file: a mesh of one triangle (0,0,0) (1,0,0) (0,2,3), below `parent` (0: the root).
struct FbxModel {
  int id = 0;
  std::string name;
  int parent = 0;
  std::string properties;
};

std::string vector_property(const char* name, int x, int y, int z) {
  return fmt::format("P: \"{}\", \"Vector3D\", \"Vector\", \"\",{},{},{}\n", name, x, y, z);
}

std::string fbx_of(const std::vector<FbxModel>& models) {
  std::string objects, connections;
  for (const FbxModel& model : models) {
    objects += fmt::format(R"(  Geometry: {0}, "Geometry::{1}", "Mesh" {{
    Vertices: *9 {{
      a: 0,0,0,1,0,0,0,2,3
    }}
    PolygonVertexIndex: *3 {{
      a: 0,1,-3
    }}
    GeometryVersion: 124
  }}
  Model: {2}, "Model::{1}", "Mesh" {{
    Version: 232
    Properties70:  {{
{3}    }}
  }}
)", 1000 + model.id, model.name, model.id, model.properties);
    connections += fmt::format("  C: \"OO\",{},{}\n  C: \"OO\",{},{}\n", model.id, model.parent, 1000 + model.id, model.id);
  }
  return fmt::format(R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {{
  FBXHeaderVersion: 1003
  FBXVersion: 7400
}}
GlobalSettings:  {{
  Version: 1000
  Properties70:  {{
P: "UnitScaleFactor", "double", "Number", "",100
  }}
}}
Objects:  {{
{}}}
Connections:  {{
{}}}
)", objects, connections);
}

class FbxScene : public testing::Test {
 protected:
  SourceModel model_of(const std::vector<FbxModel>& models) { return import_or_fail(folder_.write("m.fbx", fbx_of(models))); }
  static const SourceMesh& mesh_on(const SourceModel& model, const std::string& node) {
    return *std::ranges::find_if(model.meshes, [&](const SourceMesh& mesh) { return model.nodes[mesh.node].name == node; });
  }
  TemporaryFolder folder_;
};

TEST_F(FbxScene, AGeometricTransformMovesItsMeshAlone) {
  const SourceModel model = model_of({{20, "head", 0, vector_property("GeometricTranslation", 0, 5, 0)},
                                      {21, "hair", 20, vector_property("Lcl Translation", 0, 1, 0)}});
  EXPECT_TRUE(mesh_on(model, "head").positions[2].isApprox(Eigen::Vector3f(0, 7, 3), 1e-5f));
  EXPECT_TRUE(mesh_on(model, "hair").positions[2].isApprox(Eigen::Vector3f(0, 3, 3), 1e-5f));
}

TEST_F(FbxScene, AMeshHasItsOwnPivotBesideItsParents) {
  const SourceModel model =
      model_of({{20, "head", 0, vector_property("Lcl Translation", 10, 0, 0) + vector_property("GeometricTranslation", 0, 5, 0)},
                {21, "hair", 20, vector_property("Lcl Translation", 0, 1, 0) + vector_property("GeometricTranslation", 0, 0, -2)}});
  EXPECT_TRUE(mesh_on(model, "head").positions[2].isApprox(Eigen::Vector3f(10, 7, 3), 1e-5f));
  EXPECT_TRUE(mesh_on(model, "hair").positions[2].isApprox(Eigen::Vector3f(10, 3, 1), 1e-5f));
}

TEST_F(FbxScene, ATurnIsAboutTheRotationPivotForChildrenToo) {
  const SourceModel model = model_of(
      {{20, "head", 0, vector_property("Lcl Rotation", 0, 0, 180) + vector_property("RotationPivot", 1, 0, 0)}, {21, "hair", 20, ""}});
  for (const char* const name : {"head", "hair"}) {
    EXPECT_TRUE(mesh_on(model, name).positions[2].isApprox(Eigen::Vector3f(2, -2, 3), 1e-5f)) << name;
  }
  EXPECT_TRUE(std::ranges::none_of(model.nodes, [](const SourceNode& node) { return node.name.find('$') != std::string::npos; }));
}

TEST_F(FbxScene, HiddenMeshesAndAllBelowAreLeftOut) {
  const SourceModel model = model_of({{20, "shown", 0, ""},
                                      {21, "off", 0, "P: \"Show\", \"bool\", \"\", \"\",0\n"},
                                      {22, "below", 21, ""}});
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.nodes[model.meshes[0].node].name, "shown");
  EXPECT_TRUE(std::ranges::any_of(model.warnings, [](const std::string& text) { return text.find("'off', 'below'") != std::string::npos; }));
}

TEST_F(FbxScene, OfLevelsOfDetailTheFinestIsKept) {
  const SourceModel model = model_of({{20, "Hair_LOD0", 0, ""}, {21, "Hair_LOD1", 0, ""}});
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.nodes[model.meshes[0].node].name, "Hair_LOD0");
  EXPECT_NE(model.warnings.at(0).find("coarser levels of detail"), std::string::npos);
}

}  // namespace coif::fbx_scene_test
