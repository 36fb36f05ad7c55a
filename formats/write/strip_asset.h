#pragma once
// For tools only: the words by which people speak of chunks.

#include <coif/asset.h>
#include <coif/chunks.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

/// The four letters of a chunk's name; bytes that cannot be printed become '?'.
[[nodiscard]] std::string chunk_name(std::uint32_t id);

/// What a chunk holds, in a few words. Empty for a chunk that this version does not know.
[[nodiscard]] const char* chunk_contents(std::uint32_t id);

/// Who reads it. kTools for a chunk that this version does not know.
[[nodiscard]] ChunkUse chunk_use(std::uint32_t id);

/// A word that stands for several chunks, so that users need no table of the format.
struct ChunkGroup {
  const char* name;
  const char* meaning;  ///< What an asset without them lacks.
};

[[nodiscard]] std::span<const ChunkGroup> chunk_groups();

[[nodiscard]] bool is_in_group(std::uint32_t id, std::string_view group);

/// In the order of kChunkLayouts.
[[nodiscard]] std::vector<std::uint32_t> chunks_of_group(std::string_view group);

// For tools only: leaves out of an asset what a scene does not need. SPECIFICATION.md, "Leaving chunks out".

/// What a chunk lost.
struct StrippedChunk {
  std::uint32_t id = 0;
  std::uint64_t bytes = 0;
};

struct StrippedAsset {
  std::vector<std::byte> file;           ///< The bytes of a .coif; opens without error.
  std::vector<StrippedChunk> removed;    ///< Whole chunks, in the file's order.
  std::vector<StrippedChunk> shortened;  ///< Chunks that have fewer records now.
  std::vector<std::uint32_t> rewritten;  ///< Chunks of the same size that no longer refer to what was removed.
};

/// `chunks`, followed by all others that mean nothing without one of them.
[[nodiscard]] std::vector<std::uint32_t> with_dependents(std::span<const std::uint32_t> chunks);

/// Removes with_dependents(chunks) from the open asset that lies in `file`. Chunks that the asset does not have are
/// ignored; chunks that every asset needs must not be named. References to removed chunks are rewritten: without NAME
/// bones are nameless, without COLL they touch nothing, without CHAN or DYNA all are rigid and nothing touches the
/// body, without LODS only the finest level's patches, indices and draw orders are left. All other chunks, unknown ones
/// too, keep their bytes and order. If there is nothing to remove, the result has the bytes of `file`.
[[nodiscard]] StrippedAsset strip_asset(const Asset& asset, std::span<const std::byte> file,
                                        std::span<const std::uint32_t> chunks);

}  // namespace coif
