#include <coif/asset.h>

#include "chunk_checks.h"
#include "payload_hash.h"

namespace coif {
namespace {

constexpr std::size_t kChunkAlignment = 16;
constexpr std::size_t kTexelAlignment = 64;

std::size_t alignment_of(std::uint32_t id) { return id == chunk::kTexels ? kTexelAlignment : kChunkAlignment; }

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
                        entry.bytes <= bytes.size() - entry.offset && entry.offset % alignment_of(entry.id) == 0;
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

/// The records of one chunk as a span into the file; empty where the chunk is absent.
template <typename Record>
LoadStatus read_chunk(const std::byte* file, const ChunkEntry& entry, std::span<const Record>& out) {
  if (entry.bytes % sizeof(Record) != 0) {
    return {LoadCode::kChunkSize, entry.id, 0, sizeof(Record), entry.bytes};
  }
  out = {reinterpret_cast<const Record*>(file + entry.offset), std::size_t(entry.bytes / sizeof(Record))};
  return {};
}

template <typename Record>
LoadStatus read_single(const std::byte* file, const ChunkEntry& entry, const Record*& out) {
  if (entry.bytes != sizeof(Record)) return {LoadCode::kChunkSize, entry.id, 0, sizeof(Record), entry.bytes};
  out = reinterpret_cast<const Record*>(file + entry.offset);
  return {};
}

}  // namespace

LoadStatus Asset::read_chunk_into_view(const std::byte* file, const ChunkEntry& entry) {
  switch (entry.id) {
    case chunk::kSkeleton: return read_single(file, entry, skeleton_);
    case chunk::kBones: return read_chunk(file, entry, bones_);
    case chunk::kNames: return read_chunk(file, entry, names_);
    case chunk::kChains: return read_chunk(file, entry, chains_);
    case chunk::kDynamics: return read_chunk(file, entry, dynamics_);
    case chunk::kColliders: return read_chunk(file, entry, colliders_);
    case chunk::kVertices: return read_chunk(file, entry, vertices_);
    case chunk::kSkin: return read_chunk(file, entry, skin_);
    case chunk::kIndices: return read_chunk(file, entry, indices_);
    case chunk::kPatches: return read_chunk(file, entry, patches_);
    case chunk::kLods: return read_chunk(file, entry, lods_);
    case chunk::kLodBones: return read_chunk(file, entry, lod_bones_);
    case chunk::kOrders: return read_chunk(file, entry, orders_);
    case chunk::kOrderViews: return read_chunk(file, entry, order_views_);
    case chunk::kMaterial: return read_single(file, entry, material_);
    case chunk::kTextures: return read_chunk(file, entry, textures_);
    case chunk::kTexels: return read_chunk(file, entry, texels_);
    case chunk::kProvenance: return read_single(file, entry, provenance_);
    case chunk::kTuning: return read_single(file, entry, tuning_);
    case chunk::kQuality: return read_chunk(file, entry, quality_);
    default: break;
  }
  if ((entry.flags & kChunkRequired) != 0) return {LoadCode::kChunkUnknown, entry.id};
  return {};
}

LoadStatus Asset::check_content() const {
  if (skeleton_ == nullptr) return {LoadCode::kChunkMissing, chunk::kSkeleton};
  if (bones_.empty()) return {LoadCode::kChunkMissing, chunk::kBones};
  if (const LoadStatus status = check_names(names_); !status) return status;
  if (const LoadStatus status = check_skeleton(*this, names_.size()); !status) return status;
  if (const LoadStatus status = check_dynamics(*this); !status) return status;
  if (const LoadStatus status = check_colliders(*this); !status) return status;
  if (const LoadStatus status = check_lods(*this); !status) return status;
  if (const LoadStatus status = check_mesh(*this); !status) return status;
  if (const LoadStatus status = check_orders(*this); !status) return status;
  if (const LoadStatus status = check_material(*this); !status) return status;
  if (const LoadStatus status = check_textures(*this, texels_.size()); !status) return status;
  if (const LoadStatus status = check_tuning(*this); !status) return status;
  return check_provenance(*this);
}

LoadStatus Asset::open(std::span<const std::byte> bytes, const OpenOptions& options) {
  *this = Asset{};
  if (bytes.size() < sizeof(FileHeader)) return {LoadCode::kTooSmall, 0, 0, sizeof(FileHeader), bytes.size()};
  if (!is_aligned(bytes.data(), kChunkAlignment)) return {LoadCode::kMisaligned};
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
  if (!view.texels_.empty() && !is_aligned(bytes.data(), kTexelAlignment)) return {LoadCode::kMisaligned};
  if (const LoadStatus status = view.check_content(); !status) return status;
  *this = view;
  return {};
}

}  // namespace coif
