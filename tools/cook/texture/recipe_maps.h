#pragma once

#include "base/tool_error.h"
#include "cook/recipe/cook_settings.h"
#include "cook/texture/base_color.h"

namespace coif::cook {

struct DrawnRecipe;

/// The maps of one number that the recipe names beside the base colour, one channel each: opacity, and what packed
/// atlases of hair cards know of strands.
struct RecipeMaps {
  std::optional<Image> opacity, strand_id, root_to_tip;
  std::vector<std::filesystem::path> files;
};

/// Error (kBadInput): one of them cannot be read.
tl::expected<RecipeMaps, ToolError> read_recipe_maps(const DrawnRecipe& recipe, const CookSettings& settings);

/// Gives every look the recipe's opacity as its alpha, at the coordinates of its own image.
void take_opacity(const RecipeMaps& maps, SurfaceLooks& looks, Findings& findings);

/// Hands the maps of strands on in the coordinates of the cooked image.
void place_maps(RecipeMaps maps, BaseColor& color);

}  // namespace coif::cook
