#include "cook/transparency.h"

#include "cook/built_models.h"
#include "cook/image_files.h"
#include "cook/textured_hair.h"
#include "cook/used_texels.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

constexpr std::uint32_t kSide = 64;

/// Strands in the left half: clear, soft edges, cores of alpha 200. In the right half something else, all of it opaque.
Image hair_beside_a_face() {
  return painted(kSide, kSide, [](std::uint32_t x, auto) {
    const std::uint8_t strand[] = {0, 60, 200, 200, 200, 60};
    return Rgba{90, 60, 30, x < kSide / 2 ? strand[x % 6] : std::uint8_t{255}};
  });
}

Image used_part(float left, float right) {
  return used_texels(hair_from(strip_over({left, 0.02f}, {right, 0.98f})), kSide, kSide);
}

Transparency chosen_for(const Image& image, const Image& used, AlphaUse use, const Recipe& recipe = default_recipe()) {
  BaseColor color;
  color.image = image;
  color.alpha_use = use;
  color.alpha_cutoff = 0.35f;
  return choose_transparency(color, &image, used, recipe);
}

TEST(Transparency, AFaceInTheSameImageDoesNotCount) {
  const Image image = hair_beside_a_face();
  const Transparency hair = chosen_for(image, used_part(0.01f, 0.48f), AlphaUse::kUnknown);
  EXPECT_LT(hair.opaque_threshold, 200 / 255.0) << "the cores are opaque";
  EXPECT_GT(hair.opaque_threshold, 60 / 255.0);
  const Transparency face = chosen_for(image, used_part(0.52f, 0.99f), AlphaUse::kUnknown);
  EXPECT_EQ(face.opaque_threshold, 0);
  const Transparency both = chosen_for(image, used_part(0.01f, 0.99f), AlphaUse::kUnknown);
  EXPECT_GT(both.opaque_threshold, hair.opaque_threshold) << "the face would hide the hair's own core";
}

TEST(Transparency, BlendedHairIsMeasuredToo) {
  const Transparency chosen = chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), AlphaUse::kBlend);
  EXPECT_GT(chosen.opaque_threshold, 0.5);
  EXPECT_DOUBLE_EQ(chosen.discard_threshold, default_recipe().discard_threshold);
  ASSERT_EQ(chosen.notes.size(), 1u);
  EXPECT_NE(chosen.notes[0].find("opaque threshold 0.7"), std::string::npos) << chosen.notes[0];
}

TEST(Transparency, AMaskedMaterialKeepsItsCutoffAndBlendsNothing) {
  const Transparency masked = chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), AlphaUse::kMask);
  EXPECT_FLOAT_EQ(float(masked.opaque_threshold), 0.35f);
  EXPECT_EQ(masked.discard_threshold, masked.opaque_threshold);
  EXPECT_TRUE(masked.warnings.empty());
}

TEST(Transparency, AnOpaqueMaterialIgnoresAlphaAndWarnsWhereMuchOfItIsClear) {
  const Transparency hair = chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), AlphaUse::kOpaque);
  EXPECT_TRUE(hair.ignores_alpha);
  EXPECT_EQ(hair.opaque_threshold, 0);
  ASSERT_EQ(hair.warnings.size(), 1u);
  EXPECT_NE(hair.warnings[0].find("have alpha below 0.5"), std::string::npos);
  const Transparency face = chosen_for(hair_beside_a_face(), used_part(0.52f, 0.99f), AlphaUse::kOpaque);
  EXPECT_TRUE(face.ignores_alpha);
  EXPECT_TRUE(face.warnings.empty()) << face.warnings[0];
}

TEST(Transparency, WarnsOfHairWithoutAnOpaqueCore) {
  const Image faint = painted(kSide, kSide, [](std::uint32_t x, auto) { return Rgba{9, 9, 9, std::uint8_t(x + 20)}; });
  const Transparency chosen = chosen_for(faint, used_part(0, 1), AlphaUse::kUnknown);
  ASSERT_EQ(chosen.warnings.size(), 1u);
  EXPECT_NE(chosen.warnings[0].find("paint opaque cores"), std::string::npos);
  EXPECT_TRUE(chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), AlphaUse::kUnknown).warnings.empty());
}

TEST(Transparency, TheRecipeComesBeforeTheMaterial) {
  Recipe recipe = default_recipe();
  recipe.opaque_threshold = 0.9;
  for (const AlphaUse use : {AlphaUse::kUnknown, AlphaUse::kMask, AlphaUse::kOpaque}) {
    const Transparency chosen = chosen_for(hair_beside_a_face(), used_part(0.01f, 0.48f), use, recipe);
    EXPECT_EQ(chosen.opaque_threshold, 0.9);
    EXPECT_FALSE(chosen.ignores_alpha);
    ASSERT_EQ(chosen.warnings.size(), 1u) << "alpha 200 is below 0.9";
    EXPECT_NE(chosen.warnings[0].find("lower \"material.opaque_threshold\""), std::string::npos);
  }
}

TEST(Transparency, FactorsMultiplyTheTexture) {
  Recipe recipe = default_recipe();
  recipe.base_color[3] = 0.8;
  const Image image = hair_beside_a_face();
  const Image used = used_part(0.52f, 0.99f);
  const Transparency chosen = chosen_for(image, used, AlphaUse::kUnknown, recipe);
  EXPECT_GT(chosen.opaque_threshold, 0.5) << "alpha is 0.8 everywhere";
  EXPECT_LE(chosen.opaque_threshold, 0.8);
}

TEST(Transparency, HairWithoutAnImageHasOneAlpha) {
  BaseColor color;
  EXPECT_EQ(choose_transparency(color, nullptr, {}, default_recipe()).opaque_threshold, 0);
  color.factor.w() = 0.3f;
  EXPECT_FALSE(choose_transparency(color, nullptr, {}, default_recipe()).warnings.empty());
}

}  // namespace
}  // namespace coif
