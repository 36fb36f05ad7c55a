#pragma once

#include "base/json.h"
#include "base/tool_error.h"
#include "cook/recipe/recipe.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace coif::view {

/// A recipe's file and what somebody changed of it on the page.
struct LiveRecipe {
  cook::Recipe recipe;  ///< The file's, with the changes.
  nlohmann::json file;  ///< The file alone; an empty object without one.
};

/// What the page sent: recipe keys and their values, null for "not as the file says". Errors (kBadInput): no JSON
/// object, or it names a file, which a recipe on the disk alone may. That the keys are some, and their values in range,
/// live_recipe() finds.
[[nodiscard]] tl::expected<nlohmann::json, ToolError> read_changes(std::string_view text);

/// Reads the file, none where its path is empty, merges the changes into it (RFC 7396) and judges the result as a
/// recipe's file is. Errors: those of read_recipe() for the file; of parse_recipe() for the changes.
[[nodiscard]] tl::expected<LiveRecipe, ToolError> live_recipe(const std::filesystem::path& file,
                                                              const nlohmann::json& changes);

}  // namespace coif::view
