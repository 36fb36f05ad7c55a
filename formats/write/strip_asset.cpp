#include "write/strip_asset.h"

#include "write/asset_writer.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace coif {
namespace {

bool contains(std::span<const std::uint32_t> ids, std::uint32_t id) { return std::ranges::find(ids, id) != ids.end(); }

/// The bone as a rigid bone, in the form that SPECIFICATION.md demands.
void make_rigid(BoneRecord& bone) {
  if (bone.kind != BoneKind::kSimulated) return;
  bone.kind = BoneKind::kScalp;
  bone.chain = kNone;
  bone.length = 0;
  std::ranges::fill(bone.rest_direction, 0.0f);
  bone.colliders = 0;
}

class Stripper {
 public:
  Stripper(const Asset& asset, std::span<const std::byte> file, std::span<const std::uint32_t> chunks)
      : asset_(asset), file_(file), gone_(with_dependents(chunks)) {}

  StrippedAsset strip() && {
    bytes_.reserve(asset_.chunks().size());  // Pending chunks point into it, so it must not move.
    for (const ChunkEntry& entry : asset_.chunks()) {
      if (loses(entry.id)) {
        result_.removed.push_back({entry.id, entry.bytes});
      } else {
        keep(entry);
      }
    }
    if (result_.removed.empty()) {
      result_.file.assign(file_.begin(), file_.end());
    } else {
      result_.file = write_chunks(kept_, asset_.minor());
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool loses(std::uint32_t id) const { return contains(gone_, id); }

  void keep(const ChunkEntry& entry) {
    const auto before = file_.subspan(std::size_t(entry.offset), std::size_t(entry.bytes));
    const std::vector<std::byte>& bytes = bytes_.emplace_back(without_gone(entry.id, before));
    if (bytes.size() < before.size()) {
      result_.shortened.push_back({entry.id, before.size() - bytes.size()});
    } else if (!std::ranges::equal(bytes, before)) {
      result_.rewritten.push_back(entry.id);
    }
    kept_.push_back({entry.id, entry.flags, bytes, alignment_of(entry)});
  }

  /// A chunk that this version does not know may need the alignment that it has.
  static std::size_t alignment_of(const ChunkEntry& entry) {
    const bool known = chunk_row(entry.id) < kChunkKinds;
    return !known && entry.offset % 64 == 0 ? 64 : chunk_alignment(entry.id);
  }

  /// A chunk's bytes without any reference to a removed chunk.
  [[nodiscard]] std::vector<std::byte> without_gone(std::uint32_t id, std::span<const std::byte> bytes) const {
    std::vector<std::byte> out(bytes.begin(), bytes.end());
    switch (id) {
      case chunk::kSkeleton: rewrite<SkeletonRecord>(out, [this](auto& record) { change(record); }); break;
      case chunk::kBones: rewrite<BoneRecord>(out, [this](auto& record) { change(record); }); break;
      case chunk::kLodBones:
      case chunk::kBodySets:
        if (loses(chunk::kDynamics)) std::ranges::fill(out, std::byte{0});
        break;
      case chunk::kPatches: out.resize(loses(chunk::kLods) ? asset_.lod_patches(0).size_bytes() : out.size()); break;
      case chunk::kIndices: out.resize(loses(chunk::kLods) ? asset_.lod_indices(0).size_bytes() : out.size()); break;
      case chunk::kVertices:
        out.resize(loses(chunk::kLods) ? finest_vertices() * sizeof(VertexRecord) : out.size());
        break;
      case chunk::kSkin: out.resize(loses(chunk::kLods) ? finest_vertices() * sizeof(SkinRecord) : out.size()); break;
      case chunk::kOrders:
        if (loses(chunk::kLods)) keep_finest_level(out);
        break;
      default: break;
    }
    return out;
  }

  /// How many records there are up to the last one that the level draws. A cook puts those that only coarser levels
  /// draw behind them.
  [[nodiscard]] std::size_t finest_vertices() const {
    const auto indices = asset_.lod_indices(0);
    return indices.empty() ? asset_.vertices().size() : std::size_t(std::ranges::max(indices)) + 1;
  }

  /// The level's part of each draw order.
  void keep_finest_level(std::vector<std::byte>& orders) const {
    const std::size_t whole = asset_.indices().size() / 3 * sizeof(std::uint32_t);
    const std::size_t finest = asset_.lod_indices(0).size() / 3 * sizeof(std::uint32_t);
    const std::size_t count = orders.size() / whole;
    for (std::size_t k = 1; k < count; ++k) std::memmove(&orders[k * finest], &orders[k * whole], finest);
    orders.resize(count * finest);
  }

  template <typename Record, typename Change>
  static void rewrite(std::vector<std::byte>& bytes, const Change& change) {
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(Record)) {
      Record record;
      std::memcpy(&record, bytes.data() + at, sizeof record);
      change(record);
      std::memcpy(bytes.data() + at, &record, sizeof record);
    }
  }

  void change(SkeletonRecord& skeleton) const {
    if (loses(chunk::kDynamics)) skeleton.simulated_count = skeleton.chain_count = 0;
  }

  void change(BoneRecord& bone) const {
    if (loses(chunk::kNames)) bone.name = kNone;
    if (loses(chunk::kColliders)) bone.colliders = 0;
    if (loses(chunk::kDynamics)) make_rigid(bone);
  }

  const Asset& asset_;
  std::span<const std::byte> file_;
  std::vector<std::uint32_t> gone_;
  std::vector<std::vector<std::byte>> bytes_;
  std::vector<PendingChunk> kept_;
  StrippedAsset result_;
};

}  // namespace

std::vector<std::uint32_t> with_dependents(std::span<const std::uint32_t> chunks) {
  std::vector<std::uint32_t> all(chunks.begin(), chunks.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const ChunkLayout& layout : kChunkLayouts) {
      const bool needs_it = all[i] != 0 && contains(layout.needs.ids, all[i]);
      if (needs_it && !contains(all, layout.id)) all.push_back(layout.id);
    }
  }
  return all;
}

StrippedAsset strip_asset(const Asset& asset, std::span<const std::byte> file, std::span<const std::uint32_t> chunks) {
  return Stripper(asset, file, chunks).strip();
}

}  // namespace coif
