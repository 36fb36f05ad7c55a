#pragma once

#include "cook/recipe.h"
#include "import/source_model.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <string>

namespace coif {

/// Leaves the body alone, so that hair is not drawn twice. `pattern`: with * and ?, of the meshes to keep; empty:
/// everything that a cook with this recipe would not take for hair. Errors: kBadInput where nothing is left, with the names
/// that there are; those of choose_hair().
tl::expected<SourceModel, ToolError> keep_body(SourceModel model, const std::string& pattern, const Recipe& recipe);

}  // namespace coif
