#pragma once

#include "cli/cook_job.h"
#include "cli/exit_code.h"

namespace coif {

/// Cooks several sources into a folder, each for itself, in processes of their own; one that fails or crashes stops no
/// other. Prints a table (or JSON, which --report gets too), and returns the highest exit code of all. Errors: kUsage,
/// before anything is cooked.
tl::expected<Exit, ToolError> run_cook_batch(const CookOptions& options, const Messages& messages);

}  // namespace coif
