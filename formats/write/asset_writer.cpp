#include "write/asset_writer.h"

#include "payload_hash.h"

#include <algorithm>
#include <cstring>
#include <span>

namespace coif {
namespace {

struct PendingChunk {
  std::uint32_t id;
  std::uint32_t flags;
  std::span<const std::byte> bytes;
};

std::size_t round_up(std::size_t value, std::size_t alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

template <typename Record>
void add_chunk(std::vector<PendingChunk>& chunks, std::uint32_t id, const std::vector<Record>& records,
               std::uint32_t flags = 0) {
  if (!records.empty()) chunks.push_back({id, flags, std::as_bytes(std::span(records))});
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

/// The table of chunks with their places in the file.
std::vector<ChunkEntry> lay_out(std::span<const PendingChunk> chunks) {
  std::vector<ChunkEntry> table;
  std::size_t end = sizeof(FileHeader) + chunks.size() * sizeof(ChunkEntry);
  for (const PendingChunk& chunk : chunks) {
    const std::size_t offset = round_up(end, chunk.id == chunk::kTexels ? 64 : 16);
    table.push_back({chunk.id, chunk.flags, offset, chunk.bytes.size(), xxh64(chunk.bytes)});
    end = offset + chunk.bytes.size();
  }
  return table;
}

std::vector<std::byte> assemble(std::span<const PendingChunk> chunks) {
  const std::vector<ChunkEntry> table = lay_out(chunks);
  std::vector<std::byte> file(table.empty() ? sizeof(FileHeader) : table.back().offset + table.back().bytes);
  FileHeader header{};
  std::memcpy(header.magic, kAssetMagic, sizeof header.magic);
  header.major = kAssetMajor;
  header.minor = kAssetMinor;
  header.chunk_count = std::uint32_t(table.size());
  header.total_bytes = file.size();
  std::memcpy(file.data(), &header, sizeof header);
  std::memcpy(file.data() + sizeof header, table.data(), table.size() * sizeof(ChunkEntry));
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    std::memcpy(file.data() + table[i].offset, chunks[i].bytes.data(), chunks[i].bytes.size());
  }
  header.table_hash = table_hash(file, header.chunk_count);
  std::memcpy(file.data(), &header, sizeof header);
  return file;
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
  add_chunk(chunks, chunk::kMaterial, contents.material);
  add_chunk(chunks, chunk::kProvenance, contents.provenance);
  add_chunk(chunks, chunk::kTuning, contents.tuning);
  add_chunk(chunks, chunk::kQuality, contents.quality);
  add_chunk(chunks, chunk::kTextures, contents.textures);
  add_chunk(chunks, chunk::kVertices, contents.vertices);
  add_chunk(chunks, chunk::kSkin, contents.skin);
  add_chunk(chunks, chunk::kIndices, contents.indices);
  add_chunk(chunks, chunk::kTexels, contents.texels);
  return assemble(chunks);
}

}  // namespace coif
