#pragma once
// For tools only: a file from its chunks, whatever they mean.

#include <coif/asset_records.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// A chunk on its way into a file. Does not own the bytes.
struct PendingChunk {
  std::uint32_t id = 0;
  std::uint32_t flags = 0;
  std::span<const std::byte> bytes;
  std::size_t alignment = 16;  ///< Of its place in the file.
};

/// The four letters of a chunk's name; bytes that cannot be printed become '?'.
[[nodiscard]] std::string chunk_name(std::uint32_t id);

/// What the format asks of a chunk's place: 64 for texels, 16 for others.
[[nodiscard]] std::size_t chunk_alignment(std::uint32_t id);

/// Header, table and chunks in the order given, as close to each other as their alignment allows, hashes filled in.
[[nodiscard]] std::vector<std::byte> write_chunks(std::span<const PendingChunk> chunks,
                                                  std::uint16_t minor = kAssetMinor);

}  // namespace coif
