#include "chunk_checks.h"
#include "number_checks.h"

namespace coif {
namespace {

// Meshes have thousands of records, and nearly always all are good. So each record's faults are one word without a branch,
// all words together are looked at once, and only a mesh that has a fault is searched for its place.

/// Unit within 5 %: rounding to 16 bits is far below, a zero or garbage vector far above.
bool is_unit_snorm(const std::int16_t (&v)[4]) {
  constexpr std::uint32_t kOne = 32767u * 32767u, kLow = kOne / 100 * 90, kHigh = kOne / 100 * 110;
  const int x = v[0], y = v[1], z = v[2];
  const std::uint32_t square = std::uint32_t(x * x) + std::uint32_t(y * y) + std::uint32_t(z * z);
  return square - kLow <= kHigh - kLow;
}

std::uint32_t faults(const VertexRecord& v) {
  const std::uint32_t beyond = beyond_limit(v.position[0]) | beyond_limit(v.position[1]) | beyond_limit(v.position[2]) |
                               beyond_limit(v.uv[0]) | beyond_limit(v.uv[1]);
  const bool negative = v.normal[3] < 0 || v.tangent[3] < 0;
  return beyond >> 31 | std::uint32_t(!is_unit_snorm(v.normal)) | std::uint32_t(!is_unit_snorm(v.tangent)) |
         std::uint32_t(negative);
}

LoadStatus check_vertices(std::span<const VertexRecord> vertices) {
  std::uint32_t found = 0;
  for (const VertexRecord& vertex : vertices) found |= faults(vertex);
  if (found == 0) return {};
  std::size_t i = 0;
  while (faults(vertices[i]) == 0) ++i;
  return {LoadCode::kNotFinite, chunk::kVertices, i};
}

std::uint32_t weight_sum(const SkinRecord& s) {
  return std::uint32_t(s.weight[0] + s.weight[1] + s.weight[2] + s.weight[3]);
}

std::uint32_t faults(const SkinRecord& s, std::uint32_t bones) {
  const bool reach = s.bone[0] >= bones || s.bone[1] >= bones || s.bone[2] >= bones || s.bone[3] >= bones;
  return std::uint32_t(reach) | (weight_sum(s) ^ 255u);
}

LoadStatus skin_error(const SkinRecord& skin, std::size_t i, std::uint32_t bones) {
  for (const std::uint16_t bone : skin.bone) {
    if (bone >= bones) return {LoadCode::kReference, chunk::kSkin, i, bones, bone};
  }
  return {LoadCode::kWeightSum, chunk::kSkin, i, 255, weight_sum(skin)};
}

LoadStatus check_skin(const Asset& asset) {
  const auto skin = asset.skin();
  if (skin.empty()) return {};  // rigid hair
  if (skin.size() != asset.vertices().size()) {
    return {LoadCode::kChunkSize, chunk::kSkin, 0, asset.vertices().size(), skin.size()};
  }
  const auto bones = std::uint32_t(asset.bones().size());  // at most kMaxBones: check_skeleton()
  std::uint32_t found = 0;
  for (const SkinRecord& record : skin) found |= faults(record, bones);
  if (found == 0) return {};
  std::size_t i = 0;
  while (faults(skin[i], bones) == 0) ++i;
  return skin_error(skin[i], i, bones);
}

LoadStatus check_indices(const Asset& asset) {
  const auto indices = asset.indices();
  const std::size_t count = asset.vertices().size();
  if (indices.size() % 3 != 0) return {LoadCode::kChunkSize, chunk::kIndices, 0, 0, indices.size() % 3};
  const std::uint32_t limit = count < kNone ? std::uint32_t(count) : kNone;
  std::uint32_t found = 0;
  for (const std::uint32_t index : indices) found |= index >= limit ? 1u : 0u;
  if (found == 0) return {};
  std::size_t i = 0;
  while (indices[i] < limit) ++i;
  return {LoadCode::kReference, chunk::kIndices, i, count, indices[i]};
}

LoadStatus check_patches(const Asset& asset) {
  const std::uint64_t total = asset.indices().size();
  std::uint64_t next = 0;
  for (std::size_t i = 0; i < asset.patches().size(); ++i) {
    const PatchRecord& patch = asset.patches()[i];
    const auto fail = [&](LoadCode code, std::uint64_t expected = 0, std::uint64_t found = 0) {
      return LoadStatus{code, chunk::kPatches, i, expected, found};
    };
    if (patch.first_index != next) return fail(LoadCode::kPatchCover, next, patch.first_index);
    if (patch.index_count == 0 || patch.index_count % 3 != 0 || patch.index_count > total - next) {
      return fail(LoadCode::kPatchCover, total - next, patch.index_count);
    }
    if (!in_range(patch.head_distance, 0.0f, kMaxCoordinate)) return fail(LoadCode::kNotFinite);
    if (patch.bone >= asset.bones().size()) return fail(LoadCode::kReference, asset.bones().size(), patch.bone);
    next += patch.index_count;
  }
  if (next != total) return {LoadCode::kPatchCover, chunk::kPatches, asset.patches().size(), total, next};
  return {};
}

}  // namespace

LoadStatus check_mesh(const Asset& asset) {
  if (asset.vertices().empty()) {
    // A skeleton alone is a complete asset; half a mesh is not.
    if (!asset.skin().empty()) return {LoadCode::kChunkMissing, chunk::kVertices};
    if (!asset.indices().empty()) return {LoadCode::kChunkMissing, chunk::kVertices};
    if (!asset.patches().empty()) return {LoadCode::kChunkMissing, chunk::kVertices};
    return {};
  }
  if (asset.indices().empty()) return {LoadCode::kChunkMissing, chunk::kIndices};
  if (asset.patches().empty()) return {LoadCode::kChunkMissing, chunk::kPatches};
  if (const LoadStatus status = check_vertices(asset.vertices()); !status) return status;
  if (const LoadStatus status = check_skin(asset); !status) return status;
  if (const LoadStatus status = check_indices(asset); !status) return status;
  return check_patches(asset);
}

}  // namespace coif
