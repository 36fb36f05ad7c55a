#include "cook/texture/base_color.h"

#include "cook/texture/bake_textures.h"
#include "cook/texture/source_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

constexpr int kMostScales = 64;  ///< Tried for an atlas; a limit on size below one gutter is never met.

BaseColor whole(const SurfaceLook& look) {
  BaseColor color;
  if (look.image != nullptr) color.image = *look.image;
  if (look.normals != nullptr) color.normals = *look.normals;
  color.factor = look.factor;
  color.alpha_use = look.alpha_use;
  color.alpha_cutoff = look.alpha_cutoff;
  return color;
}

std::vector<ImageSize> sizes_at(std::span<const SurfaceLook> looks, double scale) {
  const auto scaled = [&](std::uint32_t texels) { return std::uint32_t(std::max(1.0, std::round(texels * scale))); };
  std::vector<ImageSize> sizes;
  for (const SurfaceLook& look : looks) {
    sizes.push_back(look.image != nullptr ? ImageSize{scaled(look.image->width), scaled(look.image->height)}
                                          : ImageSize{});
  }
  return sizes;
}

/// All images at the one scale at which their atlas fits `max_size`. Left to the mips, which only halve, a tile of full
/// size would lose half of its detail to the gutter around it.
tl::expected<AtlasLayout, std::string> lay_out(const SurfaceLooks& looks, const HairMesh& hair, std::uint32_t max_size,
                                               std::vector<ImageSize>& sizes) {
  double largest = max_size;
  for (const ImageSize& size : sizes_at(looks.looks, 1))
    largest = std::max<double>(largest, std::max(size.width, size.height));
  double scale = max_size / largest;
  for (int attempt = 0;; ++attempt) {
    sizes = sizes_at(looks.looks, scale);
    auto layout = lay_out_atlas(hair, looks.of_triangle, sizes);
    if (!layout) return layout;
    const std::uint32_t side = std::max(layout->width, layout->height);
    if (side <= max_size || attempt == kMostScales) return layout;
    // Gutters and plain tiles keep their size, so the first step may fall short.
    scale *= std::min(0.98, double(max_size) / side);
  }
}

Image at_size(Image image, const ImageSize& size) {
  const bool as_is = size.width == 0 || (size.width == image.width && size.height == image.height);
  return as_is ? image : shrink(image, size.width, size.height, TexelMeaning::kSrgbColorAlpha);
}

tl::expected<BaseColor, std::string> joined(const SurfaceLooks& looks, std::uint32_t max_size, HairMesh& hair,
                                            Findings& findings) {
  if (hair.uvs.empty()) return tl::unexpected(std::string("no texture coordinates"));
  std::vector<ImageSize> sizes;
  const auto layout = lay_out(looks, hair, max_size, sizes);
  if (!layout) return tl::unexpected(layout.error());
  const JointAlpha alpha = join_alpha(looks.looks);
  std::vector<Image> painted;
  for (std::size_t i = 0; i < sizes.size(); ++i) painted.push_back(at_size(paint(looks.looks[i], alpha), sizes[i]));
  std::vector<const Image*> tiles;
  for (const Image& image : painted) tiles.push_back(&image);
  BaseColor color;
  color.image = draw_atlas(*layout, tiles);
  color.alpha_use = alpha.use;
  color.alpha_cutoff = alpha.cutoff;
  color.atlas = *layout;
  move_uvs_to_atlas(*layout, looks.of_triangle, hair);
  findings.note(
      fmt::format("{} surfaces share an atlas of {} x {} texels", looks.looks.size(), layout->width, layout->height));
  return color;
}

BaseColor from_materials(const SourceModel& source, SourceImages& images, std::uint32_t max_size, HairMesh& hair,
                         Findings& findings) {
  const SurfaceLooks looks = find_looks(source, images, hair);
  if (looks.looks.size() == 1) return whole(looks.looks[0]);
  auto atlas = joined(looks, max_size, hair, findings);
  if (atlas) return *atlas;
  const SurfaceLook& main = looks.looks[looks.main];
  findings.warn(
      fmt::format("the hair has {} materials that look different, and {} cannot be joined; all of it gets "
                  "that with most triangles ('{}')",
                  looks.looks.size(), atlas.error(), main.name));
  return whole(main);
}

/// White or grey without an image: what importers put where the exporter said nothing.
bool is_colourless(const BaseColor& color) {
  const Eigen::Vector3f rgb = color.factor.head<3>();
  return !color.image && rgb.maxCoeff() - rgb.minCoeff() < 0.05f * rgb.maxCoeff() && rgb.minCoeff() > 0.1f;
}

/// Hair that says nothing of its colour is shown as hair rather than as paper.
void dye(BaseColor& color, Findings& findings) {
  color.factor.head<3>() = Eigen::Vector3f(0.13f, 0.07f, 0.035f);  // linear, a middle brown
  findings.note(
      "neither a texture nor a colour was found for the hair: it is brown; set \"textures.base_color\" or "
      "\"material.base_color\", which multiplies it");
}

}  // namespace

tl::expected<BaseColor, ToolError> find_base_color(const SourceModel& source, HairMesh& hair, const Recipe& recipe,
                                                   const CookSettings& settings, Findings& findings) {
  auto own = read_recipe_image(recipe.base_color_texture, "base_color", settings);
  if (!own) return tl::unexpected(own.error());
  if (own->image) {
    BaseColor color;
    if (hair.material < source.materials.size()) color.factor = color_factor(source.materials[hair.material]);
    color.image = std::move(own->image);
    color.files = {own->path};
    return color;
  }
  SourceImages images(source);
  BaseColor color = from_materials(source, images, recipe.texture_max_size, hair, findings);
  if (is_colourless(color) && !says_what_it_lacks(source)) dye(color, findings);
  findings.append(images.findings());
  color.files = images.files();
  color.questions = images.questions();
  return color;
}

}  // namespace coif
