#include "cook/recipe/hair_preset.h"

#include <algorithm>
#include <iterator>

namespace coif {
namespace {

constexpr HairPreset kPresets[] = {{"natural", 0.08, 0.45, 1},
                                   {"stiff", 0.2, 0.5, 1},
                                   {"heavy", 0.05, 0.4, 0.5},
                                   {"bouncy", 0.1, 0.25, 0.5},
                                   {"wet", 0.05, 0.8, 1.5}};

}  // namespace

const HairPreset& preset_of(const Recipe& recipe) {
  const auto* const found = std::ranges::find(kPresets, recipe.dynamics_preset, &HairPreset::name);
  return found != std::end(kPresets) ? *found : kPresets[0];
}

}  // namespace coif
