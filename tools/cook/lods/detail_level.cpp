#include "cook/lods/detail_level.h"

#include "cook/recipe/drawn_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>
#include <string>

namespace coif::cook {
namespace {

constexpr float kLargestScreen = 8;  ///< A head eight times as high as the viewport.
constexpr float kScreenStep = 0.9f;  ///< Screen sizes fall at least by this from level to level.

/// Share of the screen's height at which the head's height makes `error` as large as the settings allow.
float largest_screen(double head_height, float error, const LodSettings& settings) {
  if (!(error > 0)) return kLargestScreen;
  return float(std::min(head_height * settings.pixel_error / (kScreenLines * error), double(kLargestScreen)));
}

/// How the level was made, for notes.
std::string origin_of(const DetailLevel& level, const DetailLevel& finest) {
  std::size_t common = 0;
  for (std::size_t p = 0; p < level.triangles_of.size(); ++p) {
    common += level.triangles_of[p].empty() || finest.triangles_of[p].empty() ? 0 : 1;
  }
  if (common == 0) return " of its own";
  const std::size_t dropped = finest.patch_count() - common;
  return dropped > 0 ? fmt::format(" ({} dropped)", dropped) : "";
}

std::string describe(std::size_t k, const DetailLevel& level, const DetailLevel& finest) {
  const std::string shown =
      level.shown_error < level.error ? fmt::format(" at most, {:.2f} mm RMS", 1000 * level.shown_error) : "";
  return fmt::format(
      "level {}: {} of {} triangles, {} patches{}, {} moving bones, error {:.2f} mm{}, from screen size {:.3f}", k,
      level.triangle_count(), finest.triangle_count(), level.patch_count(), origin_of(level, finest),
      std::ranges::count(level.simulated, true), 1000 * level.error, shown, level.screen_size);
}

/// Without vertices.
std::uint64_t bytes_of(const DetailLevel& level) {
  return 3 * sizeof(std::uint32_t) * level.triangle_count() + sizeof(PatchRecord) * level.patch_count() +
         sizeof(LodRecord);
}

/// The size of coarser levels besides the finest: also their own vertices.
std::string cost_in_bytes(std::span<const DetailLevel> levels) {
  std::uint64_t bytes = sizeof(LodRecord) + levels[0].simulated.size();
  std::vector<std::uint32_t> before = vertices_of(levels[0]), all;
  for (const DetailLevel& level : levels.subspan(1)) {
    bytes += bytes_of(level);
    const std::vector<std::uint32_t> own = vertices_of(level);
    all.clear();
    std::ranges::set_union(before, own, std::back_inserter(all));
    bytes += (all.size() - before.size()) * (sizeof(VertexRecord) + sizeof(SkinRecord));
    before.swap(all);
  }
  return fmt::format("coarser levels take {} bytes", bytes);
}

}  // namespace

LodSettings lod_settings(const DrawnRecipe& recipe, const platform::Threads& threads) {
  LodSettings settings;
  settings.levels = recipe.lod_levels;
  settings.ratio = recipe.lod_ratio;
  settings.max_error = recipe.lod_max_error;
  settings.pixel_error = recipe.lod_pixel_error;
  settings.still_pixels = recipe.lod_still_pixels;
  settings.threads = threads;
  return settings;
}

std::size_t DetailLevel::triangle_count() const {
  std::size_t total = 0;
  for (const auto& patch : triangles_of) total += patch.size() / 3;
  return total;
}

std::size_t DetailLevel::patch_count() const {
  return std::size_t(std::ranges::count_if(triangles_of, [](const auto& patch) { return !patch.empty(); }));
}

std::vector<std::uint32_t> indices_of(const DetailLevel& level) {
  std::vector<std::uint32_t> indices;
  for (const auto& patch : level.triangles_of) indices.insert(indices.end(), patch.begin(), patch.end());
  return indices;
}

std::vector<std::uint32_t> vertices_of(const DetailLevel& level) {
  std::vector<std::uint32_t> vertices = indices_of(level);
  std::ranges::sort(vertices);
  vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
  return vertices;
}

DetailLevel level_from(const HairStrips& hair, std::size_t first_triangle) {
  DetailLevel level;
  level.triangles_of.resize(hair.patches.count);
  for (std::size_t i = 3 * first_triangle; i < hair.mesh.triangles.size(); ++i) {
    level.triangles_of[hair.patches.patch_of[i / 3]].push_back(hair.mesh.triangles[i]);
  }
  return level;
}

DetailLevel finest_level(const HairStrips& hair, const Skeleton& skeleton) {
  DetailLevel level = level_from(hair, 0);
  level.simulated = moving_bones(skeleton, 0);
  return level;
}

void place_on_screen(double head_height, const Skeleton& skeleton, const LodSettings& settings,
                     std::vector<DetailLevel>& levels) {
  float finer = kLargestScreen / kScreenStep;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    levels[k].screen_size =
        std::min(largest_screen(head_height, levels[k + 1].shown_error, settings), finer * kScreenStep);
    finer = levels[k].screen_size;
    const double pixels_per_metre = finer * kScreenLines / head_height;
    levels[k + 1].simulated = moving_bones(skeleton, settings.still_pixels / pixels_per_metre);
  }
}

void describe_levels(std::span<const DetailLevel> levels, Findings& findings) {
  for (std::size_t k = 1; k < levels.size(); ++k) findings.note(describe(k, levels[k], levels[0]));
  if (levels.size() > 1) findings.note(cost_in_bytes(levels));
}

namespace {

/// The first level that is ever drawn: coarser ones are not yet right at the largest size.
std::size_t first_used(const std::vector<DetailLevel>& levels, double largest) {
  std::size_t first = 0;
  while (largest > 0 && first + 1 < levels.size() && levels[first].screen_size > largest) ++first;
  return first;
}

/// End of the used levels: from there on each fits only sizes that the scene does not have.
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

void leave_out_levels(const DrawnRecipe& recipe, std::vector<DetailLevel>& levels, Findings& findings) {
  const std::size_t first = first_used(levels, recipe.scene_largest_size);
  const std::size_t end = end_of_used(levels, first, recipe.scene_smallest_size);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (i < first) findings.leave_out(level_left_out(levels[i], i, "largest_size", recipe.scene_largest_size));
    if (i >= end) findings.leave_out(level_left_out(levels[i], i, "smallest_size", recipe.scene_smallest_size));
  }
  // The format knows no bone that is simulated in no level.
  levels[first].simulated = levels.front().simulated;
  levels.erase(levels.begin() + std::ptrdiff_t(end), levels.end());
  levels.erase(levels.begin(), levels.begin() + std::ptrdiff_t(first));
  const float own_error = levels.front().error;
  for (DetailLevel& level : levels) level.error += own_error;
  levels.front().error = 0;
  levels.back().screen_size = 0;
}

}  // namespace coif::cook
