// What modellers' exporters write of textures' places and of colours. Skipped where the exported files are absent.

#include "import/import.h"
#include "import/imported_model.h"
#include "import/source_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace coif::importer::exported_surfaces_test {

namespace fs = std::filesystem;
using test::import_or_fail;

const fs::path kExported = fs::path(COIF_TEST_ASSETS).parent_path() / "cases" / "reading";

class ExportedSurfaces : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kExported)) GTEST_SKIP() << "no exported files at " << kExported;
  }

  static const SourceMesh& hair_of(const SourceModel& model) {
    const auto hair =
        std::ranges::find_if(model.meshes, [](const SourceMesh& mesh) { return mesh.name.starts_with("Hair"); });
    return hair == model.meshes.end() ? model.meshes.front() : *hair;
  }

  static std::pair<Eigen::Vector2f, Eigen::Vector2f> range_of(const SourceMesh& mesh) {
    Eigen::Vector2f low = mesh.uvs.front(), high = low;
    for (const Eigen::Vector2f& uv : mesh.uvs) {
      low = low.cwiseMin(uv);
      high = high.cwiseMax(uv);
    }
    return {low, high};
  }
};

TEST_F(ExportedSurfaces, AMappingNodeShowsTheSameQuarterFromFbxAsFromObj) {
  // The upper left quarter of an atlas; V grows downwards.
  for (const char* file : {"blender/b02_mapping_node.fbx", "obj/uvscale.obj"}) {
    const SourceModel model = import_or_fail(kExported / file);
    const auto [low, high] = range_of(hair_of(model));
    EXPECT_TRUE(low.isApprox(Eigen::Vector2f(0, 0)) || low.norm() < 1e-5f) << file << ": " << low.transpose();
    EXPECT_TRUE(high.isApprox(Eigen::Vector2f(0.5f, 0.5f), 1e-5f)) << file << ": " << high.transpose();
  }
}

TEST_F(ExportedSurfaces, ColorsOfVerticesComeAsLight) {
  const SourceModel model = import_or_fail(kExported / "blender/b11_vertex_colours.fbx");
  const SourceMesh& hair = hair_of(model);
  ASSERT_EQ(hair.colors.size(), hair.positions.size());
  for (const Eigen::Vector4f& color : hair.colors) {
    EXPECT_NEAR(color.y(), 0.03f, 0.002f) << "0.188 on a screen";
    EXPECT_EQ(color.w(), 1);
  }
}

TEST_F(ExportedSurfaces, OpacityTexturesAreTheFilesOwn) {
  for (const char* file : {"blender/b13_separate_alpha.fbx", "blender/b13_separate_alpha.obj", "obj/mapd.obj"}) {
    const SourceModel model = import_or_fail(kExported / file);
    const SourceMaterial& material = model.materials.at(hair_of(model).material);
    EXPECT_NE(material.opacity_texture.path.find("alpha.png"), std::string::npos)
        << file << ": " << material.opacity_texture.path;
    EXPECT_EQ(material.alpha_use, AlphaUse::kBlend) << file;
  }
}

}  // namespace coif::importer::exported_surfaces_test
