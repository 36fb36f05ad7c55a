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

// Files of strangers are read by a child process under the limits of ImportSettings, which is locked up where the
// kernel supports that (platform/job.h). It may open nothing but the source, its folder and the roots, and make no
// socket and no process.

/// Runs `job`, whose function calls answer_read(), and returns its answer, which must be trusted as little as the
/// source. Errors: kBadInput where the child crashed or exceeded a limit, with a cure; kInternal where it could not be
/// started; kUnsupported with settings.requires_sandbox where it cannot be locked up. Throws Stopped, after the child
/// has ended, where settings.stop is requested. Blocks.
[[nodiscard]] tl::expected<platform::Bytes, ToolError> read_in_child(const platform::Job& job,
                                                                     const std::filesystem::path& path,
                                                                     const ImportSettings& settings);

/// The child's part: locks this process up as the call says, and returns the result of `read`.
[[nodiscard]] platform::Bytes answer_read(const platform::JobCall& call,
                                          platform::Bytes (*read)(const std::filesystem::path& path,
                                                                  const ImportSettings& settings));

/// The error for an answer that cannot be decoded.
[[nodiscard]] tl::unexpected<ToolError> senseless_answer(const std::filesystem::path& path);

/// Settings on their way to another process of this program, in MessagePack. Their token stays here.
[[nodiscard]] nlohmann::json import_document(const ImportSettings& settings);
/// Throws a std::exception for any other document.
[[nodiscard]] ImportSettings import_settings_from(const nlohmann::json& document);
// The answer of the import process: a model or an error, as bytes. Private to the two ends of one pipe of one program,
// so it has no version. The sender may have been taken over by the file that it parsed, so the receiver trusts nothing.

using ImportOutcome = tl::expected<SourceModel, ToolError>;

[[nodiscard]] std::vector<std::uint8_t> encode_outcome(const ImportOutcome& outcome);

/// False, with `outcome` untouched, unless the bytes are exactly one outcome whose model keeps every promise of
/// source_model.h. Allocates at most a small multiple of the bytes given.
[[nodiscard]] bool decode_outcome(std::span<const std::uint8_t> bytes, ImportOutcome& outcome);

/// Encodes models that have passed through more than a reader, with the parts that no reader makes (cards of strands,
/// roots). For bytes that this program reads itself.
[[nodiscard]] std::vector<std::uint8_t> encode_model(const ImportOutcome& outcome);
[[nodiscard]] bool decode_model(std::span<const std::uint8_t> bytes, ImportOutcome& outcome);

}  // namespace coif::importer
