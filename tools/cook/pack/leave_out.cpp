#include "cook/dynamics/settle_dynamics.h"
#include "cook/pack/pack.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif {
namespace {

/// The last of the textures, so that no other has to move.
std::uint64_t clear_shift_mask(AssetContents& contents) {
  if (contents.textures.empty() || contents.textures.back().role != TextureRole::kShiftMask) return 0;
  const std::size_t before = contents.texels.size();
  contents.textures.pop_back();
  contents.texels.resize(contents.textures.empty() ? 0
                                                   : contents.textures.back().offset + contents.textures.back().bytes);
  return before - contents.texels.size() + sizeof(TextureRecord);
}

std::uint64_t bytes_of(const DetailLevel& level) {
  return 3 * sizeof(std::uint32_t) * level.triangle_count() + sizeof(PatchRecord) * level.patch_count() +
         sizeof(LodRecord);
}

/// The first level that is ever drawn: coarser ones are not yet right at the largest size.
std::size_t first_used(const std::vector<DetailLevel>& levels, double largest) {
  std::size_t first = 0;
  while (largest > 0 && first + 1 < levels.size() && levels[first].screen_size > largest) ++first;
  return first;
}

/// One past the last: the levels from which on each fits sizes that the scene does not have.
std::size_t end_of_used(const std::vector<DetailLevel>& levels, std::size_t first, double smallest) {
  std::size_t end = first + 1;
  while (end < levels.size() && levels[end - 1].screen_size > smallest) ++end;
  return end;
}

LeftOut level_left_out(const DetailLevel& level, std::size_t number, const char* key, double size) {
  return {fmt::format("level of detail {}, {} triangles", number, level.triangle_count()),
          fmt::format("\"scene.{}\" is {:g}", key, size), bytes_of(level), 0};
}

}  // namespace

std::vector<LeftOut> leave_out_parts(const Recipe& recipe, AssetContents& contents) {
  std::vector<LeftOut> left_out;
  const auto note = [&](const char* what, const char* key, std::uint64_t bytes) {
    if (bytes > 0) left_out.push_back({what, fmt::format("\"scene.{}\" is false", key), bytes, 0});
  };
  if (!recipe.scene_names) note("bone names", "names", clear_group("names", contents));
  if (!recipe.scene_quality) note("quality of other settings", "quality", clear_group("quality", contents));
  if (!recipe.scene_provenance) note("provenance", "provenance", clear_group("provenance", contents));
  if (!recipe.scene_draw) note("mesh, material and textures", "draw", clear_group("mesh", contents));
  if (!recipe.scene_shift_mask) note("shift and mask of the highlights", "shift_mask", clear_shift_mask(contents));
  return left_out;
}

std::vector<LeftOut> leave_out_motion(Skeleton rigid, Skeleton& skeleton, SkinWeights& weights) {
  const std::size_t bones = skeleton.bones.size() - 1, moving = skeleton.simulated_count();
  LeftOut motion;
  motion.what = fmt::format("{} bones, {} of them simulated", bones, moving);
  motion.why = "\"scene.simulate\" is false";
  motion.bytes = bones * (sizeof(BoneRecord) + (moving > 0 ? sizeof(DynamicsRecord) : 0)) +
                 skeleton.chains.size() * sizeof(ChainRecord);
  motion.ns_per_frame = nominal_cost(moving, 1);
  rigid.warnings = std::move(skeleton.warnings);
  skeleton = std::move(rigid);
  std::ranges::for_each(weights, [](auto& of_vertex) { of_vertex.clear(); });
  return bones == 0 ? std::vector<LeftOut>{} : std::vector<LeftOut>{motion};
}

std::vector<LeftOut> leave_out_levels(const Recipe& recipe, DetailLevels& lods) {
  std::vector<DetailLevel>& levels = lods.levels;
  const std::size_t first = first_used(levels, recipe.scene_largest_size);
  const std::size_t end = end_of_used(levels, first, recipe.scene_smallest_size);
  std::vector<LeftOut> left_out;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (i < first) left_out.push_back(level_left_out(levels[i], i, "largest_size", recipe.scene_largest_size));
    if (i >= end) left_out.push_back(level_left_out(levels[i], i, "smallest_size", recipe.scene_smallest_size));
  }
  // The format knows no bone that is simulated in no level.
  levels[first].simulated = levels.front().simulated;
  levels.erase(levels.begin() + std::ptrdiff_t(end), levels.end());
  levels.erase(levels.begin(), levels.begin() + std::ptrdiff_t(first));
  const float own_error = levels.front().error;
  for (DetailLevel& level : levels) level.error += own_error;
  levels.front().error = 0;
  levels.back().screen_size = 0;
  return left_out;
}

std::vector<LeftOut> leave_out_colliders(Colliders& colliders) {
  std::uint32_t used = 0;
  for (const std::uint32_t set : colliders.of_bone) used |= set;
  std::vector<LeftOut> left_out;
  std::vector<HeadCollider> shapes;
  std::vector<std::uint32_t> sets(colliders.of_bone.size(), 0);
  for (std::size_t c = 0; c < colliders.shapes.size(); ++c) {
    if ((used >> c & 1) == 0) {
      left_out.push_back({fmt::format("collider {}", c), "no bone can reach it", sizeof(ColliderRecord), 0});
      continue;
    }
    for (std::size_t b = 0; b < sets.size(); ++b) sets[b] |= (colliders.of_bone[b] >> c & 1) << shapes.size();
    shapes.push_back(colliders.shapes[c]);
  }
  colliders.shapes = std::move(shapes);
  colliders.of_bone = std::move(sets);
  return left_out;
}

}  // namespace coif
