#pragma once

#include "base/tool_error.h"
#include "cli/command.h"
#include "cli/messages.h"
#include "cli/options.h"
#include "cli/source_limits.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coif::cli {

/// The command line of `coif view` of a source or a recipe.
struct LiveOptions {
  std::string file;  ///< A source, or a recipe with its source beside it.
  std::optional<std::string> recipe;
  std::vector<std::filesystem::path> roots;
  std::filesystem::path page;        ///< As find_view_page() found it.
  std::optional<HeadMotion> motion;  ///< That it begins with.
  SourceLimits limits;
  bool draft = true;
  std::uint16_t port = 0;
  OutputFormat format = OutputFormat::kText;
};

/// Serves a page of it until somebody ends the program (SIGINT, SIGTERM, SIGHUP). Prints the address; what becomes of
/// cooks goes to `messages`.
tl::expected<Exit, ToolError> view_live(LiveOptions options, const Messages& messages);

}  // namespace coif::cli
