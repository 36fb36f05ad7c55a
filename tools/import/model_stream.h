#pragma once
// What the import process sends back: a model or an error, as bytes. Private to the two ends of one pipe of one
// program, so it has no version; but the sender may have been taken over by the file that it parsed, so the receiver
// trusts nothing.

#include "base/tool_error.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::importer {

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
