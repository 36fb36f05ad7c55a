#include "cook/lods/make_lods.h"

#include "base/parallel_for.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace coif::cook {
namespace {

constexpr double kWorthwhile = 0.9;  ///< A level with more triangles than this share of the finer one is left out.
constexpr double kOvershoot = 1.02;  ///< Above the target by less than this: no patch is dropped for it.

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

/// Simplifies the patches towards `target`, each as far as its measured error allows. Returns the errors.
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

/// Distance of dropped hair from the hair that this level draws.
double LevelMaker::dropped_distance(const DetailLevel& level) const {
  if (std::ranges::all_of(drawn_, [](bool drawn) { return drawn; })) return 0;
  const std::vector<std::uint32_t> triangles = indices_of(level);
  const HairMesh& mesh = hair_.mesh;
  const TriangleGrid grid(mesh.positions, triangles, 2 * settings_.max_error);
  double worst = 0;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (drawn_[hair_.patches.patch_of[t]]) continue;
    for (std::size_t k = 0; k < 3; ++k) worst = std::max(worst, grid.distance(mesh.corner(t, k), worst));
  }
  return worst;
}

}  // namespace

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
    level.error = level.shown_error = std::max(level.error, finer.error);
    levels.push_back(std::move(level));
  }
  place_on_screen(2 * head.radii.y(), rig.skeleton, settings, levels);
  describe_levels(levels, findings);
  if (maker.bared() > 0) {
    findings.note(
        fmt::format("patches dropped from coarser levels bare {:.1f} % of the hair's outline", 100 * maker.bared()));
  }
  return levels;
}

}  // namespace coif::cook
