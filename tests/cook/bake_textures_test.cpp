#include "cook/texture/bake_textures.h"
#include "cook/built_models.h"
#include "cook/image_files.h"
#include "cook/pack/pack.h"
#include "cook/recipe/recipe.h"
#include "cook/texture/alpha.h"
#include "cook/texture/transparency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace coif::cook::bake_textures_test {

constexpr std::uint32_t kSide = 128;

/// Strands of uneven width and softness in the left half; alpha 1 in the right, which the hair does not show.
Image strands_beside_a_face() {
  return painted(kSide, kSide, [](std::uint32_t x, std::uint32_t y) {
    const double wave = 127.5 + 127.5 * std::sin(x * 0.9) * std::cos(y * 0.5);
    return Rgba{120, 80, 40, x < kSide / 2 ? std::uint8_t(wave) : std::uint8_t{255}};
  });
}

HairMesh left_half() { return hair_from(strip_over({0.01f, 0.01f}, {0.49f, 0.99f})); }

/// The textures, and what was said of them.
struct SaidTextures : BakedTextures, Findings {};

SaidTextures baked(const BaseColor& color, const HairMesh& hair, const Recipe& recipe,
                   const CookSettings& settings = {}) {
  Findings findings;
  auto result = bake_textures(color, strips_from(hair), recipe, settings, findings);
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return {result ? std::move(*result) : BakedTextures{}, findings};
}

const TextureRecord& record_of(const BakedTextures& baked, TextureRole role) {
  const auto found = std::ranges::find(baked.stored.records, role, &TextureRecord::role);
  if (found == baked.stored.records.end()) throw std::logic_error("no such texture");
  return *found;
}

/// The texture's levels as they are stored; not for compressed ones.
std::vector<Image> stored_mips(const BakedTextures& baked, TextureRole role, std::uint32_t channels) {
  const TextureRecord& record = record_of(baked, role);
  std::vector<Image> mips;
  std::size_t at = record.offset;
  for (std::uint32_t level = 0; level < record.mip_count; ++level) {
    Image mip{std::max(1u, record.width >> level), std::max(1u, record.height >> level), channels, {}};
    const std::size_t bytes = mip.texel_count() * channels;
    for (std::size_t i = 0; i < bytes; ++i) mip.texels.push_back(std::uint8_t(baked.stored.texels[at + i]));
    at += bytes;
    mips.push_back(std::move(mip));
  }
  EXPECT_EQ(at, record.offset + record.bytes);
  return mips;
}

TEST(BakeTextures, MipsKeepTheCoverageOfWhatTheHairShowsAtTheThresholdInUse) {
  BaseColor color;
  color.image = strands_beside_a_face();
  for (const double threshold : {0.0, 0.6, 0.9}) {
    Recipe recipe = default_recipe();
    recipe.opaque_threshold = threshold;
    const BakedTextures textures = baked(color, left_half(), recipe);
    const double in_use = textures.transparency.opaque_threshold;
    ASSERT_GT(in_use, 0.4);
    AssetContents contents;
    contents.textures = textures.stored.records;
    contents.texels = textures.stored.texels;
    contents.material = {pack_material(color, textures, left_half(), recipe)};
    const auto asked_for = mips_for_threshold(textures.used, contents, contents.material[0].opaque_threshold);
    keep_coverage(textures.used, contents);
    const auto mips = base_color_mips(contents);
    for (std::size_t level = 0; level < mips.size(); ++level) EXPECT_EQ(asked_for[level].texels, mips[level].texels);
    const AlphaThresholds thresholds = thresholds_in_texture(contents.material[0]);
    const auto used = make_mips(used_texels(left_half(), kSide, kSide), kSide, TexelMeaning::kNumbers);
    const AlphaCoverage wanted = alpha_coverage(mips[0], used[0], thresholds);
    ASSERT_GT(wanted.opaque, 0.05);
    ASSERT_LT(wanted.opaque, 0.6);
    for (std::size_t level = 1; level < 5; ++level) {
      const AlphaCoverage found = alpha_coverage(mips[level], used[level], thresholds);
      EXPECT_NEAR(found.opaque, wanted.opaque, 0.03 * wanted.opaque) << threshold << ", level " << level;
      EXPECT_NEAR(found.opacity, wanted.opacity, 0.03 * wanted.opacity) << threshold << ", level " << level;
    }
  }
}

/// The brightness of what a sampler finds between the texels, for all samples that are drawn: linear light, 0..1.
double darkest_drawn(const Image& mip, const Image& used, double discard) {
  const auto light = [](std::uint8_t texel) { return std::pow(texel / 255.0, 2.2); };
  double darkest = 1;
  for (std::uint32_t y = 0; y < mip.height; ++y) {
    for (std::uint32_t x = 0; x < mip.width; ++x) {
      if (used.texels[std::size_t(y) * mip.width + x] == 0) continue;
      for (const double u : {0.1, 0.5, 0.9}) {
        for (const double v : {0.1, 0.5, 0.9}) {
          double alpha = 0, color = 0;
          for (std::uint32_t k = 0; k < 4; ++k) {
            const std::uint32_t i = (x + k % 2) % mip.width, j = (y + k / 2) % mip.height;
            const std::uint8_t* texel = &mip.texels[4 * (std::size_t(j) * mip.width + i)];
            const double share = (k % 2 == 0 ? 1 - u : u) * (k / 2 == 0 ? 1 - v : v);
            alpha += share * texel[3] / 255;
            color += share * light(texel[0]);
          }
          if (alpha >= discard) darkest = std::min(darkest, color);
        }
      }
    }
  }
  return darkest;
}

TEST(BakeTextures, WhatSaysNothingIsNotStored) {
  BaseColor color;
  color.image = flat(64, 64, {90, 90, 90, 255});
  const SaidTextures textures = baked(color, left_half(), default_recipe());
  const TextureRecord& record = record_of(textures, TextureRole::kBaseColor);
  EXPECT_EQ(record.width * record.height, 1u);
  ASSERT_EQ(textures.left_out.size(), 1u);
  EXPECT_EQ(textures.left_out[0].what, "texels of the base colour: 1 x 1 of 64 x 64 are kept");
  EXPECT_EQ(textures.left_out[0].bytes, 4u * (4096 + 1024 + 256 + 64 + 16 + 4));
}

TEST(BakeTextures, WhiteHairOnBlackHasNoDarkEdgeInAnyMip) {
  // White strands with soft edges; black under every clear texel, under those as good as clear, and where no hair is.
  BaseColor color;
  color.image = painted(kSide, kSide, [](std::uint32_t x, std::uint32_t y) {
    const double strand = std::sin(x * 0.4 + 0.5 * std::sin(y * 0.05));
    const auto alpha = std::uint8_t(std::clamp(400 * strand, 0.0, 255.0));
    const std::uint8_t white = alpha > 5 && x < kSide / 2 ? 255 : 0;
    return Rgba{white, white, white, alpha};
  });
  const BakedTextures textures = baked(color, left_half(), default_recipe());
  AssetContents contents;
  contents.textures = textures.stored.records;
  contents.texels = textures.stored.texels;
  contents.material = {pack_material(color, textures, left_half(), default_recipe())};
  keep_coverage(textures.used, contents);
  const auto mips = base_color_mips(contents);
  for (std::size_t level = 0; level < mips.size(); ++level) {
    EXPECT_GT(darkest_drawn(mips[level], textures.used[level], contents.material[0].discard_threshold), 0.97) << level;
  }
}

TEST(BakeTextures, WhatTheHairDoesNotUseDoesNotShowInMips) {
  BaseColor color;
  color.image = painted(kSide, kSide, [](std::uint32_t x, std::uint32_t) {
    return x < kSide / 2 ? Rgba{200, 30, 30, 255} : Rgba{30, 30, 200, 255};
  });
  const auto mips = stored_mips(baked(color, left_half(), default_recipe()), TextureRole::kBaseColor, 4);
  for (std::size_t level = 0; level < mips.size(); ++level) {
    const Image& mip = mips[level];
    for (std::uint32_t y = 0; y < mip.height; ++y) {
      EXPECT_GT(mip.texels[4 * std::size_t(y) * mip.width], 190) << "level " << level;
      EXPECT_LT(mip.texels[4 * std::size_t(y) * mip.width + 2], 60) << "level " << level;
    }
  }
}

TEST(BakeTextures, AnOpaqueMaterialIsStoredOpaque) {
  BaseColor color;
  color.image = strands_beside_a_face();
  color.alpha_use = importer::AlphaUse::kOpaque;
  const auto mips = stored_mips(baked(color, left_half(), default_recipe()), TextureRole::kBaseColor, 4);
  for (const Image& mip : mips) {
    for (std::size_t i = 3; i < mip.texels.size(); i += 4) ASSERT_EQ(mip.texels[i], 255);
  }
}

TEST(BakeTextures, ShiftAndMaskAreStoredAsTheRecipeSays) {
  BaseColor color;
  Recipe recipe = default_recipe();
  const TextureRecord eac = record_of(baked(color, left_half(), recipe), TextureRole::kShiftMask);
  EXPECT_EQ(eac.format, TexelFormat::kRg11Eac);
  recipe.shift_mask_format = ShiftMaskFormat::kRg8;
  const TextureRecord rg8 = record_of(baked(color, left_half(), recipe), TextureRole::kShiftMask);
  EXPECT_EQ(rg8.format, TexelFormat::kRg8);
  EXPECT_NEAR(double(eac.bytes), 0.5 * double(rg8.bytes), 0.01 * double(rg8.bytes));
}

TEST(BakeTextures, InAnAtlasShiftAndMaskFollowEachSurfacesOwnCoordinates) {
  importer::SourceModel model;
  model.path = "wig.glb";
  add_surface(model, "red").base_color = {1, 0, 0, 1};
  add_surface(model, "blue").base_color = {0, 0, 1, 1};
  const HairMesh before = whole_hair(model);
  HairMesh hair = before;
  Recipe recipe = default_recipe();
  recipe.shift_mask_format = ShiftMaskFormat::kRg8;
  recipe.shading = "thesis";
  const auto color = find_base_color(model, hair, recipe, {}, unheard());
  ASSERT_TRUE(color && color->atlas);
  const Image stored = stored_mips(baked(*color, hair, recipe), TextureRole::kShiftMask, 2)[0];
  const Image own = generate_shift_mask(recipe.texture_seed, false);
  for (const AtlasTile& tile : color->atlas->tiles) {
    for (std::uint32_t i = 0; i < tile.height; ++i) {
      const double v = (i + 0.5) / tile.height, u = 0.5 / tile.width;
      const std::size_t from = std::size_t(v * own.height) * own.width + std::size_t(u * own.width);
      EXPECT_EQ(stored.texels[2 * (std::size_t(tile.y + i) * stored.width + tile.x)], own.texels[2 * from]);
    }
  }
}

TEST(BakeTextures, GeneratedShiftsAreCalmerWhereTheyTellFibresApartInAllLight) {
  Recipe recipe = default_recipe();
  recipe.shift_mask_format = ShiftMaskFormat::kRg8;
  const auto farthest = [&](const char* shading) {
    recipe.shading = shading;
    const Image stored = stored_mips(baked({}, left_half(), recipe), TextureRole::kShiftMask, 2)[0];
    int most = 0;
    for (std::size_t i = 0; i < stored.texels.size(); i += 2) most = std::max(most, std::abs(stored.texels[i] - 128));
    return most;
  };
  EXPECT_GT(farthest("thesis"), 60);
  EXPECT_NEAR(farthest("volume"), 0.3 * farthest("thesis"), 2);
}

TEST(BakeTextures, WhatIsUsedOfAWideImageIsKnownTexelByTexel) {
  BaseColor color;
  color.image = painted(128, 32, [](std::uint32_t x, std::uint32_t y) {
    return Rgba{std::uint8_t(x * 37), std::uint8_t(y * 53), 40, 255};
  });
  const HairMesh top = hair_from(strip_over({0.01f, 0.01f}, {0.99f, 0.49f}));
  const BakedTextures textures = baked(color, top, default_recipe());
  ASSERT_EQ(textures.used[0].width, 128u);
  ASSERT_EQ(textures.used[0].height, 32u);
  for (const std::size_t x : {2u, 64u, 125u}) {
    EXPECT_EQ(textures.used[0].texels[8 * 128 + x], 255) << x;
    EXPECT_EQ(textures.used[0].texels[24 * 128 + x], 0) << x;
  }
}

TEST(BakeTextures, ThreadsDoNotChangeTheBytes) {
  BaseColor color;
  color.image = strands_beside_a_face();
  const auto one = baked(color, left_half(), default_recipe(), {.threads = 1, .recipe_directory = {}}).stored.texels;
  EXPECT_EQ(one, baked(color, left_half(), default_recipe(), {.threads = 3, .recipe_directory = {}}).stored.texels);
}

TEST(BakeTextures, ShiftAndMaskThatAreTheSameEverywhereAreNumbersInstead) {
  const ImageFolder folder;
  const auto store = [&](const char* name, bool varies) {
    const Image image = painted(16, 16, [&](std::uint32_t x, std::uint32_t) {
      return Rgba{std::uint8_t(varies && x == 7 ? 52 : 51), 0, 0, 255};
    });
    folder.write(name, encoded(image, FileFormat::kPng));
  };
  store("same.png", false);
  store("one_differs.png", true);
  Recipe recipe = default_recipe();
  const auto baked_from = [&](const char* shift, const char* mask) {
    recipe.shift_texture.file = shift;
    recipe.mask_texture.file = mask;
    return baked(BaseColor{}, left_half(), recipe, {.recipe_directory = folder.path()});
  };
  EXPECT_EQ(baked_from("one_differs.png", "same.png").stored.records.size(), 1u);
  EXPECT_EQ(baked_from("same.png", "one_differs.png").stored.records.size(), 1u);
  EXPECT_EQ(baked_from("same.png", "").stored.records.size(), 1u) << "the mask is generated";
  const BakedTextures varying = baked_from("one_differs.png", "same.png");
  EXPECT_EQ(varying.constant_shift, 0.5);
  EXPECT_EQ(varying.constant_mask, 1);

  const SaidTextures constant = baked_from("same.png", "same.png");
  EXPECT_TRUE(constant.stored.records.empty());
  EXPECT_DOUBLE_EQ(constant.constant_shift, 0.2);
  EXPECT_DOUBLE_EQ(constant.constant_mask, 0.2);
  ASSERT_EQ(constant.left_out.size(), 1u);
  EXPECT_EQ(constant.left_out[0].bytes, varying.stored.texels.size() + sizeof(TextureRecord));

  const MaterialRecord plain = pack_material(BaseColor{}, varying, left_half(), recipe);
  const MaterialRecord said = pack_material(BaseColor{}, constant, left_half(), recipe);
  EXPECT_NEAR(said.primary_shift, plain.primary_shift - 0.3f, 1.0e-6);
  EXPECT_NEAR(said.secondary_shift, plain.secondary_shift - 0.3f, 1.0e-6);
  EXPECT_NEAR(said.secondary_color[0], 0.2f * plain.secondary_color[0], 1.0e-6);
  EXPECT_EQ(said.primary_color[0], plain.primary_color[0]) << "the mask is the secondary highlight's";
}

TEST(BakeTextures, NumbersOfStrandsThatTheRecipeNamesShiftTheirHighlights) {
  const ImageFolder folder;
  folder.write("packed.png", encoded(painted(16, 16,
                                             [](std::uint32_t x, std::uint32_t) {
                                               return Rgba{9, 9, std::uint8_t(x < 4 ? 0 : 255), 255};
                                             }),
                                     FileFormat::kPng));
  importer::SourceModel model;
  model.path = folder.source("wig.glb").string();
  add_surface(model, "hair");
  HairMesh hair = whole_hair(model);
  Recipe recipe = default_recipe();
  recipe.strand_id_texture = {"packed.png", TextureChannel::kBlue, false};
  recipe.shift_mask_format = ShiftMaskFormat::kRg8;
  const CookSettings settings{.recipe_directory = folder.path()};
  const auto color = find_base_color(model, hair, recipe, settings, unheard());
  ASSERT_TRUE(color);
  const SaidTextures textures = baked(*color, hair, recipe, settings);
  ASSERT_EQ(textures.stored.records.size(), 1u);
  EXPECT_EQ(textures.stored.records[0].width, 16u);
  const auto shift_at = [&](std::size_t x) { return int(std::uint8_t(textures.stored.texels[2 * x])); };
  EXPECT_LT(shift_at(1), 60) << "strand 0";
  EXPECT_GT(shift_at(8), 195) << "strand 1";
}

TEST(BakeTextures, WithoutTextureCoordinatesNothingIsStored) {
  BaseColor color;
  color.image = strands_beside_a_face();
  HairMesh hair = left_half();
  hair.uvs.clear();
  const SaidTextures textures = baked(color, hair, default_recipe());
  EXPECT_TRUE(textures.stored.records.empty());
  EXPECT_TRUE(textures.stored.texels.empty());
  EXPECT_EQ(textures.left_out.size(), 1u);
}

}  // namespace coif::cook::bake_textures_test
