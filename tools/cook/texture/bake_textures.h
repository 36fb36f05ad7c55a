#pragma once

#include "base/tool_error.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/recipe_texture.h"
#include "cook/strands/hair_strips.h"
#include "cook/texture/base_color.h"
#include "cook/texture/image.h"
#include "cook/texture/relief.h"
#include "cook/texture/transparency.h"

namespace coif::cook {

struct DrawnRecipe;

struct RecipeImage {
  std::optional<Image> image;  ///< None where the recipe names none.
  std::filesystem::path path;
};

/// Reads the image that the recipe's "textures.KEY" names, with a path relative to the recipe's folder. If `chosen`
/// names a channel, that is copied to red, green and blue. Error (kBadInput): it cannot be read, though the artist
/// asked for it.
tl::expected<RecipeImage, ToolError> read_recipe_image(const RecipeTexture& chosen, const char* key,
                                                       const CookSettings& settings);
/// Reads an image that the recipe names by its path alone.
tl::expected<RecipeImage, ToolError> read_recipe_image(const std::string& name, const char* key,
                                                       const CookSettings& settings);

/// The two-channel texture of Algorithm 3, made from a seed: red moves both highlights from strand to strand around
/// 0.5, green breaks the secondary highlight into sparkles. It repeats in both directions. `along_u`: strands run along
/// U.
[[nodiscard]] Image generate_shift_mask(std::uint32_t seed, bool along_u);

/// The same for known strands (SourceMaterial::strand_texture): each has its own shift and its own sparkles.
[[nodiscard]] Image shift_mask_of(const Image& strands, std::uint32_t seed);

/// Red of `shift` and red of `mask` in one image of the larger size. Either may be null: its channel is generated.
[[nodiscard]] Image combine_shift_mask(const Image* shift, const Image* mask, std::uint32_t seed, bool along_u);

struct BakedTextures {
  StoredTextures stored;    ///< Base colour, shift and mask.
  StoredTextures relief;    ///< Normals and strands.
  std::vector<Image> used;  ///< For each mip of the base colour the texels that the hair shows, one channel.
  Transparency transparency;
  std::vector<std::filesystem::path> files;  ///< Image files of the recipe that were read here.
  double constant_shift = 0.5;  ///< The shift of all strands where no texture has one for each: 0.5 shifts nothing.
  double constant_mask = 1;
};

/// Bakes the base colour with alpha, and shift with mask (the recipe's, else generated), each with all mips, in the
/// formats of the recipe. Alpha is plainly averaged; keep_coverage() compensates for the loss at the threshold, once
/// that is known. In an atlas shift and mask follow each surface's own coordinates. An image of the recipe that cannot
/// be read is an error. Constant shift and mask are stored as numbers instead. Relief comes from the source's normal
/// map (bake_relief()). Without texture coordinates nothing is stored. `hair` has the coordinates from
/// find_base_color(), and its strands.
tl::expected<BakedTextures, ToolError> bake_textures(const BaseColor& color, const HairStrips& hair,
                                                     const DrawnRecipe& recipe, const CookSettings& settings,
                                                     Findings& findings);

}  // namespace coif::cook
