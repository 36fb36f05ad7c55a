#include "write/asset_writer.h"

#include "write/chunk_file.h"

#include <algorithm>
#include <span>

namespace coif {
namespace {

template <typename Record>
void add_chunk(std::vector<PendingChunk>& chunks, std::uint32_t id, const std::vector<Record>& records,
               std::uint32_t flags = 0) {
  if (!records.empty()) chunks.push_back({id, flags, std::as_bytes(std::span(records)), chunk_alignment(id)});
}

/// Joins the names and points each bone at its own.
std::vector<char> pack_names(std::vector<BoneRecord>& bones, const std::vector<std::string>& names) {
  std::vector<char> packed;
  for (std::size_t i = 0; i < bones.size(); ++i) {
    bones[i].name = kNone;
    if (i >= names.size() || names[i].empty()) continue;
    bones[i].name = std::uint32_t(packed.size());
    const std::size_t length = std::min(names[i].find('\0'), names[i].size());
    packed.insert(packed.end(), names[i].begin(), names[i].begin() + std::ptrdiff_t(length));
    packed.push_back(0);
  }
  return packed;
}

}  // namespace

std::vector<std::byte> write_asset(const AssetContents& contents) {
  std::vector<BoneRecord> bones = contents.bones;
  const std::vector<char> names = pack_names(bones, contents.bone_names);
  SkeletonRecord skeleton = contents.skeleton;
  skeleton.bone_count = std::uint32_t(bones.size());
  skeleton.chain_count = std::uint32_t(contents.chains.size());
  skeleton.simulated_count = std::uint32_t(
      std::ranges::count_if(bones, [](const BoneRecord& bone) { return bone.kind == BoneKind::kSimulated; }));

  std::vector<PendingChunk> chunks;
  chunks.push_back({chunk::kSkeleton, kChunkRequired, std::as_bytes(std::span(&skeleton, 1))});
  add_chunk(chunks, chunk::kBones, bones, kChunkRequired);
  add_chunk(chunks, chunk::kNames, names);
  add_chunk(chunks, chunk::kChains, contents.chains);
  add_chunk(chunks, chunk::kDynamics, contents.dynamics);
  add_chunk(chunks, chunk::kColliders, contents.colliders);
  add_chunk(chunks, chunk::kPatches, contents.patches);
  add_chunk(chunks, chunk::kLods, contents.lods);
  add_chunk(chunks, chunk::kLodBones, contents.lod_bones);
  add_chunk(chunks, chunk::kOrders, contents.orders);
  add_chunk(chunks, chunk::kOrderViews, contents.order_views);
  add_chunk(chunks, chunk::kMaterial, contents.material);
  add_chunk(chunks, chunk::kProvenance, contents.provenance);
  add_chunk(chunks, chunk::kTuning, contents.tuning);
  add_chunk(chunks, chunk::kQuality, contents.quality);
  add_chunk(chunks, chunk::kTextures, contents.textures);
  add_chunk(chunks, chunk::kVertices, contents.vertices);
  add_chunk(chunks, chunk::kSkin, contents.skin);
  add_chunk(chunks, chunk::kIndices, contents.indices);
  add_chunk(chunks, chunk::kTexels, contents.texels);
  return write_chunks(chunks);
}

}  // namespace coif
