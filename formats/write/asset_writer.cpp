#include "write/asset_writer.h"

#include "payload_hash.h"
#include "write/strip_asset.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace coif {
namespace {

template <typename Record>
std::span<const std::byte> bytes_of(const std::vector<Record>& records) {
  return std::as_bytes(std::span(records));
}

std::span<const std::byte> bytes_of(const SkeletonRecord& skeleton) { return std::as_bytes(std::span(&skeleton, 1)); }

/// Adds names[i] to `packed`. Returns its offset there, kNone without a name.
std::uint32_t pack_name(const std::vector<std::string>& names, std::size_t i, std::vector<char>& packed) {
  if (i >= names.size() || names[i].empty()) return kNone;
  const auto offset = std::uint32_t(packed.size());
  const std::size_t length = std::min(names[i].find('\0'), names[i].size());
  packed.insert(packed.end(), names[i].begin(), names[i].begin() + std::ptrdiff_t(length));
  packed.push_back(0);
  return offset;
}

/// Joins the names and points each bone at its own.
void pack_names(AssetContents& contents) {
  contents.names.clear();
  for (std::size_t i = 0; i < contents.bones.size(); ++i) {
    contents.bones[i].name = pack_name(contents.bone_names, i, contents.names);
  }
  for (std::size_t i = 0; i < contents.body_bones.size(); ++i) {
    contents.body_bones[i].name = pack_name(contents.body_bone_names, i, contents.names);
  }
}

void count_bones(AssetContents& contents) {
  const auto simulated = [](const BoneRecord& bone) { return bone.kind == BoneKind::kSimulated; };
  contents.skeleton.bone_count = std::uint32_t(contents.bones.size());
  contents.skeleton.chain_count = std::uint32_t(contents.chains.size());
  contents.skeleton.simulated_count = std::uint32_t(std::ranges::count_if(contents.bones, simulated));
}

void add_chunks(const AssetContents& contents, bool draw_data, std::vector<PendingChunk>& chunks) {
  const auto add = [&](std::uint32_t id, std::span<const std::byte> bytes) {
    if (bytes.empty() || is_draw_data(id) != draw_data) return;
    chunks.push_back({id, is_needed_chunk(id) ? kChunkRequired : 0, bytes, chunk_alignment(id)});
  };
#define COIF_ADD(constant, id, Record, count, name, ...) add(chunk::constant, bytes_of(contents.name));
  COIF_CHUNKS(COIF_ADD)
#undef COIF_ADD
}

template <typename Record>
std::uint64_t clear(std::vector<Record>& records) {
  const std::uint64_t bytes = bytes_of(records).size();
  records.clear();
  return bytes;
}

std::uint64_t clear(SkeletonRecord&) { return 0; }  // Every asset has a skeleton.

}  // namespace

std::vector<std::byte> write_asset(AssetContents contents) {
  pack_names(contents);
  count_bones(contents);
  std::vector<PendingChunk> chunks;
  for (const bool draw_data : {false, true}) add_chunks(contents, draw_data, chunks);
  return write_chunks(chunks);
}

std::uint64_t clear_group(std::string_view group, AssetContents& contents) {
  std::uint64_t bytes = 0;
  pack_names(contents);
#define COIF_CLEAR(constant, id, Record, count, name, ...) \
  if (is_in_group(chunk::constant, group)) bytes += clear(contents.name);
  COIF_CHUNKS(COIF_CLEAR)
#undef COIF_CLEAR
  if (!contents.names.empty()) return bytes;
  contents.bone_names.clear();
  pack_names(contents);
  return bytes - contents.names.size();
}

namespace {

std::size_t round_up(std::size_t value, std::size_t alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

/// The table of chunks with their places in the file.
std::vector<ChunkEntry> lay_out(std::span<const PendingChunk> chunks) {
  std::vector<ChunkEntry> table;
  std::size_t end = sizeof(FileHeader) + chunks.size() * sizeof(ChunkEntry);
  for (const PendingChunk& chunk : chunks) {
    const std::size_t offset = round_up(end, chunk.alignment);
    table.push_back({chunk.id, chunk.flags, offset, chunk.bytes.size(), xxh64(chunk.bytes)});
    end = offset + chunk.bytes.size();
  }
  return table;
}

}  // namespace

std::vector<std::byte> write_chunks(std::span<const PendingChunk> chunks, std::uint16_t minor) {
  const std::vector<ChunkEntry> table = lay_out(chunks);
  const std::uint64_t bytes = table.empty() ? sizeof(FileHeader) : table.back().offset + table.back().bytes;
  std::vector<std::byte> file(static_cast<std::size_t>(bytes));
  FileHeader header{};
  std::memcpy(header.magic, kAssetMagic, sizeof header.magic);
  header.major = kAssetMajor;
  header.minor = minor;
  header.chunk_count = std::uint32_t(table.size());
  header.total_bytes = file.size();
  std::memcpy(file.data(), &header, sizeof header);
  if (!table.empty()) std::memcpy(file.data() + sizeof header, table.data(), table.size() * sizeof(ChunkEntry));
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    if (chunks[i].bytes.empty()) continue;
    std::memcpy(file.data() + table[i].offset, chunks[i].bytes.data(), chunks[i].bytes.size());
  }
  header.table_hash = table_hash(file, header.chunk_count);
  std::memcpy(file.data(), &header, sizeof header);
  return file;
}

}  // namespace coif
