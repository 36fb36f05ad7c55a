#include "chunk_checks.h"

namespace coif {
namespace {

LoadStatus lod_error(LoadCode code, std::size_t level, std::uint64_t expected = 0, std::uint64_t found = 0) {
  return {code, chunk::kLods, level, expected, found};
}

/// Every simulated bone must move in the finest level, and in no level where its parent is rigid. Reports the first
/// bone that breaks this rule, with the largest count that it may have.
LoadStatus check_lod_bones(const Asset& asset) {
  const auto counts = asset.lod_bones();
  const auto bones = asset.bones();
  if (counts.size() != bones.size()) {
    return {LoadCode::kChunkSize, chunk::kLodBones, 0, bones.size(), counts.size()};
  }
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const bool can_move = bones[i].kind == BoneKind::kSimulated;
    const bool hangs_freely = can_move && bones[bones[i].parent].kind != BoneKind::kSimulated;
    const std::size_t most = !can_move ? 0 : hangs_freely ? asset.stored_lods().size() : counts[bones[i].parent];
    const std::size_t least = can_move ? 1 : 0;
    if (counts[i] < least || counts[i] > most) return {LoadCode::kLodBones, chunk::kLodBones, i, most, counts[i]};
  }
  return {};
}

/// Screen sizes fall to 0, errors start at 0 and grow. So a game can pick a level by one comparison each.
bool measures_fit(const LodRecord& lod, const LodRecord* finer, bool is_last) {
  if (!in_range(lod.screen_size, 0.0f, kMaxCoordinate) || !in_range(lod.error, 0.0f, kMaxCoordinate)) return false;
  if (is_last != (lod.screen_size == 0.0f)) return false;
  if (finer == nullptr) return lod.error == 0.0f;
  return lod.screen_size < finer->screen_size && lod.error >= finer->error;
}

}  // namespace

LoadStatus check_lods(const Asset& asset) {
  const auto lods = asset.stored_lods();
  if (lods.empty()) return {};
  if (lods.size() > kMaxLods) return lod_error(LoadCode::kChunkSize, 0, kMaxLods, lods.size());
  const std::uint64_t total = asset.patches().size();
  std::uint64_t next = 0;
  for (std::size_t i = 0; i < lods.size(); ++i) {
    const LodRecord& lod = lods[i];
    const LodRecord* finer = i == 0 ? nullptr : &lods[i - 1];
    if (lod.first_patch != next) return lod_error(LoadCode::kLodCover, i, next, lod.first_patch);
    if (lod.patch_count == 0 || lod.patch_count > total - next) {
      return lod_error(LoadCode::kLodCover, i, total - next, lod.patch_count);
    }
    if (!measures_fit(lod, finer, i + 1 == lods.size())) return lod_error(LoadCode::kLodOrder, i);
    next += lod.patch_count;
  }
  if (next != total) return lod_error(LoadCode::kLodCover, lods.size(), total, next);
  return check_lod_bones(asset);
}

namespace {

// Meshes have thousands of records, and nearly always all are good. So each record gives one word of faults without a
// branch, the words are joined and tested once, and only a mesh with a fault is searched for its place.

/// Within 5 % of unit length: rounding to 16 bits is far below that, a zero or garbage vector far above.
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
  if (asset.vertices().empty()) return {};  // a skeleton alone is a complete asset
  if (const LoadStatus status = check_vertices(asset.vertices()); !status) return status;
  if (const LoadStatus status = check_skin(asset); !status) return status;
  if (const LoadStatus status = check_indices(asset); !status) return status;
  return check_patches(asset);
}

namespace {

LoadStatus order_error(LoadCode code, std::size_t item, std::uint64_t expected = 0, std::uint64_t found = 0) {
  return {code, chunk::kOrders, item, expected, found};
}

/// Spreads a triangle's number over all bits, so that sums of the results tell one set of triangles from another.
/// Source: the finaliser of SplitMix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators").
std::uint64_t scatter(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
  x = (x ^ x >> 27) * 0x94D049BB133111EBu;
  return x ^ x >> 31;
}

/// Checks triangles `first` to `first + count` of one level in all further orders. There is no memory for a mark per
/// triangle, so a sum shows that each occurs once; that is certain against accidents. A forged list that passes draws
/// wrong triangles, but no more than the level has, and all of them the level's own.
LoadStatus check_level(const Asset& asset, std::size_t first, std::size_t count) {
  std::uint64_t expected = 0;
  for (std::size_t t = first; t < first + count; ++t) expected += scatter(t + 1);
  const auto orders = asset.orders();
  for (std::size_t start = first; start < orders.size(); start += asset.indices().size() / 3) {
    std::uint64_t found = 0;
    for (std::size_t i = start; i < start + count; ++i) {
      const std::size_t triangle = orders[i];
      if (triangle < first || triangle - first >= count) {
        return order_error(LoadCode::kReference, i, first + count, triangle);
      }
      found += scatter(triangle + 1);
    }
    if (found != expected) return order_error(LoadCode::kOrderCover, start);
  }
  return {};
}

LoadStatus check_levels(const Asset& asset) {
  if (asset.stored_lods().empty()) return check_level(asset, 0, asset.indices().size() / 3);
  for (const LodRecord& lod : asset.stored_lods()) {
    const auto patches = asset.patches().subspan(lod.first_patch, lod.patch_count);
    const std::size_t first = patches.front().first_index;
    const std::size_t end = std::size_t{patches.back().first_index} + patches.back().index_count;
    if (const LoadStatus status = check_level(asset, first / 3, (end - first) / 3); !status) return status;
  }
  return {};
}

LoadStatus check_views(const Asset& asset, std::size_t order_count) {
  const auto views = asset.order_views();
  if (views.size() != kViewCells) return {LoadCode::kChunkSize, chunk::kOrderViews, 0, kViewCells, views.size()};
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i] >= order_count) return {LoadCode::kReference, chunk::kOrderViews, i, order_count, views[i]};
  }
  return {};
}

}  // namespace

LoadStatus check_orders(const Asset& asset) {
  const auto orders = asset.orders();
  if (orders.empty()) return {};
  const std::size_t triangles = asset.indices().size() / 3;
  if (orders.size() % triangles != 0) return order_error(LoadCode::kChunkSize, 0, triangles, orders.size());
  const std::size_t further = orders.size() / triangles;
  if (further >= kMaxOrders) return order_error(LoadCode::kChunkSize, 0, kMaxOrders - 1, further);
  if (const LoadStatus status = check_levels(asset); !status) return status;
  return check_views(asset, further + 1);
}

}  // namespace coif
