#pragma once

#include <coif/asset_records.h>
#include <coif/export.h>
#include <coif/load_status.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

struct OpenOptions {
  /// Compare the hashes of the table and of all chunks but the draw data, for which verify_draw_data() is: a microsecond
  /// or two. Without it open() still proves that every later access is in range; only silent changes of values inside
  /// their ranges pass.
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

  /// Compares VERT, SKIN, INDX and TEXD with their hashes, 0.1 ms per MB; on any thread, such as the one that uploads
  /// them. open() has proved all of it harmless: this finds a picture that is not the one cooked. Of an open asset.
  [[nodiscard]] LoadStatus verify_draw_data() const;

  [[nodiscard]] bool is_open() const { return skeleton_ != nullptr; }
  [[nodiscard]] std::uint16_t minor() const { return header_->minor; }
  [[nodiscard]] std::uint64_t total_bytes() const { return header_->total_bytes; }

  /// The chunk table as stored, for tools that list sizes.
  [[nodiscard]] std::span<const ChunkEntry> chunks() const { return chunks_; }

  [[nodiscard]] const SkeletonRecord& skeleton() const { return *skeleton_; }
  [[nodiscard]] std::span<const BoneRecord> bones() const { return bones_; }
  /// Never null; empty where the asset has no names.
  [[nodiscard]] const char* bone_name(std::uint32_t bone) const;
  [[nodiscard]] std::span<const ChainRecord> chains() const { return chains_; }
  [[nodiscard]] std::span<const DynamicsRecord> dynamics() const { return dynamics_; }
  [[nodiscard]] std::span<const ColliderRecord> colliders() const { return colliders_; }

  [[nodiscard]] std::span<const VertexRecord> vertices() const { return vertices_; }
  [[nodiscard]] std::span<const SkinRecord> skin() const { return skin_; }
  [[nodiscard]] std::span<const std::uint32_t> indices() const { return indices_; }
  [[nodiscard]] std::span<const PatchRecord> patches() const { return patches_; }
  /// Levels of detail, finest first; empty where the asset has one level: all patches, all bones simulated.
  [[nodiscard]] std::span<const LodRecord> lods() const { return lods_; }
  /// In how many levels each bone is simulated, from the finest on; 0 for rigid bones. Empty where lods() is.
  [[nodiscard]] std::span<const std::uint8_t> lod_bones() const { return lod_bones_; }
  /// 0 without a mesh, 1 for a mesh without LODS.
  [[nodiscard]] std::uint32_t lod_count() const;
  /// What one level draws, with or without LODS; empty where there is no such level.
  [[nodiscard]] std::span<const PatchRecord> lod_patches(std::uint32_t lod) const;
  [[nodiscard]] std::span<const std::uint32_t> lod_indices(std::uint32_t lod) const;

  /// Draw orders besides the stored one: for each, at every position a triangle t, which is indices() from 3 t on. A
  /// level's positions hold its own triangles, each once.
  [[nodiscard]] std::span<const std::uint32_t> orders() const { return orders_; }
  /// With the stored one, at most kMaxOrders; 0 without a mesh.
  [[nodiscard]] std::uint32_t order_count() const;
  /// The order for each of the kViewCells directions (coif/view_cells.h): 0 the stored one, k the k-th of orders(). Empty
  /// where there is one order.
  [[nodiscard]] std::span<const std::uint8_t> order_views() const { return order_views_; }

  [[nodiscard]] const MaterialRecord* material() const { return material_; }  ///< Null where absent.
  [[nodiscard]] std::span<const TextureRecord> textures() const { return textures_; }
  /// Null where the asset has no texture of this role.
  [[nodiscard]] const TextureRecord* texture(TextureRole role) const;
  /// Texels of one mip; `mip` below texture.mip_count.
  [[nodiscard]] std::span<const std::byte> texels(const TextureRecord& texture, std::uint32_t mip) const;

  [[nodiscard]] const ProvenanceRecord* provenance() const { return provenance_; }  ///< Null where absent.
  [[nodiscard]] const TuningRecord* tuning() const { return tuning_; }              ///< Null where absent.
  [[nodiscard]] std::span<const QualityRecord> quality() const { return quality_; }

 private:
  LoadStatus read_chunk_into_view(const std::byte* file, const ChunkEntry& entry);
  [[nodiscard]] LoadStatus check_content() const;

  const FileHeader* header_ = nullptr;
  std::span<const ChunkEntry> chunks_;
  const SkeletonRecord* skeleton_ = nullptr;
  std::span<const BoneRecord> bones_;
  std::span<const char> names_;
  std::span<const ChainRecord> chains_;
  std::span<const DynamicsRecord> dynamics_;
  std::span<const ColliderRecord> colliders_;
  std::span<const VertexRecord> vertices_;
  std::span<const SkinRecord> skin_;
  std::span<const std::uint32_t> indices_;
  std::span<const PatchRecord> patches_;
  std::span<const LodRecord> lods_;
  std::span<const std::uint8_t> lod_bones_;
  std::span<const std::uint32_t> orders_;
  std::span<const std::uint8_t> order_views_;
  const MaterialRecord* material_ = nullptr;
  std::span<const TextureRecord> textures_;
  std::span<const std::byte> texels_;
  const ProvenanceRecord* provenance_ = nullptr;
  const TuningRecord* tuning_ = nullptr;
  std::span<const QualityRecord> quality_;
};

}  // namespace coif
