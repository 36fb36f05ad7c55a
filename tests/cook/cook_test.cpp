#include "cook/cook.h"

#include "cook/built_models.h"
#include "formats/aligned_bytes.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace coif {
namespace {

CookResult cooked(const SourceModel& model, unsigned threads = 1, const Recipe& recipe = default_recipe()) {
  auto result = cook(model, recipe, {.threads = threads, .recipe_directory = {}, .source_hash = 42, .progress = {}});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? *result : CookResult{};
}

TEST(Cook, TheWigBecomesAnAssetThatOpens) {
  const CookResult result = cooked(make_wig());
  AlignedBytes file(result.asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(result.report.triangles, 10u);
  EXPECT_EQ(result.report.patches, 1u);
  EXPECT_EQ(result.report.chains, 1u);
  EXPECT_EQ(result.report.simulated_bones, 2u);
  EXPECT_STREQ(asset.bone_name(2), "hair_1");
  EXPECT_EQ(asset.provenance()->source_hash, 42u);
  EXPECT_FALSE(result.report.passes.empty());
}

TEST(Cook, HeadSpaceStartsAtTheHeadsJoint) {
  const CookResult result = cooked(make_wig());
  AlignedBytes file(result.asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_FLOAT_EQ(asset.skeleton().head_joint[1], 1.6f);
  EXPECT_EQ(asset.bones()[0].joint[1], 0.0f);
  EXPECT_NEAR(asset.bones()[2].joint[1], 0.0f, 1.0e-6);
  EXPECT_NEAR(asset.bones()[2].rest_direction[1], -1.0f, 1.0e-6);
  EXPECT_NEAR(asset.bones()[2].length, 0.1f, 1.0e-6);
  float top = -1;
  for (const VertexRecord& v : asset.vertices()) top = std::max(top, v.position[1]);
  EXPECT_NEAR(top, 0.05f, 1.0e-6);
}

TEST(Cook, OneOrderGoesAcrossMeshes) {
  SourceModel model = make_wig();
  for (const float depth : {-0.3f, -0.05f, -0.2f}) {
    model.meshes.push_back(make_strip({.root = {0, 1.6f, depth}, .along = {0, -0.1f, 0}, .rows = 6}));
    model.meshes.back().node = 1;
  }
  AlignedBytes file(cooked(model).asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  const auto patches = asset.lod_patches(0);
  ASSERT_EQ(patches.size(), 4u);
  for (std::size_t p = 1; p < patches.size(); ++p) {
    EXPECT_LE(patches[p - 1].head_distance, patches[p].head_distance);
  }
  const auto depth_of = [&](const PatchRecord& patch) {
    return asset.vertices()[asset.indices()[patch.first_index]].position[2];
  };
  EXPECT_NEAR(depth_of(patches.back()), -0.3f, 1.0e-5) << "the first of the added meshes is the outermost";
}

TEST(Cook, ThreadsDoNotChangeTheBytes) {
  SourceModel model = make_wig();
  for (int i = 0; i < 20; ++i) model.meshes.push_back(make_strip({.root = {0.01f * float(i), 1.6f, 0.1f}, .rows = 9}));
  const auto one = cooked(model, 1).asset;
  EXPECT_EQ(one, cooked(model, 1).asset);
  EXPECT_EQ(one, cooked(model, 2).asset);
  EXPECT_EQ(one, cooked(model, 7).asset);
}

TEST(Cook, AnyChangeOfTheRecipeChangesItsHash) {
  Recipe recipe = default_recipe();
  recipe.texture_max_size = 2048;
  EXPECT_NE(cooked(make_wig()).asset, cooked(make_wig(), 1, recipe).asset);
}

TEST(Cook, HairWithoutBonesGetsChainsUnlessTheRecipeWantsNone) {
  SourceModel model = make_wig();
  model.meshes[0].influence_begin.clear();
  model.meshes[0].influences.clear();
  EXPECT_GT(cooked(model).report.simulated_bones, 0u);
  Recipe recipe = default_recipe();
  recipe.chain_source = "none";
  EXPECT_EQ(cooked(model, 1, recipe).report.simulated_bones, 0u);
  recipe.chain_source = "file";
  EXPECT_EQ(cooked(model, 1, recipe).report.simulated_bones, 0u);
}

TEST(Cook, RigidHairLeavesDynamicsOut) {
  SourceModel model = make_wig();
  model.meshes[0].influence_begin.clear();
  model.meshes[0].influences.clear();
  Recipe recipe = default_recipe();
  recipe.chain_source = "file";
  const CookResult result = cooked(model, 1, recipe);
  AlignedBytes file(result.asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_TRUE(asset.dynamics().empty());
  EXPECT_TRUE(asset.chains().empty());
  EXPECT_FALSE(result.report.warnings.empty());
}

TEST(Cook, ATextureThatTheRecipeNamesMustBeThere) {
  Recipe recipe = default_recipe();
  recipe.shift_texture = "absent.png";
  const auto result = cook(make_wig(), recipe, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "absent.png: recipe key \"textures.shift\": no such file");
}

TEST(Cook, ATextureOfTheSourceThatIsMissingIsAWarning) {
  SourceModel model = make_wig();
  SourceMaterial strands;
  strands.name = "strands";
  strands.base_texture.path = "D:\\work\\..\\hair.png";
  model.materials.push_back(strands);
  model.meshes[0].material = 0;
  const CookResult result = cooked(model);
  ASSERT_EQ(result.report.warnings.size(), 1u);
  EXPECT_NE(result.report.warnings[0].find("no such file beside the source"), std::string::npos);
}

TEST(Cook, HairThatSaysNothingOfItsColorIsBrownButGltfMeansWhite) {
  const auto color_of = [](const char* path) {
    SourceModel model = make_wig();
    model.path = path;
    AlignedBytes file(cooked(model).asset);
    Asset asset;
    EXPECT_TRUE(asset.open(file.bytes()));
    return std::array{asset.material()->base_color[0], asset.material()->base_color[2]};
  };
  const auto fbx = color_of("wig.fbx");
  EXPECT_LT(fbx[0], 0.3f);
  EXPECT_LT(fbx[1], fbx[0]);
  EXPECT_EQ(color_of("wig.glb"), (std::array{1.0f, 1.0f}));
}

TEST(Cook, NumbersThatNoAssetMayHoldAreRefusedNotWritten) {
  SourceModel model = make_wig();
  for (Eigen::Vector3f& p : model.meshes[0].positions) p *= 1.0e6f;
  const auto result = cook(model, default_recipe(), {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(result.error().message.find("wig.glb: "), std::string::npos);
}

}  // namespace
}  // namespace coif
