#pragma once

#include "base/tool_error.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/recipe_texture.h"
#include "cook/texture/base_color.h"
#include "cook/texture/image.h"

namespace coif::cook {

struct DrawnRecipe;

/// The recipe's maps of single numbers besides the base colour, one channel each: opacity, and the data about strands
/// in packed atlases of hair cards.
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

/// Resolves kAuto for an RGBA image: alpha if any of it is not opaque, else the luminance.
[[nodiscard]] TextureChannel channel_in(const Image& image, TextureChannel channel);

/// One channel of an RGBA image as an image of one channel; luminance with the weights of BT.709, applied to the
/// encoded numbers.
[[nodiscard]] Image channel_of(const Image& image, TextureChannel channel, bool is_inverted);

/// `base` with the one-channel image as its alpha, at the larger of both sizes; white where `base` is null.
[[nodiscard]] Image with_alpha(const Image* base, const Image& alpha);

/// The recipe's image with its options applied: the named channel in grey, or inverted.
[[nodiscard]] Image as_chosen(Image image, const RecipeTexture& chosen);

}  // namespace coif::cook
