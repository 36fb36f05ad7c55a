#pragma once
// For tools only. A game never links this.

#include <coif/asset_records.h>

#include <cstddef>
#include <string>
#include <vector>

namespace coif {

/// Everything a .coif can hold, in editable form. An empty array leaves its chunk out.
struct AssetContents {
  SkeletonRecord skeleton{};  ///< Counts are filled by write_asset().
  std::vector<BoneRecord> bones;
  std::vector<std::string> bone_names;  ///< One per bone, or empty; sets BoneRecord::name.
  std::vector<ChainRecord> chains;
  std::vector<DynamicsRecord> dynamics;
  std::vector<ColliderRecord> colliders;
  std::vector<VertexRecord> vertices;
  std::vector<SkinRecord> skin;
  std::vector<std::uint32_t> indices;
  std::vector<PatchRecord> patches;
  std::vector<LodRecord> lods;            ///< Empty: one level.
  std::vector<std::uint8_t> lod_bones;    ///< One per bone, or empty where `lods` is.
  std::vector<std::uint32_t> orders;      ///< Draw orders besides that of `indices`, each of all triangles.
  std::vector<std::uint8_t> order_views;  ///< kViewCells, or empty where `orders` is.
  std::vector<MaterialRecord> material;   ///< None or one.
  std::vector<TextureRecord> textures;    ///< Offsets and bytes refer to `texels`.
  std::vector<std::byte> texels;
  std::vector<ProvenanceRecord> provenance;  ///< None or one.
  std::vector<TuningRecord> tuning;          ///< None or one.
  std::vector<QualityRecord> quality;
};

/// The file's bytes. Deterministic: equal contents give equal bytes. Contents that the reader would refuse are
/// the caller's bug; open the result to find out.
[[nodiscard]] std::vector<std::byte> write_asset(const AssetContents& contents);

}  // namespace coif
