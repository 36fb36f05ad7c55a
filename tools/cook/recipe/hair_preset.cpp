#include "cook/recipe/hair_preset.h"

#include <algorithm>
#include <iterator>

namespace coif {
namespace {

constexpr HairPreset kPresets[] = {{"natural", 0.08, 0.45, 2.2},
                                   {"stiff", 0.2, 0.5, 2.2},
                                   {"heavy", 0.05, 0.4, 1.5},
                                   {"bouncy", 0.1, 0.25, 1},
                                   {"wet", 0.05, 0.8, 3}};

}  // namespace

std::span<const HairPreset> hair_presets() { return kPresets; }

const HairPreset& preset_of(const Recipe& recipe) {
  const auto* const found = std::ranges::find(kPresets, recipe.dynamics_preset, &HairPreset::name);
  return found != std::end(kPresets) ? *found : kPresets[0];
}

}  // namespace coif
