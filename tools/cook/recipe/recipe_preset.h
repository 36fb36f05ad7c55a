#pragma once

#include <span>

namespace coif::cook {

/// A recipe for a kind of hair, from which an artist's own begins.
struct RecipePreset {
  const char* name;
  const char* meaning;  ///< One line, for people.
  const char* keys;     ///< JSON of a recipe: what differs from the defaults.
};

/// Every preset that "look.preset" may name, but for "none".
[[nodiscard]] std::span<const RecipePreset> recipe_presets();

/// What "look.preset" may be: "none" and their names.
inline constexpr const char* kPresetWords = "none|realistic|anime|stylised|ponytail|curly|short";

}  // namespace coif::cook
