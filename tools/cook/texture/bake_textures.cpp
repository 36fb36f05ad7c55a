#include "cook/texture/bake_textures.h"

#include "base/hair_runtime.h"
#include "base/parallel_for.h"
#include "cook/recipe/drawn_recipe.h"
#include "cook/texture/recipe_maps.h"
#include "cook/texture/relief.h"
#include "cook/texture/texture_atlas.h"
#include "cook/texture/transparency.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif::cook {
namespace {

struct BaseMips {
  std::vector<Image> color;
  std::vector<Image> used;
};

void report_spared(const Image& whole, const DetailedImage& kept, Findings& findings) {
  const Image& image = kept.image;
  if (image.width == whole.width && image.height == whole.height) return;
  findings.leave_out(
      {fmt::format("texels of the base colour: {} x {} of {} x {} are kept", image.width, image.height, whole.width,
                   whole.height),
       fmt::format("more would say no more: it is off by {:.2f} of 255 (RMS), {:.1f} at most", kept.error.rms,
                   kept.error.most),
       bytes_with_mips(TexelFormat::kSrgb8Alpha8, whole) - bytes_with_mips(TexelFormat::kSrgb8Alpha8, image)});
}

std::uint32_t size_limit(const BaseColor& color, const DrawnRecipe& recipe) {
  return color.max_size.value_or(texture_limit(recipe));
}

BaseMips bake_base(const BaseColor& color, const HairMesh& hair, const DrawnRecipe& recipe, Transparency& transparency,
                   Findings& findings) {
  const std::uint32_t max_size = size_limit(color, recipe);
  Image image = *color.image;
  Image used = used_texels(hair, image.width, image.height);
  transparency = choose_transparency(color, &image, used, recipe, findings);
  if (transparency.ignores_alpha) {
    // Before filtering: every colour counts, as if the alpha channel had always been full.
    for (std::size_t i = 3; i < image.texels.size(); i += 4) image.texels[i] = 255;
  }
  image = reduce(std::move(image), max_size, TexelMeaning::kSrgbColorAlpha);
  used = reduce(std::move(used), max_size, TexelMeaning::kNumbers);
  const std::vector<TexelBorder> borders = borders_where_pictures_end(hair, image);
  fill_gaps(image, used);
  repeat_edges(borders, used, image);
  const Image whole{image.width, image.height, 4, {}};
  DetailedImage detailed = reduce_to_detail(std::move(image), used, TexelMeaning::kSrgbColorAlpha);
  report_spared(whole, detailed, findings);
  image = std::move(detailed.image);
  if (image.width != whole.width || image.height != whole.height) {
    used = shrink(used, image.width, image.height, TexelMeaning::kNumbers);
  }
  BaseMips mips;
  mips.used = make_mips(std::move(used), max_size, TexelMeaning::kNumbers);
  mips.color = make_mips(std::move(image), max_size, TexelMeaning::kSrgbColorAlpha);
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

/// Mips in which strands differ as much as they do close by.
std::vector<Image> mips_of_strands(Image image, const HairMesh& hair, std::uint32_t max_size) {
  std::vector<Image> mips = make_mips(std::move(image), max_size, TexelMeaning::kNumbers);
  keep_spread(mips, used_texels(hair, mips[0].width, mips[0].height));
  return mips;
}

/// Takes generated numbers nearer to their middle. A volume of fibres tells strands apart by them in all light, and
/// where only most of an image's locks lie along one of its axes they would draw bands across the others.
void calm(Image& shift_mask) {
  constexpr double kShare = 0.3;  // by eye, of artists' hair whose locks lie in all directions
  for (std::size_t i = 0; i < shift_mask.texels.size(); i += 2) {
    shift_mask.texels[i] = std::uint8_t(std::lround(127.5 + kShare * (double(shift_mask.texels[i]) - 127.5)));
  }
}

ShiftMask bake_shift_mask(const BaseColor& color, const RecipeImage& shift, const RecipeImage& mask,
                          const HairStrips& hair, const DrawnRecipe& recipe) {
  const std::optional<Image>& strands = color.strand_ids ? color.strand_ids : color.strands;
  const bool is_generated = !shift.image && !mask.image;
  if (strands && is_generated) {
    Image numbers = shift_mask_of(*strands, recipe.texture_seed);
    if (color.max_size) numbers = quarter_rows(numbers, TexelMeaning::kNumbers);
    return {mips_of_strands(std::move(numbers), hair.mesh, size_limit(color, recipe)), false};
  }
  const bool strands_along_u = hair.strands.along_u;
  const auto pointer = [](const RecipeImage& image) { return image.image ? &*image.image : nullptr; };
  Image whole = combine_shift_mask(pointer(shift), pointer(mask), recipe.texture_seed, strands_along_u);
  if (is_generated && recipe.shading == name_of(ShadingModel::kVolume)) calm(whole);
  const bool constant = is_constant(whole);
  if (color.atlas && !constant) {
    whole = draw_atlas(*color.atlas, std::vector<const Image*>(color.atlas->tiles.size(), &whole));
  }
  const std::uint32_t limit = texture_limit(recipe);
  if (is_generated) return {mips_of_strands(std::move(whole), hair.mesh, limit), constant};
  return {make_mips(std::move(whole), limit, TexelMeaning::kNumbers), constant};
}

/// If the texture is constant, the material stores the number: otherwise every pixel would read the texture for it.
void keep_constants(std::span<const Image> mips, TexelFormat format, BakedTextures& out, Findings& findings) {
  const Image& image = mips[0];
  out.constant_shift = image.texels[0] / 255.0;
  out.constant_mask = image.texels[1] / 255.0;
  const std::uint64_t bytes = sizeof(TextureRecord) + bytes_with_mips(format, image);
  findings.leave_out({"texture of shift and mask", "both are the same everywhere; the material says them", bytes});
}

}  // namespace

tl::expected<BakedTextures, ToolError> bake_textures(const BaseColor& color, const HairStrips& hair,
                                                     const DrawnRecipe& recipe, const CookSettings& settings,
                                                     Findings& findings) {
  BakedTextures baked;
  const auto shift = read_recipe_image(recipe.shift_texture, "shift", settings);
  const auto mask = read_recipe_image(recipe.mask_texture, "mask", settings);
  for (const auto* image : {&shift, &mask}) {
    if (!*image) return tl::unexpected(image->error());
    if ((*image)->image) baked.files.push_back((*image)->path);
  }
  const bool textured = color.image.has_value() && !hair.mesh.uvs.empty();
  if (!textured) baked.transparency = choose_transparency(color, nullptr, {}, recipe, findings);
  if (hair.mesh.uvs.empty()) {
    findings.leave_out({"textures", "the hair has no texture coordinates"});
    return baked;
  }
  BaseMips base;
  ShiftMask shift_mask;
  parallel_for(2, settings.threads, [&](std::size_t i) {
    if (i == 0 && textured) base = bake_base(color, hair.mesh, recipe, baked.transparency, findings);
    if (i == 1 && !color.is_of_vertex_colors) shift_mask = bake_shift_mask(color, *shift, *mask, hair, recipe);
  });
  const TexelFormat format = two_channel_format(recipe);
  if (textured) baked.stored.append(TextureRole::kBaseColor, TexelFormat::kSrgb8Alpha8, base.color, settings.threads);
  if (color.is_of_vertex_colors) {
    findings.leave_out({"texture of shift and mask", "the hair has no texture coordinates"});
  } else if (shift_mask.is_constant) {
    keep_constants(shift_mask.mips, format, baked, findings);
  } else {
    baked.stored.append(TextureRole::kShiftMask, format, shift_mask.mips, settings.threads);
  }
  const Image *const normals = color.normals ? &*color.normals : nullptr, *const strands =
                                                                              color.strands ? &*color.strands : nullptr;
  if (normals != nullptr || strands != nullptr) {
    std::optional<Image> rows_spared;
    if (strands != nullptr && color.max_size) rows_spared = quarter_rows(*strands, TexelMeaning::kNumbers);
    baked.relief = bake_relief(normals, rows_spared ? &*rows_spared : strands, hair.mesh,
                               {format, size_limit(color, recipe)}, settings.threads, findings);
  }
  baked.used = std::move(base.used);
  return baked;
}

tl::expected<RecipeImage, ToolError> read_recipe_image(const RecipeTexture& chosen, const char* key,
                                                       const CookSettings& settings) {
  auto read = read_recipe_image(chosen.file, key, settings);
  if (read && read->image) read->image = as_chosen(std::move(*read->image), chosen);
  return read;
}

tl::expected<RecipeImage, ToolError> read_recipe_image(const std::string& name, const char* key,
                                                       const CookSettings& settings) {
  if (name.empty()) return RecipeImage{};
  const std::filesystem::path path = settings.recipe_directory / name;
  auto image = read_image(path);
  if (image) return RecipeImage{std::move(*image), path};
  return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: recipe key \"textures.{}\": {}",
                                                                          path.string(), key, image.error())});
}

namespace {

// Fine across the strands, where each hair differs from the next; coarse along them.
constexpr std::uint32_t kAcross = 512;
constexpr std::uint32_t kAlong = 128;

/// A well-mixed 32-bit value for each lattice point; integer arithmetic, so equal on every machine. Shifts and odd
/// multipliers are those published for the lowbias32 mixer (Wellons, "hash-prospector").
std::uint32_t mix(std::uint32_t x) {
  x = (x ^ x >> 16) * 0x7FEB352Du;
  x = (x ^ x >> 15) * 0x846CA68Bu;
  return x ^ x >> 16;
}

double lattice(std::uint32_t seed, std::uint32_t x, std::uint32_t y) {
  return double(mix(seed ^ mix(x + 0x9E3779B9u * mix(y)))) / 4294967295.0;
}

/// Value noise on a lattice of `nx` by `ny` cells that repeats; x and y in 0..1.
double noise(std::uint32_t seed, double x, double y, std::uint32_t nx, std::uint32_t ny) {
  const auto ease = [](double t) { return t * t * (3 - 2 * t); };
  const double gx = x * nx, gy = y * ny;
  const auto ix = std::uint32_t(gx), iy = std::uint32_t(gy);
  const double fx = ease(gx - ix), fy = ease(gy - iy);
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return lattice(seed, (ix + i) % nx, (iy + j) % ny); };
  const double low = at(0, 0) + fx * (at(1, 0) - at(0, 0));
  const double high = at(0, 1) + fx * (at(1, 1) - at(0, 1));
  return low + fy * (high - low);
}

std::uint8_t to_byte(double value) { return std::uint8_t(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

}  // namespace

Image generate_shift_mask(std::uint32_t seed, bool along_u) {
  Image image{along_u ? kAlong : kAcross, along_u ? kAcross : kAlong, 2, {}};
  image.texels.resize(image.texel_count() * 2);
  for (std::uint32_t row = 0; row < image.height; ++row) {
    for (std::uint32_t column = 0; column < image.width; ++column) {
      const double u = (column + 0.5) / image.width, v = (row + 0.5) / image.height;
      const double across = along_u ? v : u, along = along_u ? u : v;
      // Single strands over thin locks over wide ones.
      const double shift = 0.5 * noise(seed, across, along, 320, 4) + 0.35 * noise(seed + 1, across, along, 96, 3) +
                           0.15 * noise(seed + 4, across, along, 24, 2);
      const double sparkle = noise(seed + 2, across, along, 320, 24) * noise(seed + 3, across, along, 64, 8);
      std::uint8_t* texel = &image.texels[2 * (std::size_t(row) * image.width + column)];
      texel[0] = to_byte(0.5 + 0.7 * (shift - 0.5));
      texel[1] = to_byte(0.15 + 1.4 * sparkle);
    }
  }
  return image;
}

Image shift_mask_of(const Image& strands, std::uint32_t seed) {
  Image image{strands.width, strands.height, 2, {}};
  image.texels.resize(2 * image.texel_count());
  for (std::size_t i = 0; i < image.texel_count(); ++i) {
    const double number = strands.texels[4 * i] / 255.0;
    const auto row = std::uint32_t(i / image.width);
    // Another number of the same strand, and bright and dull places along it.
    const double other = number * 7 - std::floor(number * 7), v = (row + 0.5) / image.height;
    image.texels[2 * i] = to_byte(0.5 + 0.7 * (number - 0.5));
    image.texels[2 * i + 1] = to_byte(0.2 + 0.8 * other * (0.5 + noise(seed + 2, other, v, 16, 64)));
  }
  return image;
}

Image combine_shift_mask(const Image* shift, const Image* mask, std::uint32_t seed, bool along_u) {
  const Image generated = generate_shift_mask(seed, along_u);
  Image combined{generated.width, generated.height, 2, {}};
  for (const Image* source : {shift, mask}) {
    if (source == nullptr) continue;
    combined.width = std::max(combined.width, source->width);
    combined.height = std::max(combined.height, source->height);
  }
  combined.texels.resize(combined.texel_count() * 2);
  for (std::uint32_t y = 0; y < combined.height; ++y) {
    for (std::uint32_t x = 0; x < combined.width; ++x) {
      // Nearest texel: both images and the generated one repeat over the same unit square.
      const auto pick = [&](const Image* image, std::uint32_t channel) {
        const Image& from = image != nullptr ? *image : generated;
        const std::size_t sx = std::size_t(x) * from.width / combined.width;
        const std::size_t sy = std::size_t(y) * from.height / combined.height;
        return from.texels[(sy * from.width + sx) * from.channels + (image != nullptr ? 0 : channel)];
      };
      std::uint8_t* texel = &combined.texels[2 * (std::size_t(y) * combined.width + x)];
      texel[0] = pick(shift, 0);
      texel[1] = pick(mask, 1);
    }
  }
  return combined;
}

}  // namespace coif::cook
