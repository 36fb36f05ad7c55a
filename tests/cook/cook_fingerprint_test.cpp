// Whole cooks of models that are made up here, chunk by chunk as they were. bob's is in tests/golden, the long sample's
// beside it.

#include "models/cook_fingerprint.h"
#include "cook/built_models.h"
#include "cook/cook.h"
#include "cook/fitted_wig.h"
#include "cook/image_files.h"
#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::cook::cook_fingerprint_test {

void expect_as_before(const std::string& name, const importer::SourceModel& model,
                      const Recipe& recipe = default_recipe()) {
  const auto cooked = cook(model, recipe, {.threads = 2, .recipe_directory = {}});
  ASSERT_TRUE(cooked) << cooked.error().message;
  AlignedBytes file(cooked->asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_TRUE(is_cooked_as_before(name, asset));
}

/// Strands with soft sides that thin out towards their ends.
Image strand_image() {
  return painted(64, 64, [](std::uint32_t x, std::uint32_t y) {
    const double wave = 0.5 + 0.5 * std::sin(double(x) * 0.7), end = std::max(0.0, double(y) / 64 - 0.5);
    const double alpha = std::clamp(1.4 - 2.4 * end - wave * 0.6, 0.0, 1.0);
    return Rgba{std::uint8_t(90 + 60 * wave), std::uint8_t(60 + 40 * wave), 40, std::uint8_t(255 * alpha)};
  });
}

/// Tails around a head and strips on it, without bones.
importer::SourceModel tails(bool has_texture) {
  importer::SourceModel model;
  model.path = "tails.fbx";
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  for (const double degrees : {-150.0, -110.0, 100.0, 130.0, 165.0, 195.0}) {
    model.meshes.push_back(make_tail(degrees, 0.28f + 0.0008f * float(degrees), 16));
  }
  for (const double degrees : {-60.0, 0.0, 45.0, 90.0, 180.0}) model.meshes.push_back(make_scalp_strip(degrees));
  importer::SourceMaterial material;
  material.name = "hair";
  if (has_texture) {
    model.images.push_back({"strands", encoded(strand_image(), FileFormat::kPng)});
    material.base_texture.image = 0;
    material.alpha_use = importer::AlphaUse::kBlend;
  }
  model.materials.push_back(material);
  for (std::size_t m = 0; m < model.meshes.size(); ++m) {
    importer::SourceMesh& mesh = model.meshes[m];
    mesh.name = "strip_" + std::to_string(m);
    mesh.node = 0;
    mesh.material = 0;
    mesh.uvs.clear();
    const auto rows = float(mesh.positions.size() / 2 - 1);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.uvs.emplace_back(float(v % 2), float(v / 2) / rows);
  }
  return model;
}

TEST(CookFingerprint, OfTailsWithoutBones) { expect_as_before("tails", tails(false)); }

TEST(CookFingerprint, OfSoftTailsWithoutBones) {
  Recipe recipe = default_recipe();
  recipe.order_max = 4;
  expect_as_before("soft_tails", tails(true), recipe);
}

TEST(CookFingerprint, OfAWigWithBones) { expect_as_before("wig", make_wig()); }

TEST(CookFingerprint, OfACapOnAHead) {
  importer::SourceModel model = make_wig();
  append_piece(model.meshes[0], make_cap(24, 12, 5.0f), 1);
  expect_as_before("cap", model);
}

TEST(SoftBody, HasNormalsForHairWithGaps) {
  for (const bool has_gaps : {false, true}) {
    const auto cooked = cook(tails(has_gaps), default_recipe(), {.threads = 2, .recipe_directory = {}});
    ASSERT_TRUE(cooked) << cooked.error().message;
    AlignedBytes file(cooked->asset);
    Asset asset;
    ASSERT_TRUE(asset.open(file.bytes()));
    EXPECT_EQ(asset.material()->shading, ShadingModel::kVolume);
    EXPECT_EQ((asset.material()->flags & kMaterialVolumeNormals) != 0, has_gaps)
        << "locks that are modelled whole keep their own";
  }
}

}  // namespace coif::cook::cook_fingerprint_test
