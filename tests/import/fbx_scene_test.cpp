// Where an FBX says that meshes stand, and which of them it shows.

#include "import/fbx_files.h"
#include "import/fbx_objects.h"
#include "import/imported_model.h"
#include "import/model_files.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace coif::importer::fbx_scene_test {

using test::fbx_property;
using test::FbxModel;
using test::import_or_fail;
using test::TemporaryFolder;
using test::warnings_of;
using test::warns;

std::string vector_property(const char* name, int x, int y, int z) {
  return fmt::format("P: \"{}\", \"Vector3D\", \"Vector\", \"\",{},{},{}\n", name, x, y, z);
}

class FbxScene : public testing::Test {
 protected:
  SourceModel model_of(const std::vector<FbxModel>& models) {
    return import_or_fail(folder_.write("m.fbx", test::text_fbx(models)));
  }
  static const SourceMesh& mesh_on(const SourceModel& model, const std::string& node) {
    return *std::ranges::find_if(model.meshes,
                                 [&](const SourceMesh& mesh) { return model.nodes[mesh.node].name == node; });
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
  const SourceModel model = model_of(
      {{20, "head", 0, vector_property("Lcl Translation", 10, 0, 0) + vector_property("GeometricTranslation", 0, 5, 0)},
       {21, "hair", 20,
        vector_property("Lcl Translation", 0, 1, 0) + vector_property("GeometricTranslation", 0, 0, -2)}});
  EXPECT_TRUE(mesh_on(model, "head").positions[2].isApprox(Eigen::Vector3f(10, 7, 3), 1e-5f));
  EXPECT_TRUE(mesh_on(model, "hair").positions[2].isApprox(Eigen::Vector3f(10, 3, 1), 1e-5f));
}

/// A triangle that the bone 21, at (0, 1, 0) of the bone 22, holds; what it is bound with does not move it.
std::string skinned_triangle(const std::string& mesh, const std::string& bone, const std::string& above) {
  std::string file = test::text_fbx({{20, "hair", 0, mesh},
                                     {22, "head", 0, above, "LimbNode"},
                                     {21, "lock", 22, vector_property("Lcl Translation", 0, 1, 0) + bone, "LimbNode"}});
  file.insert(file.find("Objects:  {\n") + 12, R"(  Deformer: 80, "Deformer::skin", "Skin" {
    Version: 101
  }
  Deformer: 81, "SubDeformer::lock", "Cluster" {
    Version: 100
    Indexes: *3 {
      a: 0,1,2
    }
    Weights: *3 {
      a: 1,1,1
    }
    Transform: *16 {
      a: 1,0,0,0,0,1,0,0,0,0,1,0,0,-1,0,1
    }
    TransformLink: *16 {
      a: 1,0,0,0,0,1,0,0,0,0,1,0,0,1,0,1
    }
  }
)");
  file.insert(file.find("Connections:  {\n") + 16, "  C: \"OO\",80,1020\n  C: \"OO\",81,80\n  C: \"OO\",21,81\n");
  return file;
}

TEST_F(FbxScene, AGeometricTransformOfABoneMovesNothingThatItHolds) {
  const auto last_corner = [&](const std::string& mesh, const std::string& bone, const std::string& above) {
    const SourceModel model = import_or_fail(folder_.write("m.fbx", skinned_triangle(mesh, bone, above)));
    EXPECT_FALSE(model.meshes.at(0).influences.empty());
    return model.meshes.at(0).positions.at(2);
  };
  const std::string geometric = vector_property("GeometricTranslation", 5, 6, 7) +
                                vector_property("GeometricRotation", 0, 0, 90) +
                                vector_property("GeometricScaling", 2, 2, 2);
  const Eigen::Vector3f own(0, 2, 3);
  EXPECT_TRUE(last_corner("", "", "").isApprox(own, 1e-5f));
  EXPECT_TRUE(last_corner("", geometric, geometric).isApprox(own, 1e-5f));
  EXPECT_TRUE(last_corner(vector_property("GeometricTranslation", 5, 0, 0), geometric, geometric)
                  .isApprox(own + Eigen::Vector3f(5, 0, 0), 1e-5f))
      << "the mesh's own moves it before its bones do";
  EXPECT_TRUE(last_corner(vector_property("Lcl Translation", 5, 0, 0), "", "").isApprox(own, 1e-5f))
      << "where it stands is its bones' affair";
}

/// A triangle of which one bone holds the first corner and another of the same name, elsewhere, the others.
std::string triangle_of_two_bones(const std::string& name) {
  std::string file = test::text_fbx({{20, "hair", 0},
                                     {22, "head", 0, "", "LimbNode"},
                                     {21, name, 22, vector_property("Lcl Translation", -4, 0, 0), "LimbNode"},
                                     {23, name, 22, vector_property("Lcl Translation", 4, 0, 0), "LimbNode"}});
  const auto cluster = [&](int id, const char* corners, int count, int x) {
    return fmt::format(
        "  Deformer: {}, \"SubDeformer::{}\", \"Cluster\" {{\n    Version: 100\n    Indexes: *{} {{\n      a: {}\n    "
        "}}\n"
        "    Weights: *{} {{\n      a: {}\n    }}\n    Transform: *16 {{\n      a: 1,0,0,0,0,1,0,0,0,0,1,0,{},0,0,1\n  "
        "  }}\n"
        "    TransformLink: *16 {{\n      a: 1,0,0,0,0,1,0,0,0,0,1,0,{},0,0,1\n    }}\n  }}\n",
        id, name, count, corners, count, count == 1 ? "1" : "1,1", -x, x);
  };
  file.insert(file.find("Objects:  {\n") + 12,
              "  Deformer: 80, \"Deformer::skin\", \"Skin\" {\n    Version: 101\n  }\n" + cluster(81, "0", 1, -4) +
                  cluster(82, "1,2", 2, 4));
  file.insert(file.find("Connections:  {\n") + 16,
              "  C: \"OO\",80,1020\n  C: \"OO\",81,80\n  C: \"OO\",21,81\n  C: \"OO\",82,80\n  C: \"OO\",23,82\n");
  return file;
}

TEST_F(FbxScene, TwoBonesMayHaveOneName) {
  for (const std::string name : {"hair", "h", "\xE9\xAB\xAA"}) {
    const SourceModel model = import_or_fail(folder_.write("m.fbx", triangle_of_two_bones(name)));
    const SourceMesh& mesh = model.meshes.at(0);
    ASSERT_EQ(mesh.influences.size(), 3u) << name;
    for (std::size_t v = 0; v < 3; ++v) {
      const SourceNode& bone = model.nodes.at(mesh.influences.at(mesh.influence_begin.at(v)).node);
      EXPECT_EQ(bone.name, name) << v;
      const bool is_first = mesh.positions[v].norm() < 1e-6f;
      EXPECT_EQ(bone.model_from_node.translation().x() < 0, is_first) << name << v;
    }
    EXPECT_TRUE(model.warnings.empty()) << warnings_of(model);
  }
}

TEST_F(FbxScene, ATurnIsAboutTheRotationPivotForChildrenToo) {
  const SourceModel model =
      model_of({{20, "head", 0, vector_property("Lcl Rotation", 0, 0, 180) + vector_property("RotationPivot", 1, 0, 0)},
                {21, "hair", 20, ""}});
  for (const char* const name : {"head", "hair"}) {
    EXPECT_TRUE(mesh_on(model, name).positions[2].isApprox(Eigen::Vector3f(2, -2, 3), 1e-5f)) << name;
  }
  EXPECT_TRUE(std::ranges::none_of(model.nodes,
                                   [](const SourceNode& node) { return node.name.find('$') != std::string::npos; }));
}

TEST_F(FbxScene, HiddenMeshesAndAllBelowAreLeftOut) {
  const SourceModel model =
      model_of({{20, "shown", 0, ""}, {21, "off", 0, "P: \"Show\", \"bool\", \"\", \"\",0\n"}, {22, "below", 21, ""}});
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.nodes[model.meshes[0].node].name, "shown");
  EXPECT_TRUE(std::ranges::any_of(
      model.warnings, [](const Diagnostic& text) { return text.message.find("'off', 'below'") != std::string::npos; }));
}

TEST_F(FbxScene, OfLevelsOfDetailTheFinestIsKept) {
  const SourceModel model = model_of({{20, "Hair_LOD0", 0, ""}, {21, "Hair_LOD1", 0, ""}});
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.nodes[model.meshes[0].node].name, "Hair_LOD0");
  EXPECT_NE(model.warnings.at(0).message.find("coarser levels of detail"), std::string::npos);
}

std::vector<std::string> shown_nodes(const SourceModel& model) {
  std::vector<std::string> names;
  for (const SourceMesh& mesh : model.meshes) names.push_back(model.nodes[mesh.node].name);
  return names;
}

using Names = std::vector<std::string>;

TEST_F(FbxScene, VisibilityOfZeroHidesAModelAndAllBelow) {
  const SourceModel model = model_of({{20, "shown", 0, fbx_property("Visibility", "Visibility", 1)},
                                      {21, "off", 0, fbx_property("Visibility", "Visibility", 0)},
                                      {22, "below", 21, ""},
                                      {23, "group", 20, fbx_property("Visibility", "Visibility", 0), "Null"},
                                      {24, "in group", 23, ""}});
  EXPECT_EQ(shown_nodes(model), Names{"shown"});
  EXPECT_TRUE(warns(model, "3 meshes left out, since the file hides them: 'in group', 'off', 'below'"))
      << warnings_of(model);
}

TEST_F(FbxScene, AModelThatDoesNotInheritVisibilityIsShownBelowAHiddenOne) {
  const SourceModel model =
      model_of({{20, "off", 0, fbx_property("Visibility", "Visibility", 0)},
                {21, "hair", 20, fbx_property("Visibility Inheritance", "Visibility Inheritance", 0)}});
  EXPECT_EQ(shown_nodes(model), Names{"hair"});
}

TEST_F(FbxScene, AmongModelsOfOneNameTheHiddenOneIsLeftOut) {
  for (const int hidden : {0, 1, 2}) {
    std::vector<FbxModel> models;
    for (int i = 0; i < 3; ++i)
      models.push_back({20 + i, "hair", 0,
                        vector_property("Lcl Translation", i, 0, 0) +
                            fbx_property("Visibility", "Visibility", i == hidden ? 0 : 1)});
    const SourceModel model = model_of(models);
    ASSERT_EQ(model.meshes.size(), 2u);
    for (const SourceMesh& mesh : model.meshes) EXPECT_NE(mesh.positions[0].x(), float(hidden));
  }
}

TEST_F(FbxScene, AHiddenModelWithPivotsIsFoundToo) {
  const SourceModel model =
      model_of({{20, "hair", 0, ""},
                {21, "off", 0,
                 vector_property("RotationPivot", 1, 0, 0) + vector_property("GeometricTranslation", 0, 5, 0) +
                     vector_property("Lcl Rotation", 0, 0, 90) + fbx_property("Visibility", "Visibility", 0)},
                {22, "below", 21, ""}});
  EXPECT_EQ(shown_nodes(model), Names{"hair"});
}

TEST_F(FbxScene, ADisplayLayerThatIsOffHidesItsModels) {
  for (const int show : {0, 1}) {
    std::string file = test::text_fbx({{20, "hair", 0, ""}, {21, "old hair", 0, ""}});
    file.insert(file.find("Objects:  {\n") + 12,
                fmt::format(R"(  CollectionExclusive: 70, "DisplayLayer::layer1", "DisplayLayer" {{
    Properties70:  {{
      P: "Show", "bool", "", "",{}
    }}
  }}
)",
                            show));
    file.insert(file.find("Connections:  {\n") + 16, "  C: \"OO\",21,70\n");
    const SourceModel model = import_or_fail(folder_.write("m.fbx", file));
    EXPECT_EQ(shown_nodes(model), show == 0 ? Names{"hair"} : (Names{"hair", "old hair"}));
  }
}

// Records deeper than the walker goes, which assimp passes over.
TEST_F(FbxScene, AFileWhoseRecordsCannotBeReadIsReadAsAssimpReadsIt) {
  std::string file = test::text_fbx({{20, "hair", 0, ""}, {21, "off", 0, fbx_property("Visibility", "Visibility", 0)}});
  std::string nested = "A: 1\n";
  for (int i = 0; i < 70; ++i) nested = "A: {\n" + nested + "}\n";
  file += "Extra: {\n" + nested + "}\n";
  EXPECT_FALSE(FbxObjects::read(file));
  EXPECT_EQ(shown_nodes(import_or_fail(folder_.write("m.fbx", file))), (Names{"hair", "off"}));
}

TEST_F(FbxScene, AFileThatHidesEveryMeshIsRefusedForThat) {
  const auto model = import_model(
      folder_.write("m.fbx", test::text_fbx({{20, "hair", 0, fbx_property("Visibility", "Visibility", 0)}})));
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().message.find("hides all of its meshes"), std::string::npos) << model.error().message;
}

TEST_F(FbxScene, OfALodGroupTheFirstChildWithAMeshIsKeptWhateverItsName) {
  const SourceModel model = model_of({{20, "group", 0, "", "LodGroup"},
                                      {21, "empty", 20, "", "Null"},
                                      {22, "fine", 20, "", "Null"},
                                      {23, "strands", 22, ""},
                                      {24, "bun", 22, ""},
                                      {25, "coarse", 20, ""},
                                      {26, "coarser", 20, "", "Null"},
                                      {27, "below", 26, ""},
                                      {28, "other", 0, ""}});
  EXPECT_EQ(shown_nodes(model), (Names{"strands", "bun", "other"}));
  EXPECT_TRUE(
      warns(model, "2 meshes left out as coarser levels of detail of what is there in a finer one: 'coarse', 'below'"))
      << warnings_of(model);
}

TEST_F(FbxScene, TheFinestLevelIsTheFirstThatIsShown) {
  const SourceModel model = model_of({{20, "group", 0, "", "LodGroup"},
                                      {21, "a", 20, fbx_property("Visibility", "Visibility", 0)},
                                      {22, "b", 20, ""},
                                      {23, "c", 20, ""}});
  EXPECT_EQ(shown_nodes(model), Names{"b"});
}

float third_corner(const SourceModel& model) { return model.meshes.at(0).positions.at(2).x(); }

TEST_F(FbxScene, AShapeKeyThatIsOnIsPartOfTheShape) {
  const SourceModel model = model_of({{20, "hair", 0, "", "Mesh", {{"off", 0}, {"Longer", 50}, {"Wide", 10}}}});
  EXPECT_FLOAT_EQ(third_corner(model), 5 + 1);
  EXPECT_TRUE(warns(model,
                    "mesh 'hair': shape keys are on ('Longer' at 0.5, 'Wide' at 0.1) and are part of the hair's shape; "
                    "turn them off"))
      << warnings_of(model);
}

TEST_F(FbxScene, ShapeKeysThatAreOffChangeNothing) {
  const SourceModel model = model_of({{20, "hair", 0, "", "Mesh", {{"a", 0}, {"b", 0, 2}}}});
  EXPECT_FLOAT_EQ(third_corner(model), 0);
  EXPECT_FALSE(warns(model, "shape key")) << warnings_of(model);
}

TEST_F(FbxScene, ShapesInBetweenAreMixedAtTheirWeights) {
  const auto at = [&](double percent, const char* full_weights) {
    return third_corner(model_of({{20, "hair", 0, "", "Mesh", {{"key", percent, 2, full_weights}}}}));
  };
  EXPECT_FLOAT_EQ(at(100, "25,100"), 20);
  EXPECT_FLOAT_EQ(at(25, "25,100"), 10);
  EXPECT_FLOAT_EQ(at(12.5, "25,100"), 5);
  EXPECT_FLOAT_EQ(at(62.5, "25,100"), 15);
  EXPECT_FLOAT_EQ(at(50, ""), 10);
  EXPECT_FLOAT_EQ(at(75, "100,25"), 15);  // not ascending: taken as even
}

TEST_F(FbxScene, EachInstanceOfAMeshHasItsShapeKeys) {
  std::string file = test::text_fbx({{20, "hair", 0, "", "Mesh", {{"Longer", 100}}}, {21, "twin", 0, "", "Null"}});
  file.insert(file.find("  C: \"OO\",1020,20"), "  C: \"OO\",1020,21\n");
  const SourceModel model = import_or_fail(folder_.write("m.fbx", file));
  ASSERT_EQ(model.meshes.size(), 2u);
  for (const SourceMesh& mesh : model.meshes) EXPECT_FLOAT_EQ(mesh.positions.at(2).x(), 10);
  EXPECT_EQ(
      std::ranges::count_if(
          model.warnings, [](const Diagnostic& text) { return text.message.find("shape keys") != std::string::npos; }),
      1);
}

TEST_F(FbxScene, DamagedFilesGiveAModelOrAnErrorOfTheFile) {
  const std::string good = test::text_fbx({{20, "group", 0, "", "LodGroup"},
                                           {21,
                                            "fine",
                                            20,
                                            fbx_property("Visibility", "Visibility", 1),
                                            "Mesh",
                                            {{"Longer", 50}, {"Wide", 20, 2, "25,100"}}},
                                           {22, "coarse", 20, fbx_property("Visibility", "Visibility", 0)}});
  std::mt19937 random(7);
  std::size_t read = 0, refused = 0;
  for (int round = 0; round < 200; ++round) {
    std::string bad = good;
    if (round % 2 == 0) bad.resize(random() % bad.size());
    for (int i = 0; i < round % 4; ++i) bad[random() % bad.size()] = "0123456789,{}:\"* \n"[random() % 18];
    const auto model = import_model(folder_.write("m.fbx", bad));
    if (model) {
      EXPECT_EQ(find_model_fault(*model), "");
      ++read;
    } else {
      EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput) << model.error().message;
      ++refused;
    }
  }
  EXPECT_GT(read, 20u);
  EXPECT_GT(refused, 20u);
}

// Blender writes both, of one scene.
TEST(FbxShared, AShapeKeyOfBlenderGivesTheShapeThatItsGltfHas) {
  const std::filesystem::path folder = std::filesystem::path(COIF_TEST_ASSETS) / "../cases/reading/blender";
  if (!std::filesystem::exists(folder / "b04_shape_key_on.fbx")) GTEST_SKIP() << "no files of Blender at " << folder;
  const auto hair_of = [&](const char* name) {
    SourceModel model = import_or_fail(folder / name);
    std::erase_if(model.meshes, [&](const SourceMesh& mesh) { return model.nodes[mesh.node].name != "Hair"; });
    EXPECT_TRUE(warns(model, "shape keys are on ('Long' at 1)")) << warnings_of(model);
    return test::measure(model);
  };
  const test::Shape fbx = hair_of("b04_shape_key_on.fbx"), gltf = hair_of("b04_shape_key_on.glb");
  EXPECT_TRUE(fbx.low.isApprox(gltf.low, 1e-3f)) << fbx.low.transpose() << " and " << gltf.low.transpose();
  EXPECT_TRUE(fbx.high.isApprox(gltf.high, 1e-3f)) << fbx.high.transpose() << " and " << gltf.high.transpose();
  EXPECT_NEAR(fbx.area, gltf.area, 1e-3 * gltf.area);
}

}  // namespace coif::importer::fbx_scene_test
