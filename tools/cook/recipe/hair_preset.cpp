#include "cook/recipe/hair_preset.h"

#include <algorithm>
#include <iterator>

namespace coif::cook {
namespace {

constexpr HairPreset kPresets[] = {{"natural", 0.08, 0.45, 2.2},
                                   {"stiff", 0.2, 0.5, 2.2},
                                   {"heavy", 0.05, 0.4, 1.5},
                                   {"bouncy", 0.1, 0.25, 1},
                                   {"wet", 0.05, 0.8, 3}};

}  // namespace

std::span<const HairPreset> hair_presets() { return kPresets; }

const HairPreset& preset_of(const RigRecipe& recipe) {
  const auto is_meant = [&](const HairPreset& preset) { return recipe.dynamics_preset == preset.name; };
  const auto* const found = std::find_if(std::begin(kPresets), std::end(kPresets), is_meant);
  return found != std::end(kPresets) ? *found : kPresets[0];
}

}  // namespace coif::cook
