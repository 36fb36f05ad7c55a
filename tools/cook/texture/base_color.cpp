#include "cook/texture/base_color.h"

#include "cook/recipe/drawn_recipe.h"
#include "cook/texture/bake_textures.h"
#include "cook/texture/recipe_maps.h"
#include "cook/texture/source_images.h"
#include "cook/texture/vertex_colors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif::cook {
namespace {

constexpr int kMostScales = 64;  ///< Tried for an atlas; a limit on size below one gutter is never met.

/// None where the look has no map, or one that is no map of normals.
std::optional<Image> normals_of(const SurfaceLook& look, Findings& findings) {
  if (look.normals == nullptr || look.normal_use.strength <= 0) return std::nullopt;
  auto map = read_normal_map(*look.normals, look.normal_use);
  if (!map) {
    findings.warn("C149", fmt::format("material '{}': its normal map is not used: {}", look.name, map.error()));
    return std::nullopt;
  }
  findings.note(fmt::format("material '{}': lit by {}", look.name, map->found));
  return std::move(map->normals);
}

BaseColor whole(const SurfaceLook& look, Findings& findings) {
  BaseColor color;
  if (look.image != nullptr) color.image = *look.image;
  color.normals = normals_of(look, findings);
  if (look.strands != nullptr) color.strands = *look.strands;
  color.factor = look.factor;
  color.alpha_use = look.alpha_use;
  color.alpha_cutoff = look.alpha_cutoff;
  return color;
}

std::vector<ImageSize> sizes_at(std::span<const SurfaceLook> looks, double scale) {
  const auto scaled = [&](std::uint32_t texels) { return std::uint32_t(std::max(1.0, std::round(texels * scale))); };
  std::vector<ImageSize> sizes;
  for (const SurfaceLook& look : looks) {
    ImageSize size;
    for (std::size_t axis = 0; axis < 2; ++axis) size.clamped[axis] = look.wrap[axis] == importer::TextureWrap::kClamp;
    for (const Image* image : {look.image, look.normals, look.strands}) {
      if (image == nullptr) continue;
      size.width = std::max(size.width, scaled(image->width));
      size.height = std::max(size.height, scaled(image->height));
    }
    sizes.push_back(size);
  }
  return sizes;
}

/// Scales all images by one factor, so that their atlas fits `max_size`. Mips alone only halve, and a tile of full size
/// would lose half of its detail to its gutter.
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

/// No larger than that: draw_atlas() repeats texels where an image is smaller than its tile.
Image at_size(Image image, const ImageSize& size, TexelMeaning meaning) {
  const bool is_plain = size.width == 0;
  if (is_plain || (size.width >= image.width && size.height >= image.height)) return image;
  return shrink(image, std::min(size.width, image.width), std::min(size.height, image.height), meaning);
}

std::vector<const Image*> pointers_to(std::span<const Image> images) {
  std::vector<const Image*> pointers;
  for (const Image& image : images) pointers.push_back(&image);
  return pointers;
}

/// The looks' normals in one atlas; looks without a map are flat. None where no look has one.
std::optional<Image> joined_normals(std::span<const SurfaceLook> looks, const AtlasLayout& layout,
                                    std::span<const ImageSize> sizes, Findings& findings) {
  std::vector<Image> normals;
  bool is_any = false;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    std::optional<Image> map = normals_of(looks[i], findings);
    is_any = is_any || map;
    normals.push_back(map ? at_size(std::move(*map), sizes[i], TexelMeaning::kNumbers)
                          : Image{1, 1, 2, {two_sided_byte(0), two_sided_byte(0)}});
  }
  if (!is_any) return std::nullopt;
  return draw_atlas(layout, pointers_to(normals));
}

/// The same for known strands; elsewhere strands are average ones of unknown direction.
std::optional<Image> joined_strands(std::span<const SurfaceLook> looks, const AtlasLayout& layout,
                                    std::span<const ImageSize> sizes) {
  std::vector<Image> strands;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    strands.push_back(looks[i].strands != nullptr ? at_size(*looks[i].strands, sizes[i], TexelMeaning::kNumbers)
                                                  : Image{1, 1, 4, {128, 0, two_sided_byte(0), two_sided_byte(0)}});
  }
  const bool is_any = std::ranges::any_of(looks, [](const SurfaceLook& look) { return look.strands != nullptr; });
  return is_any ? std::optional(draw_atlas(layout, pointers_to(strands))) : std::nullopt;
}

/// A part of the hair whose texture is lost gets the looks of the rest, not those of paper.
void color_like_the_rest(SurfaceLooks& looks, Findings& findings) {
  const SurfaceLook* known = looks.looks[looks.main].image != nullptr ? &looks.looks[looks.main] : nullptr;
  for (const SurfaceLook& look : looks.looks) known = known == nullptr && look.image != nullptr ? &look : known;
  if (known == nullptr) return;
  for (SurfaceLook& look : looks.looks) {
    if (!look.lacks_image) continue;
    look.factor.head<3>() = mean_color(*known);
    findings.note(
        fmt::format("material '{}': without its texture it has the mean colour of '{}'", look.name, known->name));
  }
}

tl::expected<BaseColor, std::string> joined(SurfaceLooks& looks, std::uint32_t max_size, HairMesh& hair,
                                            Findings& findings) {
  if (hair.uvs.empty()) return tl::unexpected(std::string("no texture coordinates"));
  color_like_the_rest(looks, findings);
  std::vector<ImageSize> sizes;
  const auto layout = lay_out(looks, hair, max_size, sizes);
  if (!layout) return tl::unexpected(layout.error());
  const JointAlpha alpha = join_alpha(looks.looks);
  std::vector<Image> painted;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    painted.push_back(at_size(paint(looks.looks[i], alpha), sizes[i], TexelMeaning::kSrgbColorAlpha));
  }
  BaseColor color;
  color.image = draw_atlas(*layout, pointers_to(painted));
  color.normals = joined_normals(looks.looks, *layout, sizes, findings);
  color.strands = joined_strands(looks.looks, *layout, sizes);
  color.alpha_use = alpha.use;
  color.alpha_cutoff = alpha.cutoff;
  color.atlas = *layout;
  move_uvs_to_atlas(*layout, looks.of_triangle, hair);
  const std::string who = looks.looks.size() == 1 ? "one surface has a clamped texture and fills"
                                                  : fmt::format("{} surfaces share", looks.looks.size());
  findings.note(fmt::format("{} an atlas of {} x {} texels", who, layout->width, layout->height));
  return color;
}

std::optional<GreenAxis> green_of(const DrawnRecipe& recipe) {
  if (recipe.normal_green == NormalGreen::kAuto) return std::nullopt;
  return recipe.normal_green == NormalGreen::kUp ? GreenAxis::kUp : GreenAxis::kDown;
}

/// The looks that the materials describe.
SurfaceLooks looks_of_materials(const importer::SourceModel& source, SourceImages& images, const HairMesh& hair,
                                const DrawnRecipe& recipe) {
  const bool are_replaced = !recipe.normal_texture.empty() || recipe.normal_strength <= 0;
  SurfaceLooks looks = find_looks(source, images, hair, {!are_replaced, recipe.opacity_texture.empty()});
  for (SurfaceLook& look : looks.looks) {
    look.normal_use.strength *= recipe.normal_strength;
    if (const auto green = green_of(recipe)) look.normal_use.green = green;
  }
  return looks;
}

/// The image that the recipe names, on all of the hair.
SurfaceLooks looks_of_image(const importer::SourceModel& source, const HairMesh& hair, Image image) {
  SurfaceLooks looks;
  SurfaceLook look;
  look.image = &looks.made.emplace_back(std::move(image));
  if (hair.material < source.materials.size()) look.factor = color_factor(source.materials[hair.material]);
  looks.looks.push_back(look);
  looks.of_triangle.assign(hair.triangle_count(), 0);
  return looks;
}

/// Joins all looks in one image.
BaseColor in_one_image(SurfaceLooks& looks, const DrawnRecipe& recipe, HairMesh& hair, Findings& findings) {
  const bool is_clamped =
      std::ranges::find(looks.looks[0].wrap, importer::TextureWrap::kClamp) != std::end(looks.looks[0].wrap);
  if (looks.looks.size() == 1 && !(is_clamped && looks.looks[0].image != nullptr && !hair.uvs.empty())) {
    return whole(looks.looks[0], findings);
  }
  auto atlas = joined(looks, texture_limit(recipe), hair, findings);
  if (atlas) return *atlas;
  const SurfaceLook& main = looks.looks[looks.main];
  findings.warn(
      "C150", fmt::format("the hair has {} materials that look different, which cannot be joined ({}); all of it gets "
                          "that with most triangles ('{}')",
                          looks.looks.size(), atlas.error(), main.name));
  return whole(main, findings);
}

BaseColor color_of(SurfaceLooks& looks, const DrawnRecipe& recipe, HairMesh& hair, Findings& findings) {
  settle_wraps(looks, hair, findings);
  split_by_vertex_colors(looks, hair, texture_limit(recipe), findings);
  return in_one_image(looks, recipe, hair, findings);
}

/// White or grey without an image: the importers' values where the exporter wrote nothing.
bool is_colourless(const BaseColor& color) {
  const Eigen::Vector3f rgb = color.factor.head<3>();
  return !color.image && rgb.maxCoeff() - rgb.minCoeff() < 0.05f * rgb.maxCoeff() && rgb.minCoeff() > 0.1f;
}

bool names_color(const DrawnRecipe& recipe) {
  return std::ranges::any_of(std::span(recipe.base_color).first<3>(), [](double c) { return c != 1; });
}

/// Gives hair without a colour a hair colour, so that it does not look like paper.
void dye(BaseColor& color, Findings& findings) {
  color.factor.head<3>() = Eigen::Vector3f(0.13f, 0.07f, 0.035f);  // linear, a middle brown
  findings.note(
      "neither a texture nor a colour was found for the hair: it is brown; set \"textures.base_color\" or "
      "\"material.base_color\"");
}

/// The recipe's map instead of the source's.
tl::expected<void, ToolError> take_own_normals(const DrawnRecipe& recipe, const CookSettings& settings,
                                               BaseColor& color, Findings& findings) {
  auto own = read_recipe_image(recipe.normal_texture, "normal", settings);
  if (!own) return tl::unexpected(own.error());
  if (!own->image) return {};
  color.recipe_files.push_back(own->path);
  if (recipe.normal_strength <= 0) return {};
  auto map = read_normal_map(*own->image, {green_of(recipe), recipe.normal_strength});
  if (!map) {
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: recipe key \"textures.normal\": {}",
                                                                            own->path.string(), map.error())});
  }
  findings.note(fmt::format("lit by '{}', {}", recipe.normal_texture, map->found));
  color.normals = std::move(map->normals);
  if (color.atlas) {
    color.normals = draw_atlas(*color.atlas, std::vector<const Image*>(color.atlas->tiles.size(), &*color.normals));
  }
  return {};
}

}  // namespace

tl::expected<BaseColor, ToolError> find_base_color(const importer::SourceModel& source, HairMesh& hair,
                                                   const DrawnRecipe& recipe, const CookSettings& settings,
                                                   Findings& findings) {
  auto own = read_recipe_image(recipe.base_color_texture, "base_color", settings);
  if (!own) return tl::unexpected(own.error());
  auto maps = read_recipe_maps(recipe, settings);
  if (!maps) return tl::unexpected(maps.error());
  judge_vertex_colors(recipe, hair, findings);
  BaseColor color;
  SourceImages images(source);
  const bool has_own = own->image.has_value();
  SurfaceLooks looks =
      has_own ? looks_of_image(source, hair, std::move(*own->image)) : looks_of_materials(source, images, hair, recipe);
  take_opacity(*maps, looks, findings);
  color = color_of(looks, recipe, hair, findings);
  if (has_own) {
    color.recipe_files = {own->path};
  } else {
    const bool is_dyed =
        is_colourless(color) && hair.colors.empty() && !says_what_it_lacks(source) && !names_color(recipe);
    if (is_dyed) dye(color, findings);
    findings.append(images.findings());
    color.files = images.files();
    color.questions = images.questions();
  }
  place_maps(std::move(*maps), color);
  // Cards' texture has the right size, unless the recipe says otherwise.
  if (source.made_from_strands && !has_own && color.image && !recipe.texture_max_size) {
    color.max_size = std::max({texture_limit(recipe), color.image->width, color.image->height});
  }
  if (auto taken = take_own_normals(recipe, settings, color, findings); !taken) return tl::unexpected(taken.error());
  return color;
}

}  // namespace coif::cook
