#pragma once
// The shading models that there are, one row each: what reads a material asks this table instead of naming them.

#include <coif/appearance_records.h>

#include <cstdint>

namespace coif {

/// What a shading model takes of a material.
struct ShadingTraits {
  const char* name;  ///< As recipes and the command line call it.
  bool has_primary;  ///< Highlights that it has at all.
  bool has_secondary;
  bool has_colored_highlights;  ///< Colours and exponents are the material's, and a black highlight is none.
  bool has_fiber;               ///< Takes tilt, roughness and scatter.
};

/// In the order of ShadingModel.
inline constexpr ShadingTraits kShadingModels[] = {
    //               primary  secondary  coloured  fibre
    {"thesis", true, true, true, false},
    {"kajiya-kay", true, false, true, false},
    {"marschner", true, true, false, true},
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
