#pragma once
// One row for each shading model. Code that reads a material asks this table instead of naming models.

#include <coif/appearance_records.h>

#include <cstdint>

namespace coif {

/// Which values of a material a shading model uses.
struct ShadingTraits {
  const char* name;  ///< The name in recipes and on the command line.
  bool has_primary;  ///< Which highlights it can have.
  bool has_secondary;
  bool has_colored_highlights;  ///< Uses the material's colours and exponents; a black highlight is off.
  bool has_fiber;               ///< Uses tilt, roughness and scatter.
};

/// In the order of ShadingModel.
inline constexpr ShadingTraits kShadingModels[] = {
    //               primary  secondary  coloured  fibre
    {"thesis", true, true, true, false},
    {"kajiya-kay", true, false, true, false},
    {"marschner", true, true, false, true},
    {"volume", true, true, false, true},
};
inline constexpr std::uint32_t kShadingModelCount = sizeof kShadingModels / sizeof kShadingModels[0];

/// A known model whose numbers are in their ranges.
constexpr bool is_shading_valid(const MaterialRecord& m) {
  const auto within = [](float value, float least, float most) { return value >= least && value <= most; };
  const auto model = static_cast<std::uint32_t>(m.shading);
  if (model >= kShadingModelCount) return false;
  const float least_roughness = kShadingModels[model].has_fiber ? kLeastRoughness : 0.0f;
  return within(m.tilt, -kMostTilt, kMostTilt) && within(m.roughness, least_roughness, kMostRoughness) &&
         within(m.scatter, 0.0f, 1.0f) && within(m.light_cut, 0.0f, 1.0f) && within(m.glow, 0.0f, kMostGlow) &&
         within(m.root_shade, 0.0f, 1.0f) && within(m.variation, 0.0f, 1.0f);
}

}  // namespace coif
