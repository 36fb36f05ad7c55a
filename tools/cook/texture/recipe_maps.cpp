#include "cook/texture/recipe_maps.h"

#include "cook/recipe/drawn_recipe.h"
#include "cook/texture/bake_textures.h"

#include <map>

namespace coif::cook {
namespace {

tl::expected<std::optional<Image>, ToolError> read_map(const RecipeTexture& chosen, const char* key,
                                                       const CookSettings& settings,
                                                       std::vector<std::filesystem::path>& files) {
  auto read = read_recipe_image(chosen.file, key, settings);
  if (!read) return tl::unexpected(read.error());
  if (!read->image) return std::nullopt;
  files.push_back(read->path);
  return channel_of(*read->image, chosen.channel, chosen.is_inverted);
}

/// The map, with each surface's part at its place in the atlas.
Image in_atlas(Image map, const std::optional<AtlasLayout>& atlas) {
  if (!atlas) return map;
  return draw_atlas(*atlas, std::vector<const Image*>(atlas->tiles.size(), &map));
}

/// In the form that shift_mask_of() reads: the strand's number in red.
Image as_strand_texture(const Image& numbers) {
  Image image{numbers.width, numbers.height, 4, {}};
  image.texels.reserve(4 * numbers.texels.size());
  for (const std::uint8_t number : numbers.texels) image.texels.insert(image.texels.end(), {number, 0, 0, 0});
  return image;
}

}  // namespace

tl::expected<RecipeMaps, ToolError> read_recipe_maps(const DrawnRecipe& recipe, const CookSettings& settings) {
  RecipeMaps maps;
  const auto keep = [&](const RecipeTexture& chosen, const char* key,
                        std::optional<Image>& map) -> tl::expected<void, ToolError> {
    auto read = read_map(chosen, key, settings, maps.files);
    if (!read) return tl::unexpected(read.error());
    map = std::move(*read);
    return {};
  };
  auto done = keep(recipe.opacity_texture, "opacity", maps.opacity);
  if (done) done = keep(recipe.strand_id_texture, "strand_id", maps.strand_id);
  if (done) done = keep(recipe.root_to_tip_texture, "root_to_tip", maps.root_to_tip);
  if (!done) return tl::unexpected(done.error());
  return maps;
}

void take_opacity(const RecipeMaps& maps, SurfaceLooks& looks, Findings& findings) {
  if (!maps.opacity) return;
  std::map<const Image*, const Image*> joined;  // looked up only; its order reaches no output
  for (SurfaceLook& look : looks.looks) {
    const Image*& with_map = joined[look.image];
    if (with_map == nullptr) with_map = &looks.made.emplace_back(with_alpha(look.image, *maps.opacity));
    look.image = with_map;
    if (look.alpha_use == importer::AlphaUse::kOpaque) look.alpha_use = importer::AlphaUse::kBlend;
  }
  findings.note("alpha is the recipe's \"textures.opacity\"");
}

void place_maps(RecipeMaps maps, BaseColor& color) {
  if (maps.strand_id) color.strand_ids = in_atlas(as_strand_texture(*maps.strand_id), color.atlas);
  if (maps.root_to_tip) color.root_to_tip = in_atlas(std::move(*maps.root_to_tip), color.atlas);
  color.recipe_files.insert(color.recipe_files.end(), maps.files.begin(), maps.files.end());
}

}  // namespace coif::cook
