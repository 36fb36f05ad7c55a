#pragma once

#include "cli/messages.h"
#include "cook/recipe.h"
#include "import/import.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace coif {

struct RecipeChoice {
  Recipe recipe;
  std::filesystem::path directory;  ///< Where its texture paths start: the recipe's folder, else the source's.
  std::filesystem::path file;       ///< Empty: the defaults, no file.
};

/// The recipe named on the command line; else SOURCE-stem.recipe.json beside the source, with a note; else defaults. An empty
/// `source` has nothing beside it.
tl::expected<RecipeChoice, ToolError> choose_recipe(const std::filesystem::path& source,
                                                    const std::optional<std::string>& named, const Messages& messages);

/// What a recipe says about reading the source.
[[nodiscard]] ImportSettings import_settings(const Recipe& recipe);

}  // namespace coif
