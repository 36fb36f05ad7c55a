#pragma once

#include "cli/cook_job.h"
#include "pipeline/manifest.h"

namespace coif {

/// What a command line with several sources or a manifest asks for: all of it, or the batch of it that is named. Errors: those
/// of read_manifest(), and kUsage for options that do not go with many sources.
tl::expected<std::vector<CookRequest>, ToolError> batch_requests(const CookOptions& options);

/// "K/N", K within 1 .. N. Error (kUsage): says so.
tl::expected<Share, ToolError> parse_share(const std::string& text);

}  // namespace coif
