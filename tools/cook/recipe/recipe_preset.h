#pragma once

#include <span>

namespace coif::cook {

/// A recipe for a kind of hair, from which an artist's own begins.
struct RecipePreset {
  const char* name;
  const char* meaning;  ///< One line, for people.
  const char* keys;     ///< JSON of a recipe: differences from the defaults.
};

/// Every preset that "look.preset" may name, except "none".
[[nodiscard]] std::span<const RecipePreset> recipe_presets();

/// The choices of "look.preset": "none" and the presets' names.
inline constexpr const char* kPresetWords = "none|realistic|anime|stylised|ponytail|curly|short";

}  // namespace coif::cook
