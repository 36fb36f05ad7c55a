#include "chunk_checks.h"

#include <coif/shading_models.h>

#include <bit>

namespace coif {
namespace {

constexpr std::uint32_t kMaxTextureSize = 16384;
constexpr float kMaxColor = 1.0e3f;

bool format_fits(const TextureRecord& t) {
  switch (t.role) {
    case TextureRole::kBaseColor:
      return t.format == TexelFormat::kSrgb8Alpha8 || t.format == TexelFormat::kSrgb8Alpha8Etc2;
    case TextureRole::kShiftMask:
    case TextureRole::kNormal:
    case TextureRole::kStrandAxis: return t.format == TexelFormat::kRg8 || t.format == TexelFormat::kRg11Eac;
  }
  return false;
}

bool dimensions_fit(const TextureRecord& t) {
  if (t.width == 0 || t.height == 0 || t.width > kMaxTextureSize || t.height > kMaxTextureSize) return false;
  const std::uint32_t largest = t.width > t.height ? t.width : t.height;
  return t.mip_count >= 1 && t.mip_count <= std::uint32_t(std::bit_width(largest));
}

std::uint64_t all_mip_bytes(const TextureRecord& t) {
  std::uint64_t bytes = 0;
  for (std::uint32_t mip = 0; mip < t.mip_count; ++mip) bytes += mip_bytes(t.format, t.width, t.height, mip);
  return bytes;
}

}  // namespace

LoadStatus check_material(const Asset& asset) {
  const MaterialRecord* m = asset.material();
  if (m == nullptr) return {};
  if ((m->flags & ~kMaterialFlags) != 0) return {LoadCode::kReserved, chunk::kMaterial};
  if (static_cast<std::uint32_t>(m->shading) >= kShadingModelCount) return {LoadCode::kEnumerator, chunk::kMaterial};
  const bool good =
      all_in_range(m->base_color, 0.0f, kMaxColor) && all_in_range(m->ambient, 0.0f, kMaxColor) &&
      all_in_range(m->primary_color, 0.0f, kMaxColor) && all_in_range(m->secondary_color, 0.0f, kMaxColor) &&
      in_range(m->primary_exponent, 1.0e-3f, kMaxCoordinate) &&
      in_range(m->secondary_exponent, 1.0e-3f, kMaxCoordinate) && in_range(m->primary_shift, -10.0f, 10.0f) &&
      in_range(m->secondary_shift, -10.0f, 10.0f) && in_range(m->opaque_threshold, 0.0f, 1.0f) &&
      in_range(m->discard_threshold, 0.0f, 1.0f) && is_shading_valid(*m);
  return good ? LoadStatus{} : LoadStatus{LoadCode::kNotFinite, chunk::kMaterial};
}

namespace {

/// One of the two chunks of texture records, and how many bytes of texels it has.
struct TextureChunk {
  std::uint32_t id;
  std::span<const TextureRecord> records;
  std::size_t texel_bytes;
  bool is_relief;
};

LoadStatus check_chunk(const TextureChunk& chunk) {
  std::uint32_t roles_seen = 0;
  for (std::size_t i = 0; i < chunk.records.size(); ++i) {
    const TextureRecord& t = chunk.records[i];
    const auto fail = [&](LoadCode code, std::uint64_t expected = 0, std::uint64_t found = 0) {
      return LoadStatus{code, chunk.id, i, expected, found};
    };
    if (t.reserved != 0) return fail(LoadCode::kReserved);
    if (!format_fits(t) || is_relief(t.role) != chunk.is_relief) return fail(LoadCode::kEnumerator);
    if ((roles_seen & 1u << unsigned(t.role)) != 0) return fail(LoadCode::kChunkDuplicate);
    roles_seen |= 1u << unsigned(t.role);
    if (!dimensions_fit(t)) return fail(LoadCode::kNotFinite);
    if (t.bytes != all_mip_bytes(t)) return fail(LoadCode::kChunkSize, all_mip_bytes(t), t.bytes);
    const std::uint64_t room = t.offset < chunk.texel_bytes ? chunk.texel_bytes - t.offset : 0;
    if (t.bytes > room || t.offset % 16 != 0) {
      return fail(LoadCode::kReference, chunk.texel_bytes, t.offset);
    }
  }
  return {};
}

}  // namespace

LoadStatus check_textures(const Asset& asset) {
  const LoadStatus status =
      check_chunk({chunk::kTextures, asset.textures(), asset.records<chunk::kTexels>().size(), false});
  if (!status) return status;
  return check_chunk({chunk::kReliefs, asset.reliefs(), asset.records<chunk::kReliefTexels>().size(), true});
}

LoadStatus check_provenance(const Asset& asset) {
  const ProvenanceRecord* p = asset.provenance();
  if (p != nullptr && (p->flags & ~kProvenanceDraft) != 0) return {LoadCode::kReserved, chunk::kProvenance};
  return {};
}

}  // namespace coif
