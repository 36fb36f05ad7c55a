#pragma once

#include "base/tool_error.h"
#include "import/import.h"
#include "platform/job.h"

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include <filesystem>

namespace coif::importer {

// How files of strangers are read: by a child process under the limits of ImportSettings that is locked up where the
// kernel can do that (platform/job.h). It may open nothing but the source, its folder and the roots, and make no
// socket and no process. One end asks:

/// Asks for `job`, whose function calls answer_read(), and returns what it answered, which is to be trusted as little
/// as the source. Errors: kBadInput where the child crashed or exceeded a limit, with a cure, kInternal where it could
/// not be started, kUnsupported where settings.requires_sandbox and it cannot be locked up. Throws Stopped, the child
/// gone, where settings.stop is requested. Blocks.
[[nodiscard]] tl::expected<platform::Bytes, ToolError> read_in_child(const platform::Job& job,
                                                                     const std::filesystem::path& path,
                                                                     const ImportSettings& settings);

/// ... the other reads: locks this process up as the call asks, and returns what `read` does.
[[nodiscard]] platform::Bytes answer_read(const platform::JobCall& call,
                                          platform::Bytes (*read)(const std::filesystem::path& path,
                                                                  const ImportSettings& settings));

/// Of an answer that is none.
[[nodiscard]] tl::unexpected<ToolError> senseless_answer(const std::filesystem::path& path);

/// Settings on their way to another process of this program, in MessagePack. Their token stays here.
[[nodiscard]] nlohmann::json import_document(const ImportSettings& settings);
/// Throws a std::exception for any other document.
[[nodiscard]] ImportSettings import_settings_from(const nlohmann::json& document);

}  // namespace coif::importer
