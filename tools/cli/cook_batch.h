#pragma once

#include "cli/cook_job.h"
#include "cli/exit_code.h"

namespace coif {

/// Cooks several sources, or a manifest's, into a folder, each for itself, in processes of their own; one that fails or crashes
/// stops no other. Prints a table or JSON, writes that or a page with pictures to --report, and returns the highest exit code
/// of all. Errors: those of batch_requests(), before anything is cooked, and a report that cannot be written.
tl::expected<Exit, ToolError> run_cook_batch(const CookOptions& options, const Messages& messages);

}  // namespace coif
