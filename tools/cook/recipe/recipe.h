#pragma once

// The artist's settings of a cook. recipe_keys.cpp has the one table of keys, defaults and ranges.

#include "base/tool_error.h"
#include "cook/recipe/cards_recipe.h"
#include "cook/recipe/drawn_recipe.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/recipe/hair_style.h"
#include "cook/recipe/rig_recipe.h"
#include "cook/recipe/scene_recipe.h"
#include "cook/recipe/source_recipe.h"
#include "cook/recipe/strip_recipe.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coif::cook {

/// All values of a recipe. Each stage of a cook sees only its own base class. Defaults and ranges are in the table of
/// recipe_keys.cpp: start from default_recipe().
struct Recipe : HairStyle, SceneRecipe, SourceRecipe, CardsRecipe, HairRecipe, StripRecipe, RigRecipe, DrawnRecipe {
  std::string look_preset;                         ///< "none", or the preset that the values started from.
  std::vector<std::string> acknowledged_warnings;  ///< Codes of the table of issues.
};

/// The recipe of a quick cook for looks and motion: one level of detail, drawn by distance from the head, small
/// uncompressed textures, no occlusion, cards fitted once.
[[nodiscard]] Recipe draft_of(Recipe recipe);

/// Every key at its default.
[[nodiscard]] Recipe default_recipe();

/// Presets that override those of the recipe. Empty: the recipe's own.
struct RecipeBeginning {
  std::string preset;  ///< Overrides "look.preset".
  std::string style;   ///< Overrides "grow.style".
};

/// Reads JSON (with // comments). Unknown keys, wrong types and values out of range are errors that name the key, the
/// range and, for a misspelt key, the nearest one. The values of a preset ("look.preset", recipe_presets()) hold where
/// no other key gives one; in "grow", so do those of a built-in style ("grow.style").
tl::expected<Recipe, ToolError> parse_recipe(const std::string& text, const std::string& name,
                                             const RecipeBeginning& beginning = {});
tl::expected<Recipe, ToolError> read_recipe(const std::filesystem::path& path, const RecipeBeginning& beginning = {});

/// Whether a path ends in ".recipe.json": as the source of a cook, such a file describes grown hair.
[[nodiscard]] bool is_recipe_file(const std::filesystem::path& path);
/// The text of a recipe's file, not looked at yet. kFileAccess where it cannot be read or is too large for one.
tl::expected<std::string, ToolError> read_recipe_text(const std::filesystem::path& path);

/// The complete recipe as JSON with a comment for each key: default, range, unit, meaning. Parses back to `recipe`.
[[nodiscard]] std::string print_recipe(const Recipe& recipe);

/// canonical_recipe() without keys that were added later and have their defaults, so that a recipe's hash stays the
/// same.
[[nodiscard]] std::string canonical_recipe(const Recipe& recipe);

/// XXH64 of canonical_recipe().
[[nodiscard]] std::uint64_t recipe_hash(const Recipe& recipe);

}  // namespace coif::cook
