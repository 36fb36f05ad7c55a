#pragma once
// For tools only: chunks as people speak of them.

#include <coif/chunks.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

/// The four letters of a chunk's name; bytes that cannot be printed become '?'.
[[nodiscard]] std::string chunk_name(std::uint32_t id);

/// What a chunk holds, in a few words; empty for what this version does not know.
[[nodiscard]] const char* chunk_contents(std::uint32_t id);

/// Who reads it; for what this version does not know, tools alone.
[[nodiscard]] ChunkUse chunk_use(std::uint32_t id);

/// Chunks under a word that needs no table of the format.
struct ChunkGroup {
  const char* name;
  const char* meaning;  ///< What an asset is without them.
};

[[nodiscard]] std::span<const ChunkGroup> chunk_groups();

[[nodiscard]] bool is_in_group(std::uint32_t id, std::string_view group);

/// In the order of kChunkLayouts.
[[nodiscard]] std::vector<std::uint32_t> chunks_of_group(std::string_view group);

}  // namespace coif
