#pragma once
// JSON <-> one value of a recipe. The only place that knows how each type of value is written.

#include "cook/recipe_keys.h"

#include <nlohmann/json.hpp>

namespace coif {

/// Reads `json` into the field of `recipe`. The error is the rest of a sentence that starts with the key:
/// "wants a number from 0 to 1, found \"much\"".
tl::expected<void, std::string> read_value(const RecipeKey& key, const nlohmann::json& json, Recipe& recipe);

[[nodiscard]] nlohmann::json write_value(const RecipeKey& key, const Recipe& recipe);

}  // namespace coif
