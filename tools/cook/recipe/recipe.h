#pragma once

// What an artist may say about a cook. recipe_keys.cpp holds the one table of keys, defaults and ranges.

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

/// All values of a recipe: what it says of each stage of a cook, which knows its own part alone. Their defaults and
/// ranges stand in the table of recipe_keys.cpp: start from default_recipe().
struct Recipe : HairStyle, SceneRecipe, SourceRecipe, CardsRecipe, HairRecipe, StripRecipe, RigRecipe, DrawnRecipe {
  std::string look_preset;                         ///< "none", or what the values began from.
  std::vector<std::string> acknowledged_warnings;  ///< Codes of the table of issues.
};

/// What shows how hair looks and moves, in a fraction of the time: one level of detail, drawn by distance from the
/// head, small textures stored as they come, no occlusion, cards fitted once.
[[nodiscard]] Recipe draft_of(Recipe recipe);

/// Every key at its default.
[[nodiscard]] Recipe default_recipe();

/// What a recipe begins from, whatever it says itself. Empty: as it says.
struct RecipeBeginning {
  std::string preset;  ///< Before its "look.preset".
  std::string style;   ///< Before its "grow.style".
};

/// Reads JSON (with // comments). Unknown keys, wrong types and values out of range are errors that name the key,
/// the range and, for a misspelt key, the nearest one.
/// What a preset ("look.preset", recipe_presets()) says holds where no other key does; so does, in "grow", what a
/// built-in style
/// ("grow.style") says.
tl::expected<Recipe, ToolError> parse_recipe(const std::string& text, const std::string& name,
                                             const RecipeBeginning& beginning = {});
tl::expected<Recipe, ToolError> read_recipe(const std::filesystem::path& path, const RecipeBeginning& beginning = {});

/// Whether a path ends in ".recipe.json": as the source of a cook such a file says itself what hair grows.
[[nodiscard]] bool is_recipe_file(const std::filesystem::path& path);
/// The text of a recipe's file, not looked at yet. kFileAccess where it cannot be read or is too large for one.
tl::expected<std::string, ToolError> read_recipe_text(const std::filesystem::path& path);

/// The complete recipe as JSON with a comment for each key: default, range, unit, meaning. Parses back to `recipe`.
[[nodiscard]] std::string print_recipe(const Recipe& recipe);

/// The same without what was added to comments since: what a recipe's hash is taken of, so that it stays what it was.
[[nodiscard]] std::string canonical_recipe(const Recipe& recipe);

/// XXH64 of canonical_recipe().
[[nodiscard]] std::uint64_t recipe_hash(const Recipe& recipe);

}  // namespace coif::cook
