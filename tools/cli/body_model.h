#pragma once

#include "cook/recipe.h"
#include "import/source_model.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <string>

namespace coif {

/// Removes the meshes that are not the body, so that hair is not drawn twice. `pattern`: with * and ?, of a mesh's
/// name; empty: every mesh that is not hair. Hair is what the recipe selects by mesh or material; where it selects
/// nothing, what has "hair" in its mesh's, node's or material's name.
/// Error: kBadInput where no mesh is left, with the names that there are.
tl::expected<SourceModel, ToolError> keep_body(SourceModel model, const std::string& pattern, const Recipe& recipe);

}  // namespace coif
