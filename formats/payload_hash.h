#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// XXH64, a fast 64-bit checksum against accidents (it is no defence against a forger).
/// Source: the XXH64 algorithm description in the xxHash specification by Yann Collet.
[[nodiscard]] std::uint64_t xxh64(std::span<const std::byte> bytes, std::uint64_t seed = 0);

/// What FileHeader::table_hash of this file should be. `file` holds at least the header and the table.
[[nodiscard]] std::uint64_t table_hash(std::span<const std::byte> file, std::uint32_t chunk_count);

}  // namespace coif
