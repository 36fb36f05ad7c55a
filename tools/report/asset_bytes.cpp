#include "report/asset_bytes.h"

#include "write/chunk_file.h"

#include <algorithm>
#include <iterator>

namespace coif {
namespace {

struct KnownChunk {
  std::uint32_t id;
  ChunkUse use;
  const char* what;
};

constexpr KnownChunk kKnown[] = {
    {chunk::kSkeleton, ChunkUse::kSimulation, "counts, head bone"},
    {chunk::kBones, ChunkUse::kSimulation, "bones"},
    {chunk::kNames, ChunkUse::kTools, "names of bones"},
    {chunk::kChains, ChunkUse::kSimulation, "chains"},
    {chunk::kDynamics, ChunkUse::kSimulation, "how each bone moves"},
    {chunk::kColliders, ChunkUse::kSimulation, "colliders"},
    {chunk::kVertices, ChunkUse::kDrawing, "vertices"},
    {chunk::kSkin, ChunkUse::kDrawing, "bones of each vertex"},
    {chunk::kIndices, ChunkUse::kDrawing, "triangles of all levels of detail"},
    {chunk::kPatches, ChunkUse::kDrawing, "patches in draw order"},
    {chunk::kLods, ChunkUse::kDrawing, "levels of detail"},
    {chunk::kLodBones, ChunkUse::kSimulation, "bones of each level"},
    {chunk::kOrders, ChunkUse::kDrawing, "further draw orders"},
    {chunk::kOrderViews, ChunkUse::kDrawing, "which order for which direction"},
    {chunk::kMaterial, ChunkUse::kDrawing, "material"},
    {chunk::kTextures, ChunkUse::kDrawing, "sizes of textures"},
    {chunk::kTexels, ChunkUse::kDrawing, "texels"},
    {chunk::kProvenance, ChunkUse::kTools, "what it was cooked from"},
    {chunk::kTuning, ChunkUse::kSimulation, "sub-steps asked for"},
    {chunk::kQuality, ChunkUse::kTools, "what they were chosen from"},
};

KnownChunk find_chunk(std::uint32_t id) {
  const auto* const found = std::ranges::find(kKnown, id, &KnownChunk::id);
  return found != std::end(kKnown) ? *found : KnownChunk{id, ChunkUse::kTools, ""};
}

}  // namespace

AssetBytes asset_bytes(const Asset& asset) {
  AssetBytes bytes{asset.total_bytes(), {}, asset.total_bytes()};
  for (const ChunkEntry& entry : asset.chunks()) {
    const KnownChunk known = find_chunk(entry.id);
    bytes.chunks.push_back({chunk_name(entry.id), known.what, entry.bytes, known.use});
    bytes.framing -= entry.bytes;
  }
  return bytes;
}

}  // namespace coif
