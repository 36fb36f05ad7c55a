#pragma once

#include <coif/chunks.h>
#include <coif/export.h>
#include <coif/load_status.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

struct OpenOptions {
  /// Compare the hashes of the table and of all chunks except the draw data, which verify_draw_data() checks. Takes a
  /// microsecond or two. Without it open() still proves that every later access is in range; only changed values inside
  /// their ranges go unnoticed.
  bool verify_hash = true;
};

/// A read-only view of a cooked asset. Owns nothing and allocates nothing: the bytes given to open() must stay
/// where they are, unchanged, for as long as the view or anything created from it is used.
class COIF_API Asset {
 public:
  /// Checks everything once: sizes, ranges, references, finite numbers, order. `bytes` starts at a multiple of 16,
  /// of 64 where textures are used. On failure the view is empty and the status says which check failed where.
  /// Never throws, never allocates; time is linear in the size. Source: formats/SPECIFICATION.md.
  LoadStatus open(std::span<const std::byte> bytes, const OpenOptions& options = {});

  /// Compares VERT, SKIN, INDX and TEXD with their hashes, 0.1 ms per MB, on any thread, such as the one that uploads
  /// them. The asset must be open. open() has proved that these values do no harm; this call finds out whether the
  /// picture is the cooked one.
  [[nodiscard]] LoadStatus verify_draw_data() const;

  [[nodiscard]] bool is_open() const { return header_ != nullptr; }
  /// minor() and total_bytes() are 0 before open() succeeded.
  [[nodiscard]] std::uint16_t minor() const { return is_open() ? header_->minor : std::uint16_t{0}; }
  [[nodiscard]] std::uint64_t total_bytes() const { return is_open() ? header_->total_bytes : 0; }

  /// The chunk table as stored, for tools that list sizes.
  [[nodiscard]] std::span<const ChunkEntry> chunks() const { return chunks_; }

  /// The record of a chunk that has only one; null where the chunk is absent.
  template <std::uint32_t kId>
  [[nodiscard]] const typename ChunkRecord<kId>::Type* record() const {
    constexpr std::size_t kRow = chunk_row(kId);
    return reinterpret_cast<const typename ChunkRecord<kId>::Type*>(data_[kRow]);
  }
  /// The records of a chunk that may have many; empty where the chunk is absent. The functions below say what they
  /// mean.
  template <std::uint32_t kId>
  [[nodiscard]] std::span<const typename ChunkRecord<kId>::Type> records() const {
    constexpr std::size_t kRow = chunk_row(kId);
    static_assert(kChunkLayouts[kRow].count == ChunkCount::kMany);
    return {record<kId>(), counts_[count_arrays(kRow)]};
  }

  /// Every open asset has one. Before open() succeeded it is a record without any bone, to match the empty lists.
  [[nodiscard]] const SkeletonRecord& skeleton() const {
    static constexpr SkeletonRecord kNoSkeleton{};
    const SkeletonRecord* const stored = record<chunk::kSkeleton>();
    return stored != nullptr ? *stored : kNoSkeleton;
  }
  [[nodiscard]] std::span<const BoneRecord> bones() const { return records<chunk::kBones>(); }
  /// Never null; empty where the asset has no names.
  [[nodiscard]] const char* bone_name(std::uint32_t bone) const;
  [[nodiscard]] std::span<const ChainRecord> chains() const { return records<chunk::kChains>(); }
  [[nodiscard]] std::span<const DynamicsRecord> dynamics() const { return records<chunk::kDynamics>(); }
  /// One per bone, or empty where dynamics() are the artist's own numbers.
  [[nodiscard]] std::span<const AskedRecord> asked() const { return records<chunk::kAsked>(); }
  /// One per bone, or empty where no bone has one.
  [[nodiscard]] std::span<const LimitRecord> limits() const { return records<chunk::kLimits>(); }
  /// Links between chains; empty where no chains are linked. Sorted by depth; a bone's own link comes before the links
  /// of bones that hang on it.
  [[nodiscard]] std::span<const LinkRecord> links() const { return records<chunk::kLinks>(); }
  [[nodiscard]] std::span<const ColliderRecord> colliders() const { return records<chunk::kColliders>(); }

  /// The body's bones that carry body_colliders(), at most kMaxBodyColliders. The host gives their poses.
  [[nodiscard]] std::span<const BodyBoneRecord> body_bones() const { return records<chunk::kBodyBones>(); }
  /// The name in the source. Never null; empty where there is no such body bone.
  [[nodiscard]] const char* body_bone_name(std::uint32_t body_bone) const;
  /// Like colliders(), in head space in the rest pose, except that `bone` is an index into body_bones().
  [[nodiscard]] std::span<const ColliderRecord> body_colliders() const { return records<chunk::kBodyColliders>(); }
  /// The body colliders that each of bones() may touch; bit i means body_colliders()[i]. Empty where there are none.
  [[nodiscard]] std::span<const std::uint32_t> body_sets() const { return records<chunk::kBodySets>(); }

  [[nodiscard]] std::span<const VertexRecord> vertices() const { return records<chunk::kVertices>(); }
  [[nodiscard]] std::span<const SkinRecord> skin() const { return records<chunk::kSkin>(); }
  [[nodiscard]] std::span<const std::uint32_t> indices() const { return records<chunk::kIndices>(); }
  [[nodiscard]] std::span<const PatchRecord> patches() const { return records<chunk::kPatches>(); }
  /// The stored levels of detail, finest first. Empty where there is only one level, which has all patches and
  /// simulates all bones. lod_count(), lod_patches() and lod_indices() count that level too.
  [[nodiscard]] std::span<const LodRecord> stored_lods() const { return records<chunk::kLods>(); }
  /// For each bone the number of levels, from the finest on, in which it is simulated; 0 for rigid bones. Empty where
  /// stored_lods() is.
  [[nodiscard]] std::span<const std::uint8_t> lod_bones() const { return records<chunk::kLodBones>(); }
  /// 0 without a mesh, 1 for a mesh without LODS.
  [[nodiscard]] std::uint32_t lod_count() const;
  /// The patches of one level, with or without LODS; empty where there is no such level.
  [[nodiscard]] std::span<const PatchRecord> lod_patches(std::uint32_t lod) const;
  [[nodiscard]] std::span<const std::uint32_t> lod_indices(std::uint32_t lod) const;

  /// Draw orders besides the stored one. Each lists a triangle number t at every position; its corners are indices()
  /// from 3 t on. A level's positions hold its own triangles, each once.
  [[nodiscard]] std::span<const std::uint32_t> orders() const { return records<chunk::kOrders>(); }
  /// The number of draw orders with the stored one, at most kMaxOrders; 0 without a mesh.
  [[nodiscard]] std::uint32_t order_count() const;
  /// The order for each of the kViewCells directions (coif/view_cells.h): 0 is the stored one, k the k-th of orders().
  /// Empty where there is only one order.
  [[nodiscard]] std::span<const std::uint8_t> order_views() const { return records<chunk::kOrderViews>(); }

  [[nodiscard]] const MaterialRecord* material() const { return record<chunk::kMaterial>(); }  ///< Null where absent.
  [[nodiscard]] std::span<const TextureRecord> textures() const { return records<chunk::kTextures>(); }
  /// Textures of the roles that is_relief() names: maps of how normals and strands lie on the surface.
  [[nodiscard]] std::span<const TextureRecord> reliefs() const { return records<chunk::kReliefs>(); }
  /// The texture among textures() and reliefs() that has this role; null where there is none.
  [[nodiscard]] const TextureRecord* texture(TextureRole role) const;
  /// Texels of one mip; `mip` below texture.mip_count.
  [[nodiscard]] std::span<const std::byte> texels(const TextureRecord& texture, std::uint32_t mip) const;

  /// Null where absent.
  [[nodiscard]] const ProvenanceRecord* provenance() const { return record<chunk::kProvenance>(); }
  /// Null where absent.
  [[nodiscard]] const TuningRecord* tuning() const { return record<chunk::kTuning>(); }
  [[nodiscard]] std::span<const QualityRecord> quality() const { return records<chunk::kQuality>(); }
  /// QualityRecord::worst_motion is an index into this list. Empty in assets that were cooked before names were stored.
  [[nodiscard]] std::span<const MotionNameRecord> motion_names() const { return records<chunk::kMotionNames>(); }

 private:
  LoadStatus read_chunk_into_view(const std::byte* file, const ChunkEntry& entry);

  const FileHeader* header_ = nullptr;
  std::span<const ChunkEntry> chunks_;
  const std::byte* data_[kChunkKinds] = {};             ///< Where each chunk begins, in the order of kChunkLayouts.
  std::size_t counts_[count_arrays(kChunkKinds)] = {};  ///< The number of records of each chunk that may have many.
};

}  // namespace coif
