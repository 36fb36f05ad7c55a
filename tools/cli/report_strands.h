#pragma once

#include "base/tool_error.h"
#include "cli/messages.h"
#include "cli/report_options.h"
#include "groom/groom.h"

#include <tl/expected.hpp>

#include <cstdint>

namespace coif::cli {

/// What `coif report cards` compares with, and how.
struct ReportStrands {
  groom::Groom groom;
  std::uint64_t hash = 0;          ///< XXH64 of its file.
  report::CardsSettings settings;  ///< Those asked for, with what the recipe says.
};

/// Reads the strands as a cook with the recipe does. Errors: kUsage for a file that is of no format with strands or
/// pictures that are not square; those of choose_recipe() and read_groom(). Blocks; costs a fork.
[[nodiscard]] tl::expected<ReportStrands, ToolError> read_report_strands(const ReportOptions& options,
                                                                         const Messages& messages);

}  // namespace coif::cli
