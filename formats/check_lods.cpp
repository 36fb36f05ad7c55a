#include "chunk_checks.h"
#include "number_checks.h"

namespace coif {
namespace {

constexpr std::size_t kBitsPerWord = 32;

bool is_simulated(const LodRecord& lod, std::size_t bone) {
  return (lod.simulated[bone / kBitsPerWord] >> bone % kBitsPerWord & 1) != 0;
}

LoadStatus lod_error(LoadCode code, std::size_t level, std::uint64_t expected = 0, std::uint64_t found = 0) {
  return {code, chunk::kLods, level, expected, found};
}

/// `finer` is null for level 0. Names the first bone whose bit is wrong: a level simulates less than the finer one,
/// and never a bone whose parent is simulated in the finest level but not here.
LoadStatus check_simulated_bones(const Asset& asset, std::size_t level, const LodRecord* finer) {
  const LodRecord& lod = asset.lods()[level];
  const auto bones = asset.bones();
  for (std::size_t i = 0; i < kMaxBones; ++i) {
    const bool moves = is_simulated(lod, i);
    const bool can_move = i < bones.size() && bones[i].kind == BoneKind::kSimulated;
    const bool must_move = can_move && finer == nullptr;
    if (must_move && !moves) return lod_error(LoadCode::kLodBones, level, i, kNone);
    if (!moves) continue;
    const bool moved_before = finer == nullptr || is_simulated(*finer, i);
    if (!can_move || !moved_before) return lod_error(LoadCode::kLodBones, level, kNone, i);
    const BoneRecord& parent = bones[bones[i].parent];
    const bool hangs_freely = parent.kind != BoneKind::kSimulated || is_simulated(lod, bones[i].parent);
    if (!hangs_freely) return lod_error(LoadCode::kLodBones, level, kNone, i);
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
    if (const LoadStatus status = check_simulated_bones(asset, i, finer); !status) return status;
    next += lod.patch_count;
  }
  return next == total ? LoadStatus{} : lod_error(LoadCode::kLodCover, lods.size(), total, next);
}

}  // namespace coif
