#include "cook/base_color.h"

#include "cook/recipe_image.h"
#include "cook/source_images.h"
#include "cook/surface_looks.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif {
namespace {

BaseColor whole(const SurfaceLook& look) {
  BaseColor color;
  if (look.image != nullptr) color.image = *look.image;
  color.factor = look.factor;
  color.alpha_use = look.alpha_use;
  color.alpha_cutoff = look.alpha_cutoff;
  return color;
}

tl::expected<BaseColor, std::string> joined(const SurfaceLooks& looks, HairMesh& hair) {
  if (hair.uvs.empty()) return tl::unexpected(std::string("no texture coordinates"));
  std::vector<ImageSize> sizes;
  for (const SurfaceLook& look : looks.looks) {
    sizes.push_back(look.image != nullptr ? ImageSize{look.image->width, look.image->height} : ImageSize{});
  }
  const auto layout = lay_out_atlas(hair, looks.of_triangle, sizes);
  if (!layout) return tl::unexpected(layout.error());
  const JointAlpha alpha = join_alpha(looks.looks);
  std::vector<Image> painted;
  for (const SurfaceLook& look : looks.looks) painted.push_back(paint(look, alpha));
  std::vector<const Image*> tiles;
  for (const Image& image : painted) tiles.push_back(&image);
  BaseColor color;
  color.image = draw_atlas(*layout, tiles);
  color.alpha_use = alpha.use;
  color.alpha_cutoff = alpha.cutoff;
  color.atlas = *layout;
  move_uvs_to_atlas(*layout, looks.of_triangle, hair);
  color.notes.push_back(
      fmt::format("{} surfaces share an atlas of {} x {} texels", looks.looks.size(), layout->width, layout->height));
  return color;
}

BaseColor from_materials(const SourceModel& source, SourceImages& images, HairMesh& hair) {
  const SurfaceLooks looks = find_looks(source, images, hair);
  if (looks.looks.size() == 1) return whole(looks.looks[0]);
  auto atlas = joined(looks, hair);
  if (atlas) return *atlas;
  const SurfaceLook& main = looks.looks[looks.main];
  BaseColor color = whole(main);
  color.warnings.push_back(
      fmt::format("the hair has {} materials that look different, and {} cannot be joined; all of it gets "
                  "that with most triangles ('{}')",
                  looks.looks.size(), atlas.error(), main.name));
  return color;
}

/// White or grey without an image: what importers put where the exporter said nothing.
bool is_colourless(const BaseColor& color) {
  const Eigen::Vector3f rgb = color.factor.head<3>();
  return !color.image && rgb.maxCoeff() - rgb.minCoeff() < 0.05f * rgb.maxCoeff() && rgb.minCoeff() > 0.1f;
}

/// Hair that says nothing of its colour is shown as hair rather than as paper.
void dye(BaseColor& color) {
  color.factor.head<3>() = Eigen::Vector3f(0.13f, 0.07f, 0.035f);  // linear, a middle brown
  color.notes.emplace_back(
      "neither a texture nor a colour was found for the hair: it is brown; set \"textures.base_color\" or "
      "\"material.base_color\", which multiplies it");
}

void append(auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); }

}  // namespace

tl::expected<BaseColor, ToolError> find_base_color(const SourceModel& source, HairMesh& hair, const Recipe& recipe,
                                                   const CookSettings& settings) {
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
  BaseColor color = from_materials(source, images, hair);
  if (is_colourless(color) && !says_what_it_lacks(source)) dye(color);
  append(color.warnings, images.warnings());
  append(color.notes, images.notes());
  append(color.files, images.files());
  return color;
}

}  // namespace coif
