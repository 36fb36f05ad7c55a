#pragma once

#include "cook/recipe/rig_recipe.h"

#include <span>

namespace coif::cook {

/// The values that "dynamics.preset" stands for.
struct HairPreset {
  const char* name;
  double bending_length;  ///< Metres.
  double damping_ratio;
  double friction;  ///< 1/s, against the air.
};

[[nodiscard]] std::span<const HairPreset> hair_presets();
[[nodiscard]] const HairPreset& preset_of(const RigRecipe& recipe);

}  // namespace coif::cook
