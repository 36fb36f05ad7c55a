#pragma once

#include "base/tool_error.h"
#include "import/import.h"
#include "import/source_model.h"
#include "platform/job.h"

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

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

// What the import process sends back: a model or an error, as bytes. Private to the two ends of one pipe of one
// program, so it has no version; but the sender may have been taken over by the file that it parsed, so the receiver
// trusts nothing.

using ImportOutcome = tl::expected<SourceModel, ToolError>;

[[nodiscard]] std::vector<std::uint8_t> encode_outcome(const ImportOutcome& outcome);

/// False, with `outcome` untouched, unless the bytes are exactly one outcome whose model keeps every promise of
/// source_model.h. Allocates at most a small multiple of the bytes given.
[[nodiscard]] bool decode_outcome(std::span<const std::uint8_t> bytes, ImportOutcome& outcome);

/// The same for models that went through more hands than a reader's: all of one, those parts too that no reader makes
/// (cards of strands, roots). For bytes that this program wrote itself.
[[nodiscard]] std::vector<std::uint8_t> encode_model(const ImportOutcome& outcome);
[[nodiscard]] bool decode_model(std::span<const std::uint8_t> bytes, ImportOutcome& outcome);

}  // namespace coif::importer
