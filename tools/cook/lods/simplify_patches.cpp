#include "base/parallel_for.h"
#include "cook/lods/make_lods.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace coif::cook {

SimplifiedPatches::SimplifiedPatches(const HairStrips& hair, std::span<const Pose> poses, const CollapseLimits& limits,
                                     const platform::Threads& threads)
    : patches_(hair.patches.count) {
  const std::vector<PatchView> views = hair.views();
  parallel_for(views.size(), threads, [&](std::size_t p) {
    Patch& patch = patches_[p];
    for (std::size_t t : views[p].triangles) {
      const auto first = hair.mesh.triangles.begin() + std::ptrdiff_t(t);
      patch.originals.insert(patch.originals.end(), first, first + 3);
    }
    patch.surface = make_patch_surface(hair, views[p], poses);
    patch.sequence = collapse_patch(patch.surface, limits, threads.stop);
  });
}

std::size_t SimplifiedPatches::triangles_left(std::size_t patch, std::size_t steps) const {
  return steps == 0 ? finest_triangles(patch) : patches_[patch].sequence.steps[steps - 1].triangles_left;
}

float SimplifiedPatches::error(std::size_t patch, std::size_t steps) const {
  return float(collapsed_error(patches_[patch].surface, patches_[patch].sequence, steps));
}

std::vector<std::uint32_t> SimplifiedPatches::triangles(std::size_t patch, std::size_t steps) const {
  const Patch& p = patches_[patch];
  return steps == 0 ? p.originals : collapsed_triangles(p.surface, p.sequence, steps, p.originals);
}

std::vector<std::size_t> SimplifiedPatches::steps_for(std::size_t target, const std::vector<bool>& drawn,
                                                      std::vector<std::size_t> at_least) const {
  struct NextStep {
    float error;
    std::uint32_t patch, step;
  };
  std::vector<NextStep> next;
  std::size_t total = 0;
  for (std::uint32_t p = 0; p < patches_.size(); ++p) {
    if (!drawn[p]) continue;
    total += triangles_left(p, at_least[p]);
    const auto& steps = patches_[p].sequence.steps;
    for (std::size_t s = at_least[p]; s < steps.size(); ++s) next.push_back({steps[s].error, p, std::uint32_t(s)});
  }
  const auto key = [](const NextStep& n) { return std::tuple(n.error, n.patch, n.step); };
  std::ranges::sort(next, {}, key);
  std::vector<std::size_t> steps = std::move(at_least);
  for (const NextStep& n : next) {
    if (total <= target) break;
    total -= triangles_left(n.patch, n.step) - triangles_left(n.patch, n.step + 1);
    steps[n.patch] = n.step + 1;
  }
  return steps;
}

namespace {

constexpr double kBaredAtMost = 0.02;  ///< Share of all pixels with hair that the hair's outline may lose.
/// Share of one patch's pixels: a wisp that is seen against the background stays.
constexpr double kAloneAtMost = 0.2;

}  // namespace

PatchDropper::PatchDropper(const HairStrips& hair, const AlphaTest& alpha, double reach,
                           const platform::Threads& threads)
    : mesh_(hair.mesh),
      views_(hair, alpha, threads),
      grid_(mesh_.positions, mesh_.triangles, hair.patches.patch_of, reach),
      reach_(reach) {
  for (const PatchView& view : hair.views()) vertices_.push_back(view.vertices);
}

bool PatchDropper::may_go(std::uint32_t patch, std::vector<bool>& drawn) const {
  const std::size_t alone = views_.alone(patch);
  if (double(alone) > kAloneAtMost * double(views_.pixels(patch))) return false;
  if (double(bared_ + alone) > kBaredAtMost * double(views_.covered())) return false;
  drawn[patch] = false;
  const bool near = std::ranges::all_of(
      vertices_[patch], [&](std::uint32_t v) { return grid_.distance(mesh_.positions[v], drawn, reach_) < reach_; });
  drawn[patch] = true;
  return near;
}

std::size_t PatchDropper::drop(std::size_t excess, std::span<const std::size_t> triangles, std::vector<bool>& drawn) {
  const auto seen_per_triangle = [&](std::uint32_t p) {
    return double(views_.seen(p)) / double(std::max<std::size_t>(triangles[p], 1));
  };
  std::vector<std::uint32_t> order(drawn.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, seen_per_triangle);
  std::size_t gone = 0, left = std::size_t(std::ranges::count(drawn, true));
  for (std::uint32_t p : order) {
    if (gone >= excess || left == 1) break;
    if (!drawn[p] || !may_go(p, drawn)) continue;
    bared_ += views_.alone(p);
    views_.drop(p);
    drawn[p] = false;
    gone += triangles[p];
    --left;
  }
  return gone;
}

double PatchDropper::bared() const { return views_.covered() == 0 ? 0 : double(bared_) / double(views_.covered()); }

}  // namespace coif::cook
