// Artists' files as they come. Skipped where the corpus is absent.

#include "import/import.h"
#include "import/imported_model.h"
#include "import/source_model.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace coif::importer::corpus_test {

namespace fs = std::filesystem;
using test::import_or_fail;
using test::measure;
using test::Shape;
using test::with_unit;
using test::with_up_axis;

const fs::path kAssets = COIF_TEST_ASSETS;

class Corpus : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kAssets / "MANIFEST.json")) GTEST_SKIP() << "no corpus of artists' files at " << kAssets;
  }
};

bool is_model_file(const fs::path& path) {
  const std::string suffix = path.extension().string();
  for (const char* known : {".fbx", ".gltf", ".glb", ".vrm", ".obj", ".dae"}) {
    if (suffix == known) return true;
  }
  return false;
}

TEST_F(Corpus, TriangleCountsMatchTheManifest) {
  const auto manifest = nlohmann::json::parse(std::ifstream(kAssets / "MANIFEST.json"));
  std::size_t seen = 0;
  for (const auto& asset : manifest["assets"]) {
    const std::string file = asset["file"];
    const bool is_counted = asset.contains("scene") && asset["scene"].contains("tris_total");
    if (!is_model_file(file) || !is_counted) continue;  // grooms: curves, of which nothing has triangles
    const SourceModel model = import_or_fail(kAssets / file);
    EXPECT_EQ(measure(model).triangles, asset["scene"]["tris_total"].get<std::size_t>()) << file;
    ++seen;
  }
  EXPECT_GE(seen, 10u);
}

TEST_F(Corpus, WholePeopleStandUprightInMetres) {
  for (const char* file :
       {"unitychan/UnityChan.fbx", "seedsan/new_seedsan_betterfbx.fbx", "godette/Godette_vrm_v4.vrm",
        "churro/ChurroChurro.vrm", "rocketbox_Female_Adult_03/Female_Adult_03.fbx", "quaternius_witch/Witch.glb"}) {
    const SourceModel model = import_or_fail(kAssets / "hair" / file);
    const Shape shape = measure(model);
    EXPECT_NEAR(shape.low.y(), 0.0f, 0.01f) << file;  // on their feet
    EXPECT_GT(shape.high.y(), 1.2f) << file;
    EXPECT_LT(shape.high.y(), 2.1f) << file;  // the witch wears a hat
    EXPECT_LT(shape.high.z() - shape.low.z(), 0.7f) << file << ": deeper than a person is";
    EXPECT_TRUE(model.warnings.empty()) << file << ": " << model.warnings.front().message;
  }
}

void expect_alike(const Shape& a, const Shape& b, float tolerance, const std::string& label) {
  EXPECT_LT((a.low - b.low).cwiseAbs().maxCoeff(), tolerance) << label;
  EXPECT_LT((a.high - b.high).cwiseAbs().maxCoeff(), tolerance) << label;
  EXPECT_NEAR(a.area / b.area, 1.0, 1e-3) << label;
  EXPECT_NEAR(a.signed_volume / b.signed_volume, 1.0, 1e-2) << label << ": winding";
  EXPECT_LT((a.mean_uv - b.mean_uv).norm(), 1e-3) << label << ": UV convention";
  EXPECT_EQ(a.triangles, b.triangles) << label;
}

TEST_F(Corpus, OnePonytailInSixFilesComesOutAlike) {
  const Shape reference = measure(import_or_fail(kAssets / "hair/mh_ponytail01/ponytail01_skinned.glb"));
  for (const char* file : {"ponytail01_blender.fbx", "ponytail01_blender.dae", "ponytail01_springbone.glb"}) {
    expect_alike(measure(import_or_fail(kAssets / "same_hair" / file)), reference, 1e-4f, file);
  }
  // Z up against the glTF specification: only the artist can know.
  expect_alike(measure(import_or_fail(kAssets / "same_hair/ponytail01_zup.glb", with_up_axis(UpAxis::kZ))), reference,
               1e-4f, "Z up");
  // OBJ in decimetres, likewise.
  expect_alike(measure(import_or_fail(kAssets / "hair/mh_ponytail01/ponytail01.obj", with_unit(0.1))), reference, 1e-4f,
               "OBJ in decimetres");
}

TEST_F(Corpus, OneLongHairInFourFilesComesOutAlike) {
  const Shape reference = measure(import_or_fail(kAssets / "same_hair/long01.obj", with_unit(1.0)));
  expect_alike(measure(import_or_fail(kAssets / "same_hair/long01_dae.dae")), reference, 1e-3f, "COLLADA");
  expect_alike(measure(import_or_fail(kAssets / "same_hair/long01_glb2.glb")), reference, 1e-3f, "glTF");
  // The exporter kept the numbers and declared centimetres.
  expect_alike(measure(import_or_fail(kAssets / "same_hair/long01_fbxa.fbx", with_unit(1.0))), reference, 1e-3f, "FBX");
}

TEST_F(Corpus, MirroredInstanceComesOutAlikeAndRightSideOut) {
  const SourceModel fbx = import_or_fail(kAssets / "same_hair/long01_negscale_instanced.fbx");
  const SourceModel glb = import_or_fail(kAssets / "same_hair/long01_negscale_instanced.glb");
  expect_alike(measure(fbx), measure(glb), 1e-3f, "mirrored instance");
  ASSERT_EQ(glb.meshes.size(), 2u);
  for (const SourceMesh& mesh : glb.meshes) {  // geometric and stored normals agree on both halves
    double agreement = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const auto corner = [&](std::size_t k) { return mesh.positions[mesh.triangles[i + k]]; };
      const Eigen::Vector3f area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
      agreement += area.dot(mesh.normals[mesh.triangles[i]]) > 0 ? 1.0 : -1.0;
    }
    EXPECT_GT(agreement / (double(mesh.triangles.size()) / 3.0), 0.9) << mesh.node;
  }
}

TEST_F(Corpus, DamagedFilesGiveAModelOrAMessageThatNamesTheFile) {
  std::size_t seen = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kAssets / "bad")) {
    if (!entry.is_regular_file() || !is_model_file(entry.path())) continue;
    ++seen;
    const auto model = import_model(entry.path());
    if (model) {
      EXPECT_EQ(find_model_fault(*model), "") << entry.path();
      continue;
    }
    EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput) << model.error().message;
    EXPECT_NE(model.error().message.find(entry.path().filename().string()), std::string::npos);
    EXPECT_NE(model.error().message.find("; "), std::string::npos) << "no cure: " << model.error().message;
  }
  EXPECT_GE(seen, 60u);
}

TEST_F(Corpus, CrashOfTheImporterIsAnErrorOfTheFile) {
  const auto model = import_model(kAssets / "bad/dae_segv/test.dae");
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(model.error().message.find("crashed"), std::string::npos) << model.error().message;
}

// assimp read on behind the array's end, and what it found there differed from run to run.
TEST_F(Corpus, ArraysThatEndTooSoonAreRefused) {
  const auto model = import_model(kAssets / "bad/assimp/box_nested_animation_4286.dae");
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(model.error().message.find("reads 24 numbers of the array 'Cube-mesh-positions-array', which has 3"),
            std::string::npos)
      << model.error().message;
}

TEST_F(Corpus, HairWithoutPolygonsSaysSo) {
  const auto model = import_model(kAssets / "bad/obj_curves/peak.obj");
  ASSERT_FALSE(model);
  EXPECT_NE(model.error().message.find("no usable triangles"), std::string::npos) << model.error().message;
}

TEST_F(Corpus, JointIsChosenOverAMeshOfTheSameName) {
  const SourceModel model = import_or_fail(kAssets / "hair/seedsan/new_seedsan_betterfbx.fbx");
  bool found = false;
  for (const SourceMesh& mesh : model.meshes) {
    if (mesh.name != "head") continue;
    ASSERT_FALSE(mesh.influences.empty());
    const std::uint32_t joint = mesh.influences.front().node;
    EXPECT_EQ(model.nodes[joint].name, "head");
    EXPECT_NE(joint, mesh.node);
    EXPECT_GT(model.nodes[joint].model_from_node.translation().y(), 1.2);
    found = true;
  }
  EXPECT_TRUE(found);
}

TEST_F(Corpus, EmbeddedBaseTexturesComeAsEncodedImages) {
  const SourceModel model = import_or_fail(kAssets / "hair/churro/ChurroChurro.vrm");
  ASSERT_EQ(model.images.size(), 1u);
  EXPECT_EQ(model.materials[0].base_texture.image, 0u);
  EXPECT_EQ(model.materials[0].base_texture.path, "churros 1024");
  const std::vector<std::uint8_t>& bytes = model.images[0].bytes;
  ASSERT_GT(bytes.size(), 8u);
  EXPECT_EQ(std::string(bytes.begin() + 1, bytes.begin() + 4), "PNG");
}

TEST_F(Corpus, SpringBonesOfBothVersionsComeThroughWhole) {
  struct Case {
    const char* file;
    std::size_t springs, joints, colliders;
    const char* head;
  };
  for (const Case& expected : {Case{"hair/godette/Godette_vrm_v4.vrm", 8, 16, 4, "head_Armature"},
                               Case{"hair/churro/ChurroChurro.vrm", 4, 18, 1, "head"},
                               Case{"same_hair/ponytail01_springbone.glb", 1, 6, 2, nullptr},
                               Case{"bad/vrm/springbone.vrm", 1, 2, 1, nullptr}}) {
    const SourceModel model = import_or_fail(kAssets / expected.file);
    std::size_t joints = 0;
    for (const SourceSpring& spring : model.springs) joints += spring.joints.size();
    EXPECT_EQ(model.springs.size(), expected.springs) << expected.file;
    EXPECT_EQ(joints, expected.joints) << expected.file;
    EXPECT_EQ(model.colliders.size(), expected.colliders) << expected.file;
    if (expected.head == nullptr) {
      EXPECT_EQ(model.head_node, kNoIndex) << expected.file;
    } else {
      ASSERT_NE(model.head_node, kNoIndex) << expected.file;
      EXPECT_EQ(model.nodes[model.head_node].name, expected.head);
    }
  }
}

TEST_F(Corpus, ImportTwiceGivesTheSameModel) {
  const fs::path path = kAssets / "hair/unitychan/UnityChan.fbx";
  const SourceModel a = import_or_fail(path);
  const SourceModel b = import_or_fail(path);
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (std::size_t m = 0; m < a.meshes.size(); ++m) {
    EXPECT_EQ(a.meshes[m].name, b.meshes[m].name);
    EXPECT_EQ(a.meshes[m].triangles, b.meshes[m].triangles);
    EXPECT_EQ(a.meshes[m].positions, b.meshes[m].positions);
    EXPECT_EQ(a.meshes[m].uvs, b.meshes[m].uvs);
    EXPECT_EQ(a.meshes[m].influence_begin, b.meshes[m].influence_begin);
  }
}

}  // namespace coif::importer::corpus_test
