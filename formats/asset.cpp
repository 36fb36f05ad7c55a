#include <coif/asset.h>

#include "chunk_checks.h"
#include "payload_hash.h"

namespace coif {
namespace {

/// The file's memory starts at a multiple of this, whichever chunks it has.
constexpr std::size_t kFileAlignment = 16;

bool is_aligned(const void* address, std::size_t alignment) {
  return reinterpret_cast<std::uintptr_t>(address) % alignment == 0;
}

LoadStatus check_header(std::span<const std::byte> bytes, const FileHeader& header, const OpenOptions& options) {
  for (std::size_t i = 0; i < sizeof kAssetMagic; ++i) {
    if (header.magic[i] != kAssetMagic[i]) return {LoadCode::kMagic, 0, i, kAssetMagic[i], header.magic[i]};
  }
  if (header.major != kAssetMajor) return {LoadCode::kMajorVersion, 0, 0, kAssetMajor, header.major};
  if (header.total_bytes != bytes.size()) return {LoadCode::kSize, 0, 0, header.total_bytes, bytes.size()};
  const std::size_t room = (bytes.size() - sizeof(FileHeader)) / sizeof(ChunkEntry);
  if (header.chunk_count > kMaxChunks || header.chunk_count > room) {
    return {LoadCode::kChunkCount, 0, 0, room < kMaxChunks ? room : kMaxChunks, header.chunk_count};
  }
  if (options.verify_hash && table_hash(bytes, header.chunk_count) != header.table_hash) {
    return {LoadCode::kHash, 0, 0, header.table_hash, table_hash(bytes, header.chunk_count)};
  }
  return {};
}

bool is_zero(std::span<const std::byte> bytes) {
  for (const std::byte b : bytes) {
    if (b != std::byte{0}) return false;
  }
  return true;
}

/// Ranges, order and alignment of the table, whatever the chunks mean.
LoadStatus check_table(std::span<const std::byte> bytes, std::span<const ChunkEntry> chunks) {
  std::uint64_t free_from = sizeof(FileHeader) + chunks.size_bytes();
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const ChunkEntry& entry = chunks[i];
    if ((entry.flags & ~kChunkRequired) != 0) return {LoadCode::kReserved, entry.id, i};
    const bool inside = entry.offset >= free_from && entry.offset <= bytes.size() &&
                        entry.bytes <= bytes.size() - entry.offset && entry.offset % chunk_alignment(entry.id) == 0;
    if (!inside) return {LoadCode::kChunkRange, entry.id, i, bytes.size(), entry.offset};
    if (!is_zero(bytes.subspan(std::size_t(free_from), std::size_t(entry.offset - free_from)))) {
      return {LoadCode::kReserved, entry.id, i};
    }
    for (std::size_t k = 0; k < i; ++k) {
      if (chunks[k].id == entry.id) return {LoadCode::kChunkDuplicate, entry.id, i};
    }
    free_from = entry.offset + entry.bytes;
  }
  if (free_from != bytes.size()) return {LoadCode::kSize, 0, 0, free_from, bytes.size()};
  return {};
}

}  // namespace

LoadStatus Asset::read_chunk_into_view(const std::byte* file, const ChunkEntry& entry) {
  const std::size_t row = chunk_row(entry.id);
  if (row == kChunkKinds) {
    return (entry.flags & kChunkRequired) != 0 ? LoadStatus{LoadCode::kChunkUnknown, entry.id} : LoadStatus{};
  }
  const ChunkLayout& layout = kChunkLayouts[row];
  const bool is_one = layout.count == ChunkCount::kOne;
  const bool whole = is_one ? entry.bytes == layout.record_bytes : entry.bytes % layout.record_bytes == 0;
  if (!whole) return {LoadCode::kChunkSize, entry.id, 0, layout.record_bytes, entry.bytes};
  const std::byte* data = file + entry.offset;
  if (entry.bytes > 0 && !is_aligned(data, layout.alignment)) return {LoadCode::kMisaligned};
  data_[row] = data;
  if (!is_one) counts_[count_arrays(row)] = std::size_t(entry.bytes / layout.record_bytes);
  return {};
}

namespace {

bool has_records(const Asset& asset, std::uint32_t id) {
  for (const ChunkEntry& entry : asset.chunks()) {
    if (entry.id == id) return entry.bytes > 0;
  }
  return false;
}

}  // namespace

LoadStatus check_needed_chunks(const Asset& asset) {
  for (const ChunkLayout& layout : kChunkLayouts) {
    const bool needed = layout.needs.presence == ChunkNeeds::Presence::kAlways;
    if (needed && !has_records(asset, layout.id)) return {LoadCode::kChunkMissing, layout.id};
  }
  return {};
}

LoadStatus check_needs(const Asset& asset) {
  for (const ChunkLayout& layout : kChunkLayouts) {
    const bool needs = layout.needs.presence == ChunkNeeds::Presence::kRefusedWithout && has_records(asset, layout.id);
    for (const std::uint32_t id : layout.needs.ids) {
      if (needs && id != 0 && !has_records(asset, id)) return {LoadCode::kChunkMissing, id};
    }
  }
  return {};
}

LoadStatus Asset::open(std::span<const std::byte> bytes, const OpenOptions& options) {
  *this = Asset{};
  if (bytes.size() < sizeof(FileHeader)) return {LoadCode::kTooSmall, 0, 0, sizeof(FileHeader), bytes.size()};
  if (!is_aligned(bytes.data(), kFileAlignment)) return {LoadCode::kMisaligned};
  Asset view;
  view.header_ = reinterpret_cast<const FileHeader*>(bytes.data());
  if (const LoadStatus status = check_header(bytes, *view.header_, options); !status) return status;
  view.chunks_ = {reinterpret_cast<const ChunkEntry*>(bytes.data() + sizeof(FileHeader)), view.header_->chunk_count};
  if (const LoadStatus status = check_table(bytes, view.chunks_); !status) return status;
  for (const ChunkEntry& entry : view.chunks_) {
    const bool verify = options.verify_hash && !is_draw_data(entry.id);
    if (const LoadStatus status = verify ? check_hash(bytes, entry) : LoadStatus{}; !status) return status;
    if (const LoadStatus status = view.read_chunk_into_view(bytes.data(), entry); !status) return status;
  }
  for (const ContentCheck check : kContentChecks) {
    if (const LoadStatus status = check(view); !status) return status;
  }
  *this = view;
  return {};
}

}  // namespace coif
