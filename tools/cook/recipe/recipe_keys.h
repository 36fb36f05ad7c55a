#pragma once

#include "base/json.h"
#include "cook/recipe/recipe.h"

#include <span>
#include <variant>

namespace coif {

using RecipeField = std::variant<bool Recipe::*, double Recipe::*, std::uint32_t Recipe::*, std::string Recipe::*,
                                 std::vector<std::string> Recipe::*, std::vector<CurvePoint> Recipe::*,
                                 std::array<double, 3> Recipe::*, std::array<double, 4> Recipe::*,
                                 std::optional<double> Recipe::*, std::optional<std::array<double, 3>> Recipe::*,
                                 std::vector<PatchOverride> Recipe::*>;

/// One key of a recipe: everything that reading, checking and printing it needs.
struct RecipeKey {
  const char* section;
  const char* name;
  RecipeField field;
  const char* default_json;
  double low;  ///< Smallest and largest number allowed, where the value has numbers.
  double high;
  const char* choices;  ///< Words allowed, separated by '|'; null: any text.
  const char* unit;     ///< "" where there is none.
  const char* meaning;  ///< What the artist sees, one line.

  [[nodiscard]] std::string path() const { return std::string(section) + "." + name; }
};

[[nodiscard]] std::span<const RecipeKey> recipe_keys();

// JSON <-> one value of a recipe. The only place that knows how each type of value is written.

/// "wants a number from 0 to 1, found \"much\"": what to say of a value that is something else.
[[nodiscard]] tl::unexpected<std::string> wants(const std::string& what, const nlohmann::json& found);

/// Reads `json` into the field of `recipe`. The error is the rest of a sentence that starts with the key:
/// "wants a number from 0 to 1, found \"much\"".
tl::expected<void, std::string> read_value(const RecipeKey& key, const nlohmann::json& json, Recipe& recipe);

[[nodiscard]] nlohmann::json write_value(const RecipeKey& key, const Recipe& recipe);

/// The same of "patches.overrides" alone.
tl::expected<void, std::string> read_overrides(const nlohmann::json& json, std::vector<PatchOverride>& out);
[[nodiscard]] nlohmann::json write_overrides(const std::vector<PatchOverride>& overrides);

}  // namespace coif
