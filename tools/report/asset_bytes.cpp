#include "report/asset_bytes.h"

#include <algorithm>

namespace coif {
namespace {

constexpr std::uint32_t kSimulated[] = {chunk::kSkeleton,  chunk::kBones,    chunk::kChains, chunk::kDynamics,
                                        chunk::kColliders, chunk::kLodBones, chunk::kTuning};
constexpr std::uint32_t kDrawn[] = {chunk::kVertices, chunk::kSkin,     chunk::kIndices,  chunk::kPatches,
                                    chunk::kLods,     chunk::kMaterial, chunk::kTextures, chunk::kTexels};

ChunkUse use_of(std::uint32_t id) {
  if (std::ranges::find(kSimulated, id) != std::end(kSimulated)) return ChunkUse::kSimulation;
  return std::ranges::find(kDrawn, id) != std::end(kDrawn) ? ChunkUse::kDrawing : ChunkUse::kTools;
}

/// Four letters; anything else in an id of a newer format becomes a question mark.
std::string text_of(std::uint32_t id) {
  std::string text;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    const char letter = char(id >> shift & 0xFF);
    text += letter >= 0x20 && letter < 0x7F ? letter : '?';
  }
  return text;
}

}  // namespace

AssetBytes asset_bytes(const Asset& asset) {
  AssetBytes bytes{asset.total_bytes(), {}, asset.total_bytes()};
  for (const ChunkEntry& entry : asset.chunks()) {
    bytes.chunks.push_back({text_of(entry.id), entry.bytes, use_of(entry.id)});
    bytes.framing -= entry.bytes;
  }
  return bytes;
}

}  // namespace coif
