#pragma once

#include "cook/recipe/recipe_texture.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace coif::cook {

enum class OrderMethod { kAuto, kHead, kSingle, kViews };
enum class VertexColors { kAuto, kMultiply, kIgnore };
enum class NormalGreen { kAuto, kUp, kDown };
enum class ShiftMaskFormat { kEac, kRg8 };
enum class ColorFormat { kAuto, kEtc2, kRgba8 };
enum class Sides { kAuto, kBoth, kFront };
enum class ShadingEnergy { kPublished, kBounded };

/// The recipe's values for the look of hair: levels of detail, draw orders, textures and material.
struct DrawnRecipe {
  double scene_largest_size = 0;   ///< Share of the viewport's height; 0: any.
  double scene_smallest_size = 0;  ///< As scene_largest_size.
  std::uint32_t lod_levels = 0;
  double lod_ratio = 0;
  double lod_max_error = 0;
  double lod_pixel_error = 0;
  double lod_still_pixels = 0;

  OrderMethod order_method = OrderMethod::kAuto;
  std::uint32_t order_max = 0;
  std::uint32_t order_max_bytes = 0;
  double order_min_gain = 0;    ///< dB.
  double order_cut_budget = 0;  ///< Share of the triangles.
  std::string order_solver;     ///< "coif", "cascade", "passive" or "thesis".
  double occlusion_strength = 0;

  RecipeTexture base_color_texture;  ///< None: the source's.
  RecipeTexture opacity_texture;     ///< None: the source's.
  RecipeTexture shift_texture;
  RecipeTexture mask_texture;
  RecipeTexture strand_id_texture;
  RecipeTexture root_to_tip_texture;
  VertexColors vertex_colors = VertexColors::kAuto;
  std::string normal_texture;  ///< Path relative to the recipe; "": the source's texture.
  double normal_strength = 0;
  NormalGreen normal_green = NormalGreen::kAuto;
  /// None: texture_limit(); textures of cards are as large as "cards.texels" says.
  std::optional<std::uint32_t> texture_max_size;
  std::uint32_t texture_seed = 0;
  ShiftMaskFormat shift_mask_format = ShiftMaskFormat::kEac;
  ColorFormat color_format = ColorFormat::kAuto;

  std::array<double, 4> base_color{};
  std::array<double, 3> ambient{};
  Sides sides = Sides::kAuto;
  double opaque_threshold = 0;  ///< 0: chosen from the file and the texture.
  double discard_threshold = 0;
  std::array<double, 3> primary_color{};
  double primary_exponent = 0;
  double primary_shift = 0;
  std::array<double, 3> secondary_color{};
  double secondary_exponent = 0;
  double secondary_shift = 0;
  std::string shading;              ///< A shading model's name.
  double tilt = 0;                  ///< Degrees.
  std::optional<double> roughness;  ///< Degrees; none: as the model wants it.
  double scatter = 0;
  double glow = 0;
  double root_shade = 0;
  double variation = 0;
  ShadingEnergy energy = ShadingEnergy::kPublished;
};

/// Texels that images may have each way; larger ones are reduced.
[[nodiscard]] inline std::uint32_t texture_limit(const DrawnRecipe& recipe) {
  return recipe.texture_max_size.value_or(1024);
}

}  // namespace coif::cook
