#include "cook/built_models.h"
#include "cook/image_files.h"
#include "cook/pack/pack.h"
#include "cook/texture/alpha.h"
#include "cook/texture/bake_textures.h"
#include "cook/texture/transparency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace coif::bake_textures_test {

constexpr std::uint32_t kSide = 128;

/// Strands of uneven width and softness in the left half; alpha 1 in the right, which the hair does not show.
Image strands_beside_a_face() {
  return painted(kSide, kSide, [](std::uint32_t x, std::uint32_t y) {
    const double wave = 127.5 + 127.5 * std::sin(x * 0.9) * std::cos(y * 0.05);
    return Rgba{120, 80, 40, x < kSide / 2 ? std::uint8_t(wave) : std::uint8_t{255}};
  });
}

HairMesh left_half() { return hair_from(strip_over({0.01f, 0.01f}, {0.49f, 0.99f})); }

BakedTextures baked(const BaseColor& color, const HairMesh& hair, const Recipe& recipe, unsigned threads = 1) {
  auto result = bake_textures(color, hair, false, recipe, {.threads = threads, .recipe_directory = {}});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? std::move(*result) : BakedTextures{};
}

const TextureRecord& record_of(const BakedTextures& baked, TextureRole role) {
  const auto found = std::ranges::find(baked.records, role, &TextureRecord::role);
  if (found == baked.records.end()) throw std::logic_error("no such texture");
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
    for (std::size_t i = 0; i < bytes; ++i) mip.texels.push_back(std::uint8_t(baked.texels[at + i]));
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
    contents.textures = textures.records;
    contents.texels = textures.texels;
    contents.material = {pack_material(color, textures, left_half(), recipe)};
    keep_coverage(textures.used, contents);
    const auto mips = base_color_mips(contents);
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
  contents.textures = textures.records;
  contents.texels = textures.texels;
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
  color.alpha_use = AlphaUse::kOpaque;
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
  recipe.shift_mask_format = "rg8";
  const TextureRecord rg8 = record_of(baked(color, left_half(), recipe), TextureRole::kShiftMask);
  EXPECT_EQ(rg8.format, TexelFormat::kRg8);
  EXPECT_NEAR(double(eac.bytes), 0.5 * double(rg8.bytes), 0.01 * double(rg8.bytes));
}

TEST(BakeTextures, InAnAtlasShiftAndMaskFollowEachSurfacesOwnCoordinates) {
  SourceModel model;
  model.path = "wig.glb";
  add_surface(model, "red").base_color = {1, 0, 0, 1};
  add_surface(model, "blue").base_color = {0, 0, 1, 1};
  const HairMesh before = whole_hair(model);
  HairMesh hair = before;
  Recipe recipe = default_recipe();
  recipe.shift_mask_format = "rg8";
  const auto color = find_base_color(model, hair, recipe, {});
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

TEST(BakeTextures, ThreadsDoNotChangeTheBytes) {
  BaseColor color;
  color.image = strands_beside_a_face();
  const auto one = baked(color, left_half(), default_recipe(), 1).texels;
  EXPECT_EQ(one, baked(color, left_half(), default_recipe(), 3).texels);
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
    recipe.shift_texture = shift;
    recipe.mask_texture = mask;
    auto result = bake_textures(BaseColor{}, left_half(), false, recipe, {.recipe_directory = folder.path()});
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? std::move(*result) : BakedTextures{};
  };
  EXPECT_EQ(baked_from("one_differs.png", "same.png").records.size(), 1u);
  EXPECT_EQ(baked_from("same.png", "one_differs.png").records.size(), 1u);
  EXPECT_EQ(baked_from("same.png", "").records.size(), 1u) << "the mask is generated";
  const BakedTextures varying = baked_from("one_differs.png", "same.png");
  EXPECT_EQ(varying.constant_shift, 0.5);
  EXPECT_EQ(varying.constant_mask, 1);

  const BakedTextures constant = baked_from("same.png", "same.png");
  EXPECT_TRUE(constant.records.empty());
  EXPECT_DOUBLE_EQ(constant.constant_shift, 0.2);
  EXPECT_DOUBLE_EQ(constant.constant_mask, 0.2);
  ASSERT_EQ(constant.left_out.size(), 1u);
  EXPECT_EQ(constant.left_out[0].bytes, varying.texels.size() + sizeof(TextureRecord));

  const MaterialRecord plain = pack_material(BaseColor{}, varying, left_half(), recipe);
  const MaterialRecord said = pack_material(BaseColor{}, constant, left_half(), recipe);
  EXPECT_NEAR(said.primary_shift, plain.primary_shift - 0.3f, 1.0e-6);
  EXPECT_NEAR(said.secondary_shift, plain.secondary_shift - 0.3f, 1.0e-6);
  EXPECT_NEAR(said.secondary_color[0], 0.2f * plain.secondary_color[0], 1.0e-6);
  EXPECT_EQ(said.primary_color[0], plain.primary_color[0]) << "the mask is the secondary highlight's";
}

TEST(BakeTextures, WithoutTextureCoordinatesNothingIsStored) {
  BaseColor color;
  color.image = strands_beside_a_face();
  HairMesh hair = left_half();
  hair.uvs.clear();
  const BakedTextures textures = baked(color, hair, default_recipe());
  EXPECT_TRUE(textures.records.empty());
  EXPECT_TRUE(textures.texels.empty());
  EXPECT_EQ(textures.left_out.size(), 1u);
}

// A decoder written to the Khronos Data Format Specification, apart from the encoder.
constexpr int kModifier[16][8] = {
    {-3, -6, -9, -15, 2, 5, 8, 14}, {-3, -7, -10, -13, 2, 6, 9, 12}, {-2, -5, -8, -13, 1, 4, 7, 12},
    {-2, -4, -6, -13, 1, 3, 5, 12}, {-3, -6, -8, -12, 2, 5, 7, 11},  {-3, -7, -9, -11, 2, 6, 8, 10},
    {-4, -7, -8, -11, 3, 6, 7, 10}, {-3, -5, -8, -11, 2, 4, 7, 10},  {-2, -6, -8, -10, 1, 5, 7, 9},
    {-2, -5, -8, -10, 1, 4, 7, 9},  {-2, -4, -8, -10, 1, 3, 7, 9},   {-2, -5, -7, -10, 1, 4, 6, 9},
    {-3, -4, -7, -10, 2, 3, 6, 9},  {-1, -2, -3, -10, 0, 1, 2, 9},   {-4, -6, -8, -9, 3, 5, 7, 8},
    {-3, -5, -7, -9, 2, 4, 6, 8},
};

/// 0..1 as a sampler returns it.
double decode(std::span<const std::uint8_t> bytes, const Image& like, std::uint32_t x, std::uint32_t y, int channel) {
  const std::size_t block = std::size_t(y / 4) * ((like.width + 3) / 4) + x / 4;
  const std::uint8_t* half = &bytes[block * 16 + std::size_t(channel) * 8];
  const std::uint32_t texel = x % 4 * 4 + y % 4;
  const std::uint32_t first_bit = 16 + 3 * texel;
  int index = 0;
  for (std::uint32_t bit = first_bit; bit < first_bit + 3; ++bit)
    index = index * 2 + (half[bit / 8] >> (7 - bit % 8) & 1);
  const int modifier = kModifier[half[1] & 15][index], multiplier = half[1] >> 4;
  const int value = half[0] * 8 + 4 + (multiplier == 0 ? modifier : modifier * multiplier * 8);
  return std::clamp(value, 0, 2047) / 2047.0;
}

double worst_difference(const Image& image) {
  const auto bytes = encode_eac_rg11(image, 1);
  double worst = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      for (int channel = 0; channel < 2; ++channel) {
        const double wanted = image.texels[2 * (std::size_t(y) * image.width + x) + std::size_t(channel)] / 255.0;
        worst = std::max(worst, std::abs(decode(bytes, image, x, y, channel) - wanted));
      }
    }
  }
  return worst;
}

double psnr(const Image& image, int channel) {
  const auto bytes = encode_eac_rg11(image, 2);
  double sum = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const double wanted = image.texels[2 * (std::size_t(y) * image.width + x) + std::size_t(channel)] / 255.0;
      sum += std::pow(decode(bytes, image, x, y, channel) - wanted, 2);
    }
  }
  return 10 * std::log10(double(image.texel_count()) / sum);
}

Image filled(std::uint32_t width, std::uint32_t height, auto value) {
  Image image{width, height, 2, {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      for (std::uint32_t channel = 0; channel < 2; ++channel) image.texels.push_back(value(x, y, channel));
    }
  }
  return image;
}

TEST(EacRg11, KeepsEveryFlatValueFinerThanEightBits) {
  for (int value = 0; value < 256; ++value) {
    const Image flat = filled(4, 4, [&](auto...) { return std::uint8_t(value); });
    EXPECT_LT(worst_difference(flat), 0.5 / 2047 + 1e-9) << value;
  }
}

TEST(EacRg11, KeepsTwoValuesApart) {
  // Black and white, each texel in its own place: an index in the wrong order would be off by one.
  for (std::uint32_t lone = 0; lone < 16; ++lone) {
    const Image image = filled(4, 4, [&](std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
      return std::uint8_t((y * 4 + x == lone) == (channel == 0) ? 255 : 0);
    });
    EXPECT_LT(worst_difference(image), 0.004) << lone;
  }
}

TEST(EacRg11, FollowsRampsOfEverySlope) {
  for (int slope = 0; slope <= 17; ++slope) {
    const Image ramp = filled(4, 4, [&](std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
      return std::uint8_t(channel == 0 ? slope * int(y * 4 + x) : 255 - slope * int(x * 4 + y));
    });
    // Sixteen values on eight palette entries: half of a palette step, and its unevenness.
    EXPECT_LT(worst_difference(ramp), (1.6 * slope + 1) / 255.0) << slope;
  }
}

TEST(EacRg11, GeneratedShiftAndMaskComeBackCloseToTheirOriginal) {
  for (const bool along_u : {false, true}) {
    const Image image = generate_shift_mask(1, along_u);
    // The best that any encoder can do here, found by trying every code, is 48.2 and 38.5 dB.
    EXPECT_GT(psnr(image, 0), 47.7) << "shift";
    EXPECT_GT(psnr(image, 1), 38.2) << "mask";
    RecordProperty(along_u ? "shift_db_along_u" : "shift_db", std::to_string(psnr(image, 0)));
    RecordProperty(along_u ? "mask_db_along_u" : "mask_db", std::to_string(psnr(image, 1)));
  }
}

TEST(EacRg11, OddSizesAreWholeBlocksAndLoseNothingAtTheirEdges) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {2u, 1u}, {5u, 3u}, {7u, 9u}}) {
    const Image image = filled(width, height, [](std::uint32_t x, std::uint32_t y, std::uint32_t channel) {
      return std::uint8_t(100 + (x % 4 < 2 ? 0 : 40) * (channel == 0) + (y % 4 < 2 ? 0 : 40) * (channel == 1));
    });
    EXPECT_EQ(encode_eac_rg11(image, 1).size(), (width + 3) / 4 * ((height + 3) / 4) * 16);
    EXPECT_LT(worst_difference(image), 1 / 255.0) << width << " x " << height;
  }
}

TEST(EacRg11, GivesTheSameBytesForAnyNumberOfThreads) {
  const Image image = generate_shift_mask(3, false);
  const auto one = encode_eac_rg11(image, 1);
  EXPECT_EQ(one, encode_eac_rg11(image, 2));
  EXPECT_EQ(one, encode_eac_rg11(image, 7));
}

}  // namespace coif::bake_textures_test
