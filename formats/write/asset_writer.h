#pragma once
// For tools only. A game never links this.

#include <coif/chunks.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace coif {

/// A chunk in editable form: a list of records, or a single record for a chunk that every asset has once.
template <std::uint32_t kId>
using EditableChunk =
    std::conditional_t<is_needed_chunk(kId) && kChunkLayouts[chunk_row(kId)].count == ChunkCount::kOne,
                       typename ChunkRecord<kId>::Type, std::vector<typename ChunkRecord<kId>::Type>>;

/// Everything a .coif can hold: a field for each chunk by its name in COIF_CHUNKS, such as `skeleton`, `bones` or
/// `lod_bones`. An empty field leaves its chunk out. `material`, `provenance` and `tuning` have one record or none.
/// Offsets and bytes of `textures` refer to `texels`.
struct AssetContents {
#define COIF_FIELD(constant, id, Record, count, name, ...) EditableChunk<chunk::constant> name{};
  COIF_CHUNKS(COIF_FIELD)
#undef COIF_FIELD
  /// One per bone, or empty. write_asset() builds `names` from them, and sets BoneRecord::name and the counts in
  /// `skeleton`.
  std::vector<std::string> bone_names;
  /// One per body bone. write_asset() stores them behind the bones' names, and sets BodyBoneRecord::name.
  std::vector<std::string> body_bone_names;
};

/// The file's bytes. Deterministic: equal contents give equal bytes. Contents that the reader would refuse are
/// the caller's bug; open the result to find out.
[[nodiscard]] std::vector<std::byte> write_asset(AssetContents contents);

/// Empties the chunks that `coif strip` knows by this word. Returns how many bytes of records they were. The names of
/// body bones stay as long as body bones do.
std::uint64_t clear_group(std::string_view group, AssetContents& contents);

// Functions that build a file from any chunks, whatever they mean.

/// A chunk that waits to be written. Does not own the bytes.
struct PendingChunk {
  std::uint32_t id = 0;
  std::uint32_t flags = 0;
  std::span<const std::byte> bytes;
  std::size_t alignment = 1;  ///< Its offset in the file is a multiple of this.
};

/// Writes header, table and chunks in the order given, as close to each other as their alignment allows, with the
/// hashes filled in.
[[nodiscard]] std::vector<std::byte> write_chunks(std::span<const PendingChunk> chunks,
                                                  std::uint16_t minor = kAssetMinor);

}  // namespace coif
