#include "cook/built_models.h"
#include "cook/cook.h"
#include "cook/dynamics/settle_dynamics.h"
#include "cook/pack/pack.h"
#include "cook/rig/colliders.h"
#include "models/small_asset.h"
#include "write/strip_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace coif::cook::leave_out_test {

/// A cooked model that stays open.
struct Cooked {
  Cooked(const importer::SourceModel& model, const Recipe& recipe) : result(run(model, recipe)), file(result.asset) {
    opened = bool(asset.open(file.bytes()));
  }
  static CookResult run(const importer::SourceModel& model, const Recipe& recipe) {
    auto cooked = cook(model, recipe, {});
    EXPECT_TRUE(cooked) << (cooked ? "" : cooked.error().message);
    return cooked ? *cooked : CookResult{};
  }
  [[nodiscard]] const LeftOut* left_out(const std::string& why) const {
    const auto found = std::ranges::find(result.report.left_out, why, &LeftOut::why);
    return found == result.report.left_out.end() ? nullptr : &*found;
  }

  CookResult result;
  AlignedBytes file;
  Asset asset;
  bool opened = false;
};

std::uint64_t chunk_bytes(const Asset& asset, std::span<const std::uint32_t> ids) {
  std::uint64_t bytes = 0;
  for (const ChunkEntry& entry : asset.chunks()) {
    if (std::ranges::find(ids, entry.id) != ids.end()) bytes += entry.bytes;
  }
  return bytes;
}

TEST(LeaveOut, EachKeyOfTheSceneLeavesItsChunksOutAndSaysTheirBytes) {
  struct Part {
    const char* key;
    bool Recipe::*field;
    std::vector<std::uint32_t> chunks;
  };
  const Part parts[] = {{"names", &Recipe::scene_names, {chunk::kNames}},
                        {"quality", &Recipe::scene_quality, {chunk::kQuality, chunk::kMotionNames}},
                        {"provenance", &Recipe::scene_provenance, {chunk::kProvenance}},
                        {"draw",
                         &Recipe::scene_draw,
                         {chunk::kVertices, chunk::kSkin, chunk::kIndices, chunk::kPatches, chunk::kLods,
                          chunk::kLodBones, chunk::kMaterial, chunk::kTextures, chunk::kTexels}}};
  const Cooked whole(make_wig(), default_recipe());
  for (const Part& part : parts) {
    Recipe recipe = default_recipe();
    recipe.*part.field = false;
    const Cooked left(make_wig(), recipe);
    ASSERT_TRUE(left.opened) << part.key;
    EXPECT_EQ(chunk_bytes(left.asset, part.chunks), 0u) << part.key;
    const LeftOut* note = left.left_out(std::string("\"scene.") + part.key + "\" is false");
    ASSERT_NE(note, nullptr) << part.key;
    EXPECT_EQ(note->bytes, chunk_bytes(whole.asset, part.chunks)) << part.key;
    EXPECT_EQ(whole.left_out(note->why), nullptr);
  }
}

TEST(LeaveOut, WhatIsCookedWithoutAPartIsWhatStrippingLeaves) {
  Recipe recipe = default_recipe();
  recipe.scene_draw = recipe.scene_names = recipe.scene_provenance = false;
  const Cooked left(make_wig(), recipe);
  Cooked whole(make_wig(), default_recipe());
  std::vector<std::uint32_t> ids = {chunk::kNames, chunk::kProvenance, chunk::kVertices, chunk::kMaterial,
                                    chunk::kTexels};
  EXPECT_EQ(strip_asset(whole.asset, whole.file.bytes(), ids).file, left.result.asset);
}

TEST(LeaveOut, ASceneThatDoesNotSimulateGetsTheHeadAlone) {
  Recipe recipe = default_recipe();
  recipe.scene_simulate = false;
  const Cooked left(make_wig(), recipe);
  ASSERT_TRUE(left.opened);
  EXPECT_EQ(left.asset.bones().size(), 1u);
  EXPECT_TRUE(left.asset.dynamics().empty());
  EXPECT_FALSE(left.asset.vertices().empty());
  for (const SkinRecord& skin : left.asset.skin()) EXPECT_TRUE(skin.bone[0] == 0 && skin.weight[0] == 255);
  const LeftOut* note = left.left_out("\"scene.simulate\" is false");
  ASSERT_NE(note, nullptr);
  const Cooked whole(make_wig(), default_recipe());
  const std::uint64_t saved = chunk_bytes(whole.asset, std::array{chunk::kBones, chunk::kDynamics, chunk::kChains}) -
                              chunk_bytes(left.asset, std::array{chunk::kBones});
  EXPECT_LE(note->bytes, saved);
  EXPECT_GE(note->bytes + sizeof(DynamicsRecord), saved) << "the head's own record of dynamics goes as well";
  EXPECT_EQ(note->ns_per_frame, nominal_cost(2, 1));
}

/// The torsion that all simulated bones have.
float torsion_of(const Cooked& cooked) {
  float torsion = -1;
  for (std::size_t b = 0; b < cooked.asset.bones().size(); ++b) {
    if (cooked.asset.bones()[b].kind != BoneKind::kSimulated) continue;
    EXPECT_TRUE(torsion < 0 || torsion == cooked.asset.dynamics()[b].torsion) << "bone " << b;
    torsion = cooked.asset.dynamics()[b].torsion;
  }
  return torsion;
}

TEST(LeaveOut, TwistGoesUnlessTheRecipeAsksForIt) {
  const std::string why = "no motion bends them by 120 degrees from their parents";
  Recipe by_curve = default_recipe();
  by_curve.resistance = {{0, 0.35}, {1, 0.06}};
  const Cooked chosen(make_wig(), by_curve);
  EXPECT_EQ(torsion_of(chosen), kShortestArc);
  const LeftOut* note = chosen.left_out(why);
  ASSERT_NE(note, nullptr);
  EXPECT_EQ(note->what, "twist of 2 bones in 1 of 1 chains");
  EXPECT_EQ(note->bytes, 0u) << "the asset is as long";
  EXPECT_NE(note->text().find("(" + std::to_string(note->bytes_per_head) + " bytes a head, "), std::string::npos)
      << note->text();
  Recipe recipe = default_recipe();
  for (const double torsion : {0.0, 7.0, double(kShortestArc)}) {
    recipe.torsion = torsion;
    const Cooked asked(make_wig(), recipe);
    EXPECT_EQ(torsion_of(asked), float(torsion));
    EXPECT_EQ(asked.left_out(why), nullptr);
  }
}

TEST(LeaveOut, ShiftAndMaskGoWithoutTheBaseTexture) {
  AssetContents contents = small_asset();
  Recipe recipe = default_recipe();
  recipe.scene_shift_mask = false;
  Findings findings;
  leave_out_parts(recipe, contents, findings);
  const auto& left_out = findings.left_out;
  ASSERT_EQ(left_out.size(), 1u);
  EXPECT_EQ(left_out[0].bytes, 8u + 4u + sizeof(TextureRecord)) << "its texels and what lay between";
  ASSERT_EQ(contents.textures.size(), 1u);
  EXPECT_EQ(contents.textures[0].role, TextureRole::kBaseColor);
  EXPECT_EQ(contents.texels.size(), contents.textures[0].bytes);
  AlignedBytes file(write_asset(contents));
  EXPECT_TRUE(Asset{}.open(file.bytes()));
  leave_out_parts(recipe, contents, findings);
  EXPECT_EQ(left_out.size(), 1u) << "what is not there is not left out";
}

Colliders three_shapes(std::vector<std::uint32_t> sets) {
  Colliders colliders;
  for (const double radius : {0.1, 0.2, 0.3}) {
    colliders.shapes.emplace_back();
    colliders.shapes.back().radii.setConstant(radius);
  }
  colliders.of_bone = std::move(sets);
  return colliders;
}

TEST(LeaveOut, CollidersThatNoBoneReachesGoAndTheOthersKeepTheirBones) {
  Colliders colliders = three_shapes({0, 0b100, 0b101});
  Findings findings;
  leave_out_colliders(colliders, findings);
  ASSERT_EQ(findings.left_out.size(), 1u);
  EXPECT_EQ(findings.left_out[0].text(), "collider 1: no bone can reach it (80 bytes)");
  ASSERT_EQ(colliders.shapes.size(), 2u);
  EXPECT_EQ(colliders.shapes[1].radii.x(), 0.3);
  EXPECT_EQ(colliders.of_bone, (std::vector<std::uint32_t>{0, 0b10, 0b11}));
  leave_out_colliders(colliders, findings);
  EXPECT_EQ(findings.left_out.size(), 1u) << "once is enough";
}

DetailLevel level(float screen_size, float error, std::vector<bool> simulated) {
  DetailLevel level;
  level.triangles_of = {{0, 1, 2}};
  level.screen_size = screen_size;
  level.error = error;
  level.simulated = std::move(simulated);
  return level;
}

std::vector<DetailLevel> four_levels() {
  return {level(0.5f, 0, {false, true, true}), level(0.25f, 0.001f, {false, true, false}),
          level(0.125f, 0.002f, {false, true, false}), level(0, 0.004f, {false, true, false})};
}

Recipe sizes(double largest, double smallest) {
  Recipe recipe = default_recipe();
  recipe.scene_largest_size = largest;
  recipe.scene_smallest_size = smallest;
  return recipe;
}

TEST(LeaveOut, LevelsThatNoSizeOfTheSceneUsesGo) {
  struct Case {
    double largest, smallest;
    std::vector<float> errors;  ///< Those of the levels that stay.
  };
  const Case cases[] = {{0, 0, {0, 0.001f, 0.002f, 0.004f}},
                        {1, 0, {0, 0.001f, 0.002f, 0.004f}},
                        {0.5, 0, {0, 0.001f, 0.002f, 0.004f}},
                        {0.49, 0, {0, 0.003f, 0.005f}},
                        {0.1, 0, {0}},
                        {0, 0.1, {0, 0.001f, 0.002f, 0.004f}},
                        {0, 0.125, {0, 0.001f, 0.002f}},
                        {0, 0.6, {0}},
                        {0.3, 0.2, {0, 0.003f}},
                        {0.3, 0.3, {0}}};
  for (const Case& test : cases) {
    std::vector<DetailLevel> levels = four_levels();
    Findings findings;
    leave_out_levels(sizes(test.largest, test.smallest), levels, findings);
    SCOPED_TRACE(testing::Message() << test.largest << " to " << test.smallest);
    ASSERT_EQ(levels.size(), test.errors.size());
    EXPECT_EQ(findings.left_out.size(), 4 - test.errors.size());
    for (std::size_t i = 0; i < test.errors.size(); ++i) EXPECT_FLOAT_EQ(levels[i].error, test.errors[i]);
    EXPECT_EQ(levels.back().screen_size, 0);
    EXPECT_EQ(levels.front().simulated, (std::vector<bool>{false, true, true})) << "bones move in some level";
    for (const LeftOut& gone : findings.left_out) EXPECT_EQ(gone.bytes, 12 + sizeof(PatchRecord) + sizeof(LodRecord));
  }
}

MaterialRecord packed(const std::string& material_keys) {
  const auto recipe = parse_recipe("{\"material\": {" + material_keys + "}}", "r.json");
  EXPECT_TRUE(recipe) << recipe.error().message;
  return pack_material(BaseColor{}, BakedTextures{}, HairMesh{}, recipe ? *recipe : default_recipe());
}

TEST(PackMaterial, ShadesAsAVolumeUnlessTold) {
  const MaterialRecord m = packed("");
  EXPECT_EQ(m.shading, ShadingModel::kVolume);
  EXPECT_EQ(m.light_cut, 0);
}

TEST(PackMaterial, HighlightsAsPublishedMeanTheThesisModel) {
  EXPECT_EQ(packed(R"("primary_exponent": 90)").shading, ShadingModel::kThesis);
  EXPECT_EQ(packed(R"("secondary_color": [1, 1, 1])").shading, ShadingModel::kThesis);
  EXPECT_EQ(packed(R"("primary_exponent": 90, "shading": "volume")").shading, ShadingModel::kVolume);
  const auto preset = parse_recipe(R"({"look": {"preset": "curly"}, "material": {"primary_exponent": 90}})", "r.json");
  ASSERT_TRUE(preset) << preset.error().message;
  EXPECT_EQ(preset->shading, "volume") << "a preset names the model, too";
}

TEST(PackMaterial, TakesTheModelByItsName) {
  EXPECT_EQ(packed(R"("shading": "thesis")").shading, ShadingModel::kThesis);
  EXPECT_EQ(packed(R"("shading": "kajiya-kay")").shading, ShadingModel::kKajiyaKay);
  EXPECT_EQ(packed(R"("shading": "marschner")").shading, ShadingModel::kMarschner);
  const auto wrong = parse_recipe(R"({"material": {"shading": "marshner"}})", "r.json");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("material.shading"), std::string::npos) << wrong.error().message;
  EXPECT_NE(wrong.error().message.find("kajiya-kay"), std::string::npos) << "lists what there is";
}

TEST(PackMaterial, TurnsDegreesIntoRadians) {
  const MaterialRecord m = packed(R"("tilt": -4, "roughness": 9, "scatter": 0.25)");
  EXPECT_NEAR(m.tilt, -4 * std::numbers::pi / 180, 1e-6);
  EXPECT_NEAR(m.roughness, 9 * std::numbers::pi / 180, 1e-6);
  EXPECT_EQ(m.scatter, 0.25f);
}

TEST(PackMaterial, RecipesRangesFitTheFormats) {
  for (const char* end : {R"("tilt": -20, "roughness": 1.2)", R"("tilt": 20, "roughness": 57)"}) {
    const MaterialRecord m = packed(end);
    EXPECT_LE(std::abs(m.tilt), kMostTilt);
    EXPECT_GE(m.roughness, kLeastRoughness);
    EXPECT_LE(m.roughness, kMostRoughness);
  }
}

TEST(PackMaterial, BoundedLightsAreCutByTheModelsBound) {
  for (const std::string name : {"thesis", "kajiya-kay", "marschner", "volume"}) {
    const MaterialRecord m = packed("\"energy\": \"bounded\", \"shading\": \"" + name + '"');
    EXPECT_LE((1 - m.light_cut) * furnace_bound(m), 1 + 1e-6) << name;
    EXPECT_EQ(m.light_cut > 0, name != "marschner") << name;
  }
}

TEST(PackMaterial, BoundedLightsOfDarkHairAreNotCutFurther) {
  const auto cut = [](const std::string& keys) {
    return packed(R"("energy": "bounded", "shading": "thesis")" + keys).light_cut;
  };
  EXPECT_EQ(cut(R"(, "base_color": [0.1, 0.1, 0.1, 1])"), 0);
  EXPECT_LT(cut(R"(, "base_color": [0.5, 0.5, 0.5, 1])"), cut(""));
}

}  // namespace coif::cook::leave_out_test
