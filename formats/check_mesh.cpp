#include "chunk_checks.h"
#include "number_checks.h"

namespace coif {
namespace {

/// Unit within 5 %: rounding to 16 bits is far below, a zero or garbage vector far above.
bool is_unit_snorm(const std::int16_t (&v)[4]) {
  const std::int64_t square = std::int64_t(v[0]) * v[0] + std::int64_t(v[1]) * v[1] + std::int64_t(v[2]) * v[2];
  constexpr std::int64_t kOne = std::int64_t(32767) * 32767;
  return square >= kOne / 100 * 90 && square <= kOne / 100 * 110;
}

LoadStatus check_vertices(std::span<const VertexRecord> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const VertexRecord& v = vertices[i];
    if (v.normal[3] != 0) return {LoadCode::kReserved, chunk::kVertices, i};
    const bool good = all_finite(v.position) && all_finite(v.uv) && is_unit_snorm(v.normal) &&
                      is_unit_snorm(v.tangent) && v.tangent[3] >= 0;
    if (!good) return {LoadCode::kNotFinite, chunk::kVertices, i};
  }
  return {};
}

LoadStatus check_skin(const Asset& asset) {
  const auto skin = asset.skin();
  if (skin.size() != asset.vertices().size()) {
    return {LoadCode::kChunkSize, chunk::kSkin, 0, asset.vertices().size(), skin.size()};
  }
  for (std::size_t i = 0; i < skin.size(); ++i) {
    unsigned sum = 0;
    for (int k = 0; k < 4; ++k) {
      sum += skin[i].weight[k];
      if (skin[i].bone[k] >= asset.bones().size()) {
        return {LoadCode::kReference, chunk::kSkin, i, asset.bones().size(), skin[i].bone[k]};
      }
    }
    if (sum != 255) return {LoadCode::kWeightSum, chunk::kSkin, i, 255, sum};
  }
  return {};
}

LoadStatus check_indices(const Asset& asset) {
  const auto indices = asset.indices();
  if (indices.size() % 3 != 0) return {LoadCode::kChunkSize, chunk::kIndices, 0, 0, indices.size() % 3};
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= asset.vertices().size()) {
      return {LoadCode::kReference, chunk::kIndices, i, asset.vertices().size(), indices[i]};
    }
  }
  return {};
}

/// Each level of detail has an order of its own. check_lods() has proved that the levels are contiguous.
class LevelStarts {
 public:
  explicit LevelStarts(std::span<const LodRecord> lods) : lods_(lods) {}

  /// For patches asked for in ascending order.
  bool is_start(std::size_t patch) {
    if (next_ == lods_.size() || lods_[next_].first_patch != patch) return false;
    ++next_;
    return true;
  }

 private:
  std::span<const LodRecord> lods_;
  std::size_t next_ = 0;
};

LoadStatus check_patches(const Asset& asset) {
  LevelStarts levels(asset.lods());
  const std::uint64_t total = asset.indices().size();
  std::uint64_t next = 0;
  float distance = 0;
  for (std::size_t i = 0; i < asset.patches().size(); ++i) {
    const PatchRecord& patch = asset.patches()[i];
    if (levels.is_start(i)) distance = 0;
    const auto fail = [&](LoadCode code, std::uint64_t expected = 0, std::uint64_t found = 0) {
      return LoadStatus{code, chunk::kPatches, i, expected, found};
    };
    if (patch.first_index != next) return fail(LoadCode::kPatchCover, next, patch.first_index);
    if (patch.index_count == 0 || patch.index_count % 3 != 0 || patch.index_count > total - next) {
      return fail(LoadCode::kPatchCover, total - next, patch.index_count);
    }
    if (!in_range(patch.head_distance, distance, kMaxCoordinate)) return fail(LoadCode::kNotFinite);
    if (patch.bone >= asset.bones().size()) return fail(LoadCode::kReference, asset.bones().size(), patch.bone);
    next += patch.index_count;
    distance = patch.head_distance;
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
  if (asset.skin().empty()) return {LoadCode::kChunkMissing, chunk::kSkin};
  if (asset.indices().empty()) return {LoadCode::kChunkMissing, chunk::kIndices};
  if (asset.patches().empty()) return {LoadCode::kChunkMissing, chunk::kPatches};
  if (const LoadStatus status = check_vertices(asset.vertices()); !status) return status;
  if (const LoadStatus status = check_skin(asset); !status) return status;
  if (const LoadStatus status = check_indices(asset); !status) return status;
  return check_patches(asset);
}

}  // namespace coif
