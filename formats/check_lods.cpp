#include "chunk_checks.h"
#include "number_checks.h"

namespace coif {
namespace {

LoadStatus lod_error(LoadCode code, std::size_t level, std::uint64_t expected = 0, std::uint64_t found = 0) {
  return {code, chunk::kLods, level, expected, found};
}

/// Whatever is simulated is so in the finest level and in no level where its parent has become rigid to its own. Names the
/// first bone that is not so, with the largest number it may have.
LoadStatus check_lod_bones(const Asset& asset) {
  const auto counts = asset.lod_bones();
  const auto bones = asset.bones();
  if (counts.size() != bones.size()) {
    return {LoadCode::kChunkSize, chunk::kLodBones, 0, bones.size(), counts.size()};
  }
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const bool can_move = bones[i].kind == BoneKind::kSimulated;
    const bool hangs_freely = can_move && bones[bones[i].parent].kind != BoneKind::kSimulated;
    const std::size_t most = !can_move ? 0 : hangs_freely ? asset.lods().size() : counts[bones[i].parent];
    const std::size_t least = can_move ? 1 : 0;
    if (counts[i] < least || counts[i] > most) return {LoadCode::kLodBones, chunk::kLodBones, i, most, counts[i]};
  }
  return {};
}

/// Screen sizes fall to 0, errors start at 0 and grow: what lets a game pick a level by one comparison each.
bool measures_fit(const LodRecord& lod, const LodRecord* finer, bool is_last) {
  if (!in_range(lod.screen_size, 0.0f, kMaxCoordinate) || !in_range(lod.error, 0.0f, kMaxCoordinate)) return false;
  if (is_last != (lod.screen_size == 0.0f)) return false;
  if (finer == nullptr) return lod.error == 0.0f;
  return lod.screen_size < finer->screen_size && lod.error >= finer->error;
}

}  // namespace

LoadStatus check_lods(const Asset& asset) {
  const auto lods = asset.lods();
  if (lods.empty() != asset.lod_bones().empty()) {
    return {LoadCode::kChunkMissing, lods.empty() ? chunk::kLods : chunk::kLodBones};
  }
  if (lods.empty()) return {};
  if (lods.size() > kMaxLods) return lod_error(LoadCode::kChunkSize, 0, kMaxLods, lods.size());
  const std::uint64_t total = asset.patches().size();
  if (total == 0) return {LoadCode::kChunkMissing, chunk::kPatches};
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

}  // namespace coif
