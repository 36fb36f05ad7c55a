#include "cook/cook.h"
#include "cook/built_models.h"
#include "models/small_asset.h"
#include "platform/stop.h"

#include <coif/asset.h>
#include <coif/hair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <set>

namespace coif::cook::cook_test {

CookResult cooked(const importer::SourceModel& model, unsigned threads = 1, const Recipe& recipe = default_recipe()) {
  auto result = cook(model, recipe, {.threads = threads, .recipe_directory = {}, .source_hash = 42, .progress = {}});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? *result : CookResult{};
}

TEST(Cook, NormalsALittleTooLongStayWhatTheyAre) {
  importer::SourceModel model = make_wig();
  model.meshes[0].normals.assign(model.meshes[0].positions.size(), {0, 0, 1.009f});
  const CookResult result = cooked(model);
  AlignedBytes file(result.asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  for (const VertexRecord& vertex : asset.vertices()) EXPECT_EQ(vertex.normal[2], 32767);
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
  std::set<std::string> names;
  for (const PassTime& pass : result.report.passes) EXPECT_TRUE(names.insert(pass.name).second) << pass.name;
  EXPECT_GT(names.size(), 20u);
}

TEST(Cook, ADraftHasTheSameBonesAndFinestMeshAndSaysWhatItIs) {
  Recipe recipe = default_recipe();
  recipe.scene_provenance = false;  // A draft cannot hide.
  recipe.resistance = {{0, 0.35}, {1, 0.06}};
  Recipe of_full = default_recipe();
  of_full.resistance = recipe.resistance;
  const CookResult full = *cook(make_wig(), of_full, {.threads = 1});
  const auto draft = cook(make_wig(), recipe, {.threads = 1, .draft = true});
  ASSERT_TRUE(draft) << draft.error().message;
  AlignedBytes full_file(full.asset), draft_file(draft->asset);
  Asset whole, quick;
  ASSERT_TRUE(whole.open(full_file.bytes()));
  ASSERT_TRUE(quick.open(draft_file.bytes()));
  EXPECT_EQ(whole.provenance()->flags, 0u);
  ASSERT_NE(quick.provenance(), nullptr);
  EXPECT_EQ(quick.provenance()->flags, kProvenanceDraft);
  EXPECT_EQ(quick.bones().size(), whole.bones().size());
  EXPECT_EQ(quick.lod_indices(0).size(), whole.lod_indices(0).size());
  EXPECT_LE(quick.stored_lods().size(), 1u);
  EXPECT_EQ(quick.tuning(), nullptr);
  EXPECT_EQ(std::ranges::count(full.report.passes, "tuning", &PassTime::name), 1);
  EXPECT_EQ(std::ranges::count(draft->report.passes, "tuning", &PassTime::name), 0);
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

/// Triangles as large as the hair, all through each other: each view of them has thousands of layers.
importer::SourceModel triangle_soup(std::size_t triangles) {
  importer::SourceModel model = make_wig();
  importer::SourceMesh soup = make_strip({});
  soup.positions.clear();
  soup.uvs.clear();
  soup.triangles.clear();
  std::mt19937 engine(4);
  std::uniform_real_distribution<float> place(-0.2f, 0.2f), uv(0, 1);
  for (std::uint32_t v = 0; v < 3 * triangles; ++v) {
    soup.positions.push_back({place(engine), 1.6f + place(engine), place(engine)});
    soup.uvs.push_back({uv(engine), uv(engine)});
    soup.triangles.push_back(v);
  }
  soup.node = 1;
  model.meshes = {soup};
  return model;
}

TEST(Cook, WhatHairNeverHasIsLookedAtWithFewerLines) {
  Recipe recipe = default_recipe();
  recipe.base_color[3] = 0.6;  // so that an order is searched
  recipe.order_method = OrderMethod::kSingle;
  recipe.scene_simulate = false;
  const CookResult result = cooked(triangle_soup(1200), 2, recipe);
  const auto said = [&](const char* what) {
    return std::ranges::any_of(result.report.notes,
                               [&](const std::string& note) { return note.find(what) != note.npos; });
  };
  EXPECT_TRUE(said("occlusion: by fewer lines than usual"));
  EXPECT_TRUE(said("of the usual lines of sight"));
  const CookResult wig = cooked(make_wig(), 2, recipe);
  for (const std::string& note : wig.report.notes) EXPECT_EQ(note.find("than usual"), note.npos) << note;
  for (const std::string& note : wig.report.notes) EXPECT_EQ(note.find("the usual lines"), note.npos) << note;
}

TEST(Cook, EndsWhenAskedToStop) {
  const importer::SourceModel wig = make_wig();
  std::vector<std::string> passes;
  std::stop_source stop;
  const auto cook_it = [&] {
    return cook(wig, default_recipe(), {.threads = {2, stop.get_token()}, .progress = [&](const char* pass) {
                                          passes.emplace_back(pass);
                                          if (passes.back() == "patches") stop.request_stop();
                                        }});
  };
  EXPECT_THROW((void)cook_it(), platform::Stopped);
  EXPECT_EQ(passes.back(), "patches") << "no further pass begins";
  passes.clear();
  EXPECT_THROW((void)cook_it(), platform::Stopped);
  EXPECT_TRUE(passes.empty());
}

/// What a pass does in one go looks at the token, too.
TEST(Cook, EndsInTheMiddleOfItsLongPasses) {
  const importer::SourceModel wig = make_wig();
  for (const char* const last : {"head", "strands", "lods", "tuning", "draw order"}) {
    std::stop_source stop;
    const auto stop_at = [&](const char* pass) {
      if (std::string_view(pass) == last) stop.request_stop();
    };
    CookSettings settings;
    settings.threads = {1, stop.get_token()};
    std::string after;
    settings.progress = [&](const char* pass) {
      if (stop.stop_requested()) after = pass;
      stop_at(pass);
    };
    EXPECT_THROW((void)cook(wig, default_recipe(), settings), platform::Stopped) << last;
    EXPECT_EQ(after, "") << last;
  }
}

TEST(Cook, OneOrderGoesAcrossMeshes) {
  importer::SourceModel model = make_wig();
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
  importer::SourceModel model = make_wig();
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
  importer::SourceModel model = make_wig();
  model.meshes[0].influence_begin.clear();
  model.meshes[0].influences.clear();
  EXPECT_GT(cooked(model).report.simulated_bones, 0u);
  Recipe recipe = default_recipe();
  recipe.chain_source = ChainSource::kNoChains;
  EXPECT_EQ(cooked(model, 1, recipe).report.simulated_bones, 0u);
  recipe.chain_source = ChainSource::kFile;
  EXPECT_EQ(cooked(model, 1, recipe).report.simulated_bones, 0u);
}

TEST(Cook, RigidHairLeavesDynamicsOut) {
  importer::SourceModel model = make_wig();
  model.meshes[0].influence_begin.clear();
  model.meshes[0].influences.clear();
  Recipe recipe = default_recipe();
  recipe.chain_source = ChainSource::kFile;
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
  recipe.shift_texture.file = "absent.png";
  const auto result = cook(make_wig(), recipe, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "absent.png: recipe key \"textures.shift\": no such file");
}

TEST(Cook, ATextureOfTheSourceThatIsMissingIsAWarning) {
  importer::SourceModel model = make_wig();
  importer::SourceMaterial strands;
  strands.name = "strands";
  strands.base_texture.path = "D:\\work\\..\\hair.png";
  model.materials.push_back(strands);
  model.meshes[0].material = 0;
  const CookResult result = cooked(model);
  const auto is_of_file = [](const Diagnostic& warning) {
    return warning.message.find("no such file beside the source") != std::string::npos;
  };
  EXPECT_EQ(std::ranges::count_if(result.report.warnings, is_of_file), 1);
}

TEST(Cook, HairThatSaysNothingOfItsColorIsBrownButGltfMeansWhite) {
  const auto color_of = [](const char* path) {
    importer::SourceModel model = make_wig();
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
  importer::SourceModel model = make_wig();
  for (Eigen::Vector3f& p : model.meshes[0].positions) p *= 1.0e6f;
  const auto result = cook(model, default_recipe(), {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(result.error().message.find("wig.glb: "), std::string::npos);
}

// What a game may do with a cooked file in which any one byte was changed: open() refuses it, or it simulates.

/// A wig with two patches and both textures, cooked as small as it gets, so that every byte can be tried.
std::vector<std::byte> cooked_wig() {
  importer::SourceModel model = make_wig();
  model.meshes.push_back(make_strip({.root = {0.05f, 1.6f, -0.1f}, .tip_width = 0.4f}));
  model.meshes.back().node = 1;
  importer::SourceMaterial strands;
  strands.name = "strands";
  strands.base_texture.image = 0;
  model.materials.push_back(strands);
  // A TGA of one pixel: header without compression, 32 bits.
  model.images.push_back({"dot", {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32, 8, 10, 20, 30, 255}});
  for (importer::SourceMesh& mesh : model.meshes) mesh.material = 0;
  Recipe recipe = default_recipe();
  recipe.texture_max_size = 4;
  recipe.acknowledged_warnings = {"S227", "S228"};  // so small a wig shows no head
  const auto result = cook(model, recipe, {});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  EXPECT_TRUE(result && result->report.warnings.empty()) << (result ? result->report.warnings[0].message : "");
  return result ? result->asset : std::vector<std::byte>{};
}

/// Three steps of a head that jerks sideways; the sum of all matrices.
double simulate(const Asset& asset) {
  const MemoryNeed need = Hair::memory_need(asset, {});
  AlignedBytes memory(std::vector<std::byte>(need.bytes));
  Hair hair;
  if (hair.create(asset, {}, memory.bytes()) != Status::kOk) return NAN;
  for (int frame = 1; frame <= 3; ++frame) {
    HeadPose pose;
    pose.position[0] = 0.1 * frame;
    if (hair.set_head(0, pose) != Status::kOk || hair.step({}) != Status::kOk) return NAN;
  }
  double sum = 0;
  for (const Mat34& bone : hair.palette(0)) {
    for (const auto& row : bone.m) {
      for (float value : row) sum += value;
    }
  }
  return sum;
}

TEST(DamagedAsset, AnyChangedByteIsRefusedOrSimulates) {
  AlignedBytes file(cooked_wig());
  const std::span<std::byte> bytes = file.bytes();
  ASSERT_GT(bytes.size(), 1000u);
  ASSERT_LT(bytes.size(), 10000u) << "small enough to try every byte";
  std::size_t refused = 0, harmless = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const std::byte original = bytes[at];
    for (unsigned flip = 1; flip < 256; ++flip) {
      bytes[at] = original ^ std::byte(flip);
      Asset asset;
      ASSERT_FALSE(asset.open(bytes) && asset.verify_draw_data()) << "the hashes must see byte " << at;
      if (!asset.open(bytes, {.verify_hash = false})) {
        ++refused;
        continue;
      }
      ++harmless;
      ASSERT_TRUE(std::isfinite(simulate(asset))) << "byte " << at << " xor " << flip;
    }
    bytes[at] = original;
  }
  EXPECT_GT(refused, 0u);
  EXPECT_GT(harmless, 0u) << "a position may change a little without harm";
}

TEST(DamagedAsset, EveryTruncationIsRefused) {
  const std::vector<std::byte> good = cooked_wig();
  for (std::size_t n = 0; n < good.size(); ++n) {
    AlignedBytes cut({good.data(), n});
    EXPECT_FALSE(Asset{}.open(cut.bytes(), {.verify_hash = false})) << n << " of " << good.size() << " bytes";
  }
}

}  // namespace coif::cook::cook_test
