#include "cook/bake_textures.h"

#include "cook/alpha_mips.h"
#include "cook/image.h"
#include "cook/parallel_for.h"
#include "cook/shift_mask.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace coif {
namespace {

namespace fs = std::filesystem;

constexpr double kFewOpaqueTexels = 0.1;

using MaybeImage = std::optional<Image>;

tl::expected<MaybeImage, ToolError> read_recipe_image(const std::string& name, const char* key,
                                                      const CookSettings& settings) {
  if (name.empty()) return MaybeImage{};
  const fs::path path = settings.recipe_directory / name;
  auto image = read_image(path);
  if (image) return MaybeImage{std::move(*image)};
  return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: recipe key \"textures.{}\": {}",
                                                                          path.string(), key, image.error())});
}

/// An image that the source names by a path: only ever looked for in the source's own folder, under its last name, since
/// paths in files are those of the artist's machine and must not reach elsewhere on this one.
fs::path beside_source(const SourceModel& source, const std::string& written) {
  const std::size_t slash = written.find_last_of("/\\");
  return fs::path(source.path).parent_path() / (slash == std::string::npos ? written : written.substr(slash + 1));
}

MaybeImage read_source_image(const SourceModel& source, const HairMesh& hair, std::vector<std::string>& warnings) {
  if (hair.material >= source.materials.size()) return {};
  const SourceMaterial& material = source.materials[hair.material];
  const SourceTexture& texture = material.base_texture;
  tl::expected<Image, std::string> image;
  std::string name;
  if (texture.image < source.images.size()) {
    name = fmt::format("embedded image '{}'", source.images[texture.image].name);
    image = decode_image(source.images[texture.image].bytes);
  } else if (!texture.path.empty()) {
    const fs::path path = beside_source(source, texture.path);
    name = path.string();
    image = read_image(path);
    if (image && path.filename() != texture.path) {
      warnings.push_back(fmt::format("material '{}': texture '{}' taken from {}", material.name, texture.path, name));
    }
  } else {
    return {};
  }
  if (image) return std::move(*image);
  warnings.push_back(fmt::format("material '{}': {}: {}; the hair is cooked without a base texture", material.name,
                                 name, image.error()));
  return {};
}

void append(TextureRole role, TexelFormat format, std::span<const Image> mips, BakedTextures& out) {
  out.texels.resize((out.texels.size() + 63) / 64 * 64);
  TextureRecord record{};
  record.role = role;
  record.format = format;
  record.width = mips[0].width;
  record.height = mips[0].height;
  record.mip_count = std::uint32_t(mips.size());
  record.offset = out.texels.size();
  for (const Image& mip : mips) {
    const auto bytes = std::as_bytes(std::span(mip.texels));
    out.texels.insert(out.texels.end(), bytes.begin(), bytes.end());
  }
  record.bytes = out.texels.size() - record.offset;
  out.records.push_back(record);
}

void warn_of_alpha(const Image& base, const Recipe& recipe, std::vector<std::string>& warnings) {
  const double opaque = alpha_coverage(base, recipe.opaque_threshold);
  if (opaque >= kFewOpaqueTexels) return;
  warnings.push_back(
      fmt::format("only {:.1f} % of the base texture has alpha {} or more: without an opaque core hair "
                  "sorts badly; lower \"material.opaque_threshold\" or paint opaque cores",
                  100 * opaque, recipe.opaque_threshold));
}

std::vector<Image> base_mips(Image image, const Recipe& recipe) {
  std::vector<Image> mips = make_mips(std::move(image), recipe.texture_max_size, TexelMeaning::kSrgbColorAlpha);
  fill_color_under_alpha(mips);
  keep_alpha_coverage(mips, recipe.opaque_threshold);
  return mips;
}

}  // namespace

tl::expected<BakedTextures, ToolError> bake_textures(const SourceModel& source, const HairMesh& hair,
                                                     bool strands_along_u, const Recipe& recipe,
                                                     const CookSettings& settings) {
  BakedTextures baked;
  auto base = read_recipe_image(recipe.base_color_texture, "base_color", settings);
  auto shift = read_recipe_image(recipe.shift_texture, "shift", settings);
  auto mask = read_recipe_image(recipe.mask_texture, "mask", settings);
  for (const auto* image : {&base, &shift, &mask}) {
    if (!*image) return tl::unexpected(image->error());
  }
  if (hair.uvs.empty()) {
    baked.left_out.push_back("textures: the hair has no texture coordinates");
    return baked;
  }
  if (!*base) *base = read_source_image(source, hair, baked.warnings);

  std::vector<Image> mips[2];
  parallel_for(2, settings.threads, [&](std::size_t i) {
    if (i == 0 && *base) mips[0] = base_mips(std::move(**base), recipe);
    if (i == 1) {
      mips[1] = make_mips(combine_shift_mask(*shift ? &**shift : nullptr, *mask ? &**mask : nullptr,
                                             recipe.texture_seed, strands_along_u),
                          recipe.texture_max_size, TexelMeaning::kNumbers);
    }
  });
  if (!mips[0].empty()) {
    warn_of_alpha(mips[0][0], recipe, baked.warnings);
    append(TextureRole::kBaseColor, TexelFormat::kSrgb8Alpha8, mips[0], baked);
  }
  append(TextureRole::kShiftMask, TexelFormat::kRg8, mips[1], baked);
  return baked;
}

}  // namespace coif
