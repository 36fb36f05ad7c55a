#include "cook/lods/make_lods.h"

#include "base/parallel_for.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace coif {
namespace {

constexpr double kWorthwhile = 0.9;  ///< A level with more triangles than this share of the finer one is left out.
constexpr double kOvershoot = 1.02;  ///< Above the target by less than this: no patch is dropped for it.
constexpr float kLargestScreen = 8;  ///< A head eight times as high as the viewport.
constexpr float kScreenStep = 0.9f;  ///< Screen sizes fall at least by this from level to level.

class LevelMaker {
 public:
  LevelMaker(const HairStrips& hair, const SimplifiedPatches& simplified, const AlphaTest& alpha,
             const LodSettings& settings)
      : hair_(hair),
        simplified_(simplified),
        alpha_(alpha),
        settings_(settings),
        drawn_(simplified.count(), true),
        steps_(simplified.count(), 0) {}

  /// The next level, of about `target` triangles.
  DetailLevel make(std::size_t target);
  [[nodiscard]] double bared() const { return dropper_ ? dropper_->bared() : 0; }

 private:
  [[nodiscard]] std::size_t triangles() const;
  std::vector<float> simplify(std::size_t target);
  void drop(std::size_t excess);
  [[nodiscard]] double dropped_distance(const DetailLevel& level) const;

  const HairStrips& hair_;
  const SimplifiedPatches& simplified_;
  const AlphaTest& alpha_;
  const LodSettings& settings_;
  std::vector<bool> drawn_;
  std::vector<std::size_t> steps_;
  std::optional<PatchDropper> dropper_;
};

std::size_t LevelMaker::triangles() const {
  std::size_t total = 0;
  for (std::size_t p = 0; p < drawn_.size(); ++p) total += drawn_[p] ? simplified_.triangles_left(p, steps_[p]) : 0;
  return total;
}

void LevelMaker::drop(std::size_t excess) {
  // Its pictures take time, and most hair never needs them.
  if (!dropper_) dropper_.emplace(hair_, alpha_, settings_.max_error, settings_.threads);
  std::vector<std::size_t> left(drawn_.size());
  for (std::size_t p = 0; p < left.size(); ++p) left[p] = simplified_.triangles_left(p, steps_[p]);
  dropper_->drop(excess, left, drawn_);
}

/// Takes the patches towards `target`, each as far as its measured error allows. Returns the errors.
std::vector<float> LevelMaker::simplify(std::size_t target) {
  const std::vector<std::size_t> finer = steps_;
  steps_ = simplified_.steps_for(target, drawn_, finer);
  std::vector<float> errors(simplified_.count(), 0.0f);
  parallel_for(simplified_.count(), settings_.threads, [&](std::size_t p) {
    if (!drawn_[p]) return;
    errors[p] = simplified_.error(p, steps_[p]);
    while (errors[p] > settings_.max_error && steps_[p] > finer[p]) {
      steps_[p] -= (steps_[p] - finer[p] + 3) / 4;
      errors[p] = simplified_.error(p, steps_[p]);
    }
  });
  return errors;
}

DetailLevel LevelMaker::make(std::size_t target) {
  const std::vector<float> errors = simplify(target);
  if (double(triangles()) > kOvershoot * double(target)) drop(triangles() - target);
  DetailLevel level;
  level.triangles_of.resize(simplified_.count());
  parallel_for(simplified_.count(), settings_.threads, [&](std::size_t p) {
    if (drawn_[p]) level.triangles_of[p] = simplified_.triangles(p, steps_[p]);
  });
  for (std::size_t p = 0; p < simplified_.count(); ++p) {
    if (drawn_[p]) level.error = std::max(level.error, errors[p]);
  }
  level.error = std::max(level.error, float(dropped_distance(level)));
  return level;
}

/// Of hair that was dropped from what this level draws.
double LevelMaker::dropped_distance(const DetailLevel& level) const {
  if (std::ranges::all_of(drawn_, [](bool drawn) { return drawn; })) return 0;
  std::vector<std::uint32_t> triangles;
  for (const auto& patch : level.triangles_of) triangles.insert(triangles.end(), patch.begin(), patch.end());
  const HairMesh& mesh = hair_.mesh;
  const TriangleGrid grid(mesh.positions, triangles, 2 * settings_.max_error);
  double worst = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (drawn_[hair_.patches.patch_of[t]]) continue;
    for (std::size_t k = 0; k < 3; ++k) worst = std::max(worst, grid.distance(mesh.corner(t, k), worst));
  }
  return worst;
}

DetailLevel finest_level(const HairStrips& hair, const Skeleton& skeleton) {
  DetailLevel level;
  level.triangles_of.resize(hair.patches.count);
  for (std::size_t i = 0; i < hair.mesh.triangles.size(); ++i) {
    level.triangles_of[hair.patches.patch_of[i / 3]].push_back(hair.mesh.triangles[i]);
  }
  level.simulated = moving_bones(skeleton, 0);
  return level;
}

/// Share of the screen's height at which the head's height makes `error` as large as the settings allow.
float largest_screen(double head_height, float error, const LodSettings& settings) {
  if (!(error > 0)) return kLargestScreen;
  return float(std::min(head_height * settings.pixel_error / (kScreenLines * error), double(kLargestScreen)));
}

/// Screen sizes of all levels, and the bones of the coarser ones, which follow from the largest size each is used at.
void place_on_screen(double head_height, const Skeleton& skeleton, const LodSettings& settings,
                     std::vector<DetailLevel>& levels) {
  float finer = kLargestScreen / kScreenStep;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    levels[k].screen_size = std::min(largest_screen(head_height, levels[k + 1].error, settings), finer * kScreenStep);
    finer = levels[k].screen_size;
    const double pixels_per_metre = finer * kScreenLines / head_height;
    levels[k + 1].simulated = moving_bones(skeleton, settings.still_pixels / pixels_per_metre);
  }
}

std::string describe(std::size_t k, const DetailLevel& level, const DetailLevel& finest) {
  const std::size_t dropped = finest.patch_count() - level.patch_count();
  return fmt::format(
      "level {}: {} of {} triangles, {} patches{}, {} moving bones, error {:.2f} mm, from screen size {:.3f}", k,
      level.triangle_count(), finest.triangle_count(), level.patch_count(),
      dropped > 0 ? fmt::format(" ({} dropped)", dropped) : "", std::ranges::count(level.simulated, true),
      1000 * level.error, level.screen_size);
}

std::string cost_in_bytes(std::span<const DetailLevel> levels) {
  std::size_t bytes = levels.size() * sizeof(LodRecord) + levels[0].simulated.size();
  for (const DetailLevel& level : levels.subspan(1)) {
    bytes += level.triangle_count() * 3 * sizeof(std::uint32_t) + level.patch_count() * sizeof(PatchRecord);
  }
  return fmt::format("coarser levels take {} bytes", bytes);
}

}  // namespace

LodSettings lod_settings(const Recipe& recipe, unsigned threads) {
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

std::vector<DetailLevel> make_lods(const HairStrips& hair, const HairRig& rig, const FittedHead& head,
                                   const AlphaTest& alpha, const LodSettings& settings, Findings& findings) {
  std::vector<DetailLevel> levels{finest_level(hair, rig.skeleton)};
  if (settings.levels <= 1) return levels;
  const double coarsest = std::pow(settings.ratio, settings.levels - 1);
  const auto poses = bent_poses(hair.mesh, rig);
  const SimplifiedPatches simplified(hair, poses, {settings.max_error, coarsest / 2}, settings.threads);
  LevelMaker maker(hair, simplified, alpha, settings);
  const std::size_t finest = levels[0].triangle_count();
  for (std::uint32_t k = 1; k < settings.levels; ++k) {
    DetailLevel level = maker.make(std::size_t(std::pow(settings.ratio, k) * double(finest)));
    const DetailLevel& finer = levels.back();
    if (double(level.triangle_count()) > kWorthwhile * double(finer.triangle_count())) {
      findings.note(
          fmt::format("no level {}: below {:.1f} mm of error nothing more can be left out than {} of {} triangles", k,
                      1000 * settings.max_error, finest - level.triangle_count(), finest));
      break;
    }
    level.error = std::max(level.error, finer.error);
    levels.push_back(std::move(level));
  }
  place_on_screen(2 * head.radii.y(), rig.skeleton, settings, levels);
  for (std::size_t k = 1; k < levels.size(); ++k) findings.note(describe(k, levels[k], levels[0]));
  if (levels.size() > 1) findings.note(cost_in_bytes(levels));
  if (maker.bared() > 0) {
    findings.note(
        fmt::format("patches dropped from coarser levels bare {:.1f} % of the hair's outline", 100 * maker.bared()));
  }
  return levels;
}

namespace {

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

void leave_out_levels(const Recipe& recipe, std::vector<DetailLevel>& levels, Findings& findings) {
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

}  // namespace coif
