#pragma once

#include "cook/recipe.h"
#include "import/source_model.h"
#include "tool_error.h"
#include "validate/issue.h"

namespace coif {

/// Why a source could not be imported.
[[nodiscard]] Issue import_issue(const ToolError& error);

/// What a cook of an imported source would stop at or warn of, as far as its first passes tell: which triangles are hair,
/// and whether they fall into strips.
[[nodiscard]] std::vector<Issue> find_source_issues(const SourceModel& source, const Recipe& recipe);

}  // namespace coif
