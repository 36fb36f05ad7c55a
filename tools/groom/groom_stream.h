#pragma once
// What the process that reads strands sends back; as import/model_stream.h, which see.

#include "base/tool_error.h"
#include "groom/groom.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::groom {

using GroomOutcome = tl::expected<Groom, ToolError>;

[[nodiscard]] std::vector<std::uint8_t> encode_groom(const GroomOutcome& outcome);

/// False, with `outcome` untouched, unless the bytes are exactly one outcome whose groom keeps every promise of
/// groom.h. Allocates at most a small multiple of the bytes given.
[[nodiscard]] bool decode_groom(std::span<const std::uint8_t> bytes, GroomOutcome& outcome);

}  // namespace coif::groom
