#include "cook/bake_textures.h"

#include "cook/eac_rg11.h"
#include "cook/fill_gaps.h"
#include "cook/recipe_image.h"
#include "cook/shift_mask.h"
#include "cook/used_texels.h"
#include "parallel_for.h"

#include <algorithm>

namespace coif {
namespace {

void append(TextureRole role, TexelFormat format, std::span<const Image> mips, unsigned threads, BakedTextures& out) {
  out.texels.resize((out.texels.size() + 63) / 64 * 64);
  TextureRecord record{};
  record.role = role;
  record.format = format;
  record.width = mips[0].width;
  record.height = mips[0].height;
  record.mip_count = std::uint32_t(mips.size());
  record.offset = out.texels.size();
  for (const Image& mip : mips) {
    const auto encoded = format == TexelFormat::kRg11Eac ? encode_eac_rg11(mip, threads) : mip.texels;
    const auto bytes = std::as_bytes(std::span(encoded));
    out.texels.insert(out.texels.end(), bytes.begin(), bytes.end());
  }
  record.bytes = out.texels.size() - record.offset;
  out.records.push_back(record);
}

struct BaseMips {
  std::vector<Image> color;
  std::vector<Image> used;
};

BaseMips bake_base(const BaseColor& color, const HairMesh& hair, const Recipe& recipe, Transparency& transparency) {
  Image image = *color.image;
  Image used = used_texels(hair, image.width, image.height);
  transparency = choose_transparency(color, &image, used, recipe);
  if (transparency.ignores_alpha) {
    // Before filtering: colours count everywhere, as if nothing had ever been in the alpha channel.
    for (std::size_t i = 3; i < image.texels.size(); i += 4) image.texels[i] = 255;
  }
  image = reduce(std::move(image), recipe.texture_max_size, TexelMeaning::kSrgbColorAlpha);
  BaseMips mips;
  mips.used = make_mips(std::move(used), recipe.texture_max_size, TexelMeaning::kNumbers);
  fill_gaps(image, mips.used[0]);
  mips.color = make_mips(std::move(image), recipe.texture_max_size, TexelMeaning::kSrgbColorAlpha);
  return mips;
}

struct ShiftMask {
  std::vector<Image> mips;
  bool is_constant = false;
};

bool is_constant(const Image& image) {
  for (std::size_t i = image.channels; i < image.texels.size(); ++i) {
    if (image.texels[i] != image.texels[i - image.channels]) return false;
  }
  return true;
}

ShiftMask bake_shift_mask(const BaseColor& color, const RecipeImage& shift, const RecipeImage& mask,
                          bool strands_along_u, const Recipe& recipe) {
  const auto pointer = [](const RecipeImage& image) { return image.image ? &*image.image : nullptr; };
  Image whole = combine_shift_mask(pointer(shift), pointer(mask), recipe.texture_seed, strands_along_u);
  const bool constant = is_constant(whole);
  if (color.atlas && !constant) {
    whole = draw_atlas(*color.atlas, std::vector<const Image*>(color.atlas->tiles.size(), &whole));
  }
  return {make_mips(std::move(whole), recipe.texture_max_size, TexelMeaning::kNumbers), constant};
}

/// One number for all of the hair is the material's: the texture would be read for every pixel to say it again.
void keep_constants(const Image& image, TexelFormat format, std::span<const Image> mips, BakedTextures& out) {
  out.constant_shift = image.texels[0] / 255.0;
  out.constant_mask = image.texels[1] / 255.0;
  std::uint64_t bytes = sizeof(TextureRecord);
  for (std::uint32_t mip = 0; mip < mips.size(); ++mip) bytes += mip_bytes(format, image.width, image.height, mip);
  out.left_out.push_back({"texture of shift and mask", "both are the same everywhere; the material says them", bytes});
}

}  // namespace

tl::expected<BakedTextures, ToolError> bake_textures(const BaseColor& color, const HairMesh& hair, bool strands_along_u,
                                                     const Recipe& recipe, const CookSettings& settings) {
  BakedTextures baked;
  const auto shift = read_recipe_image(recipe.shift_texture, "shift", settings);
  const auto mask = read_recipe_image(recipe.mask_texture, "mask", settings);
  for (const auto* image : {&shift, &mask}) {
    if (!*image) return tl::unexpected(image->error());
    if ((*image)->image) baked.files.push_back((*image)->path);
  }
  const bool textured = color.image.has_value() && !hair.uvs.empty();
  if (!textured) baked.transparency = choose_transparency(color, nullptr, {}, recipe);
  if (hair.uvs.empty()) {
    baked.left_out.push_back({"textures", "the hair has no texture coordinates"});
    return baked;
  }
  BaseMips base;
  ShiftMask shift_mask;
  parallel_for(2, settings.threads, [&](std::size_t i) {
    if (i == 0 && textured) base = bake_base(color, hair, recipe, baked.transparency);
    if (i == 1) shift_mask = bake_shift_mask(color, *shift, *mask, strands_along_u, recipe);
  });
  const auto format = recipe.shift_mask_format == "eac" ? TexelFormat::kRg11Eac : TexelFormat::kRg8;
  if (textured) append(TextureRole::kBaseColor, TexelFormat::kSrgb8Alpha8, base.color, settings.threads, baked);
  if (shift_mask.is_constant) {
    keep_constants(shift_mask.mips[0], format, shift_mask.mips, baked);
  } else {
    append(TextureRole::kShiftMask, format, shift_mask.mips, settings.threads, baked);
  }
  baked.used = std::move(base.used);
  return baked;
}

}  // namespace coif
