#pragma once

#include "base/tool_error.h"
#include "groom/groom.h"
#include "import/import.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <string>

namespace coif::groom {

/// Whether strands can be read from a file of this suffix: .hair, .tfx, .obj, .gltf, .glb, whatever its case.
[[nodiscard]] bool has_strand_suffix(const std::filesystem::path& path);

/// ".hair, .tfx, ..." for messages.
[[nodiscard]] std::string strand_suffixes();

/// Reads the strands of a file, in a child process under the limits of `settings`, whose unit and up axis go before the
/// file's. Never throws. Errors: kFileAccess (absent, unreadable), kBadInput (damaged, a limit, no strand),
/// kUnsupported (suffix). Blocks; costs a fork, so call it before starting threads where you can.
tl::expected<Groom, ToolError> read_groom(const std::filesystem::path& path,
                                          const importer::ImportSettings& settings = {});

}  // namespace coif::groom
