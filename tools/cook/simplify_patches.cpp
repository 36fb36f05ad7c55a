#include "cook/simplify_patches.h"

#include "parallel_for.h"

#include <algorithm>
#include <tuple>

namespace coif {

SimplifiedPatches::SimplifiedPatches(const HairMesh& mesh, std::span<const std::uint32_t> place,
                                     const PatchSet& patches, std::span<const Pose> poses, const CollapseLimits& limits,
                                     unsigned threads)
    : patches_(patches.count) {
  const std::vector<PatchView> views = view_patches(mesh, patches);
  parallel_for(views.size(), threads, [&](std::size_t p) {
    Patch& patch = patches_[p];
    for (std::size_t t : views[p].triangles) {
      patch.originals.insert(patch.originals.end(), mesh.triangles.begin() + std::ptrdiff_t(t),
                             mesh.triangles.begin() + std::ptrdiff_t(t + 3));
    }
    patch.surface = make_patch_surface(mesh, place, views[p], poses);
    patch.sequence = collapse_patch(patch.surface, limits);
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

}  // namespace coif
