#pragma once
// The file around the records: header, table of chunks, and one list of all kinds of chunk. All code that treats chunks
// alike reads that list: ids, the reader's bounds, alignment and needs, the views of an Asset, the writer's order,
// `coif strip`, reports, and the test of formats/SPECIFICATION.md. A new chunk takes a record (coif/asset_records.h), a
// row here, an accessor with its meaning (coif/asset.h), a check of its content (formats/check_*.cpp), its place in the
// specification, and a pass of the cook that fills AssetContents.

#include <coif/asset_records.h>

#include <cstddef>
#include <cstdint>

namespace coif {

inline constexpr std::uint8_t kAssetMagic[8] = {0x89, 'C', 'O', 'I', 'F', '\r', '\n', 0x1A};
inline constexpr std::uint16_t kAssetMajor = 1;
inline constexpr std::uint16_t kAssetMinor = 0;
inline constexpr std::uint32_t kMaxChunks = 64;

/// A reader that does not know a chunk with this flag must refuse the file.
inline constexpr std::uint32_t kChunkRequired = 1u << 0;

struct FileHeader {
  std::uint8_t magic[8];
  std::uint16_t major;
  std::uint16_t minor;
  std::uint32_t chunk_count;
  std::uint64_t total_bytes;  ///< The length of the whole file, header included.
  /// XXH64 of the chunk table, seeded with the XXH64 (seed 0) of the header's first 24 bytes. The table holds the
  /// hashes of the chunks, and the bytes between chunks are zero, so every byte of the file is covered.
  std::uint64_t table_hash;
};
static_assert(sizeof(FileHeader) == 32);

/// The table follows the header directly, sorted by offset.
struct ChunkEntry {
  std::uint32_t id;
  std::uint32_t flags;
  std::uint64_t offset;  ///< From the file's first byte; a multiple of 16, of 64 for TEXD.
  std::uint64_t bytes;
  std::uint64_t hash;  ///< XXH64 (seed 0) of the chunk's bytes.
};
static_assert(sizeof(ChunkEntry) == 32);

// clang-format off
/// A row for each chunk: its constant in namespace chunk, its id, the record, how many of them, the name that tools and
/// writers know it by (AssetContents), the alignment of its place in bytes, who reads it, what it needs, the words of
/// `coif strip` that stand for it with others, and what it holds, for people. The last two are for tools: no program that
/// only reads assets holds them. Draw data is stored behind everything else, the rest in the order of the rows.
#define COIF_CHUNKS(ROW)                                                                                                 \
  ROW(kSkeleton, "SKEL", SkeletonRecord, kOne, skeleton, 16, kSimulation, always_there(),                                \
      "", "counts, head bone")                                                                                           \
  ROW(kBones, "BONE", BoneRecord, kMany, bones, 16, kSimulation, always_there(),                                         \
      "", "bones")                                                                                                       \
  ROW(kNames, "NAME", char, kMany, names, 16, kTools, needs_nothing(),                                                   \
      "names", "names of bones")                                                                                         \
  ROW(kChains, "CHAN", ChainRecord, kMany, chains, 16, kSimulation, idle_without(chunk::kDynamics),                      \
      "motion", "chains")                                                                                                \
  ROW(kDynamics, "DYNA", DynamicsRecord, kMany, dynamics, 16, kSimulation, idle_without(chunk::kChains),                 \
      "motion", "how each bone moves")                                                                                   \
  ROW(kAsked, "ASKD", AskedRecord, kMany, asked, 16, kSimulation, idle_without(chunk::kDynamics),                        \
      "asked motion", "how each bone moves by the artist's own numbers")                                                 \
  ROW(kLimits, "LIMT", LimitRecord, kMany, limits, 16, kSimulation, idle_without(chunk::kDynamics),                      \
      "limits motion", "which directions each bone may have")                                                            \
  ROW(kLinks, "LINK", LinkRecord, kMany, links, 16, kSimulation, idle_without(chunk::kDynamics),                         \
      "links motion", "which bones of neighbouring chains stay together")                                                \
  ROW(kColliders, "COLL", ColliderRecord, kMany, colliders, 16, kSimulation, needs_nothing(),                            \
      "colliders motion", "colliders")                                                                                   \
  ROW(kBodyBones, "BODB", BodyBoneRecord, kMany, body_bones, 16, kSimulation,                                            \
      refused_without(chunk::kNames, chunk::kBodyColliders),                                                             \
      "body colliders motion", "bones of the body that carry colliders")                                                 \
  ROW(kBodyColliders, "BODC", ColliderRecord, kMany, body_colliders, 16, kSimulation,                                    \
      refused_without(chunk::kBodyBones, chunk::kBodySets),                                                              \
      "body colliders motion", "colliders on bones of the body")                                                         \
  ROW(kBodySets, "BODS", std::uint32_t, kMany, body_sets, 16, kSimulation, refused_without(chunk::kBodyColliders),       \
      "body colliders motion", "which of them each bone may touch")                                                      \
  ROW(kVertices, "VERT", VertexRecord, kMany, vertices, 16, kDrawData, refused_without(chunk::kIndices, chunk::kPatches), \
      "mesh", "vertices")                                                                                                \
  ROW(kSkin, "SKIN", SkinRecord, kMany, skin, 16, kDrawData, refused_without(chunk::kVertices),                          \
      "mesh", "bones of each vertex")                                                                                    \
  ROW(kIndices, "INDX", std::uint32_t, kMany, indices, 16, kDrawData, refused_without(chunk::kVertices),                 \
      "mesh", "triangles of all levels of detail")                                                                       \
  ROW(kPatches, "PTCH", PatchRecord, kMany, patches, 16, kDrawing, refused_without(chunk::kVertices),                    \
      "mesh", "patches in draw order")                                                                                   \
  ROW(kLods, "LODS", LodRecord, kMany, lods, 16, kDrawing, refused_without(chunk::kLodBones, chunk::kPatches),           \
      "lods mesh", "levels of detail")                                                                                   \
  ROW(kLodBones, "LODB", std::uint8_t, kMany, lod_bones, 16, kSimulation, refused_without(chunk::kLods),                 \
      "lods mesh", "bones of each level")                                                                                \
  ROW(kOrders, "ORDR", std::uint32_t, kMany, orders, 16, kDrawing, refused_without(chunk::kOrderViews, chunk::kIndices), \
      "orders mesh", "further draw orders")                                                                              \
  ROW(kOrderViews, "VIEW", std::uint8_t, kMany, order_views, 16, kDrawing, refused_without(chunk::kOrders),              \
      "orders mesh", "which order for which direction")                                                                  \
  ROW(kMaterial, "MATL", MaterialRecord, kOne, material, 16, kDrawing, needs_nothing(),                                  \
      "material mesh", "material")                                                                                       \
  ROW(kProvenance, "PROV", ProvenanceRecord, kOne, provenance, 16, kTools, needs_nothing(),                              \
      "provenance", "what it was cooked from")                                                                           \
  ROW(kTuning, "TUNE", TuningRecord, kOne, tuning, 16, kSimulation, idle_without(chunk::kDynamics),                      \
      "tuning motion", "sub-steps asked for")                                                                            \
  ROW(kQuality, "QUAL", QualityRecord, kMany, quality, 16, kTools, idle_without(chunk::kDynamics),                       \
      "quality tuning motion", "what they were chosen from")                                                             \
  ROW(kMotionNames, "MOTN", MotionNameRecord, kMany, motion_names, 16, kTools, idle_without(chunk::kQuality),            \
      "quality tuning motion", "names of the motions that were tried")                                                   \
  ROW(kTextures, "TEXR", TextureRecord, kMany, textures, 16, kDrawing, idle_without(chunk::kTexels),                     \
      "textures mesh", "sizes of textures")                                                                              \
  ROW(kTexels, "TEXD", std::byte, kMany, texels, 64, kDrawData, idle_without(chunk::kTextures),                          \
      "textures mesh", "texels")                                                                                         \
  ROW(kReliefs, "RELR", TextureRecord, kMany, reliefs, 16, kDrawing, idle_without(chunk::kReliefTexels),                 \
      "relief textures mesh", "sizes of maps of normals and strands")                                                    \
  ROW(kReliefTexels, "RELD", std::byte, kMany, relief_texels, 64, kDrawData, idle_without(chunk::kReliefs),              \
      "relief textures mesh", "texels of these maps")
// clang-format on

constexpr std::uint32_t chunk_id(const char (&text)[5]) {
  return std::uint32_t(std::uint8_t(text[0])) | std::uint32_t(std::uint8_t(text[1])) << 8 |
         std::uint32_t(std::uint8_t(text[2])) << 16 | std::uint32_t(std::uint8_t(text[3])) << 24;
}

namespace chunk {
#define COIF_ID(constant, id, ...) inline constexpr std::uint32_t constant = chunk_id(id);
COIF_CHUNKS(COIF_ID)
#undef COIF_ID
}  // namespace chunk

/// The record that a chunk is made of, as ChunkRecord<chunk::kBones>::Type.
template <std::uint32_t kId>
struct ChunkRecord;
#define COIF_RECORD(constant, id, Record, ...) \
  template <>                                  \
  struct ChunkRecord<chunk::constant> {        \
    using Type = Record;                       \
  };
COIF_CHUNKS(COIF_RECORD)
#undef COIF_RECORD

enum class ChunkCount : std::uint8_t { kOne, kMany };

/// Who uses a chunk, and so how long it has to stay in memory.
enum class ChunkUse : std::uint8_t {
  kSimulation,  ///< Stays as long as the hair is simulated.
  kDrawing,     ///< May go once the mesh is on the graphics card.
  /// As kDrawing. These chunks are nearly all bytes of an asset. Values in range do no harm, so their hashes may be
  /// compared later (Asset::verify_draw_data()).
  kDrawData,
  kTools,  ///< A game never reads it.
};

/// Whether a chunk may be absent, and what happens to it without other chunks.
struct ChunkNeeds {
  enum class Presence : std::uint8_t {
    kAlways,    ///< Every asset has it.
    kOptional,  ///< It needs no other.
    /// It means nothing without `ids`: a strip that removes those removes it too, but a file opens with it.
    kIdleWithout,
    kRefusedWithout,  ///< A file that has it but not `ids` is refused.
  };
  Presence presence;
  std::uint32_t ids[2] = {0, 0};  ///< 0: no other.
};

constexpr ChunkNeeds always_there() { return {ChunkNeeds::Presence::kAlways}; }
constexpr ChunkNeeds needs_nothing() { return {ChunkNeeds::Presence::kOptional}; }
constexpr ChunkNeeds idle_without(std::uint32_t id) { return {ChunkNeeds::Presence::kIdleWithout, {id, 0}}; }
constexpr ChunkNeeds refused_without(std::uint32_t id, std::uint32_t other = 0) {
  return {ChunkNeeds::Presence::kRefusedWithout, {id, other}};
}

/// A row in the form that the reader uses.
struct ChunkLayout {
  std::uint32_t id;
  std::uint16_t record_bytes;
  std::uint16_t alignment;  ///< Its offset in the file is a multiple of this, bytes.
  ChunkCount count;
  ChunkUse use;
  ChunkNeeds needs;
};

inline constexpr ChunkLayout kChunkLayouts[] = {
#define COIF_LAYOUT(constant, id, Record, count, name, alignment, use, needs, ...) \
  {chunk::constant, sizeof(Record), alignment, ChunkCount::count, ChunkUse::use, needs},
    COIF_CHUNKS(COIF_LAYOUT)
#undef COIF_LAYOUT
};
inline constexpr std::size_t kChunkKinds = sizeof kChunkLayouts / sizeof kChunkLayouts[0];

/// How many chunks of the first `rows` rows may have many records.
constexpr std::size_t count_arrays(std::size_t rows) {
  std::size_t count = 0;
  for (std::size_t row = 0; row < rows; ++row) count += kChunkLayouts[row].count == ChunkCount::kMany ? 1 : 0;
  return count;
}

/// The chunk's row in kChunkLayouts; kChunkKinds for a chunk that this version does not know.
constexpr std::size_t chunk_row(std::uint32_t id) {
  std::size_t row = 0;
  while (row < kChunkKinds && kChunkLayouts[row].id != id) ++row;
  return row;
}

/// The alignment that the format demands of a chunk's offset, bytes.
constexpr std::size_t chunk_alignment(std::uint32_t id) {
  const std::size_t row = chunk_row(id);
  return row < kChunkKinds ? kChunkLayouts[row].alignment : 16;
}

constexpr bool is_draw_data(std::uint32_t id) {
  const std::size_t row = chunk_row(id);
  return row < kChunkKinds && kChunkLayouts[row].use == ChunkUse::kDrawData;
}

/// True for a chunk that every asset must have.
constexpr bool is_needed_chunk(std::uint32_t id) {
  const std::size_t row = chunk_row(id);
  return row < kChunkKinds && kChunkLayouts[row].needs.presence == ChunkNeeds::Presence::kAlways;
}

}  // namespace coif
