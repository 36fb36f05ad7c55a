#pragma once

#include "base/tool_error.h"
#include "cli/messages.h"
#include "cli/options.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace coif::cli {

/// The page of `coif view` that lies at `place`, read, which begins with this motion if there is one. Errors: those of
/// a clip, of a file that cannot be read, and of a page without a place for motions.
[[nodiscard]] tl::expected<std::string, ToolError> moved_page(const std::filesystem::path& place,
                                                              const std::optional<HeadMotion>& motion,
                                                              const Messages& messages);

}  // namespace coif::cli
