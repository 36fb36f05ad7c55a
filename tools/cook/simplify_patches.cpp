#include "cook/simplify_patches.h"

#include "cook/parallel_for.h"

#include <algorithm>
#include <numeric>
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
  return steps == 0 ? 0.0f : patches_[patch].sequence.steps[steps - 1].error;
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

std::vector<std::uint32_t> collapsed_triangles(const PatchSurface& surface, const CollapseSequence& sequence,
                                               std::size_t steps, std::span<const std::uint32_t> originals) {
  std::vector<std::uint32_t> now(surface.vertex_of_corner.size()), point_of_corner(now.size());
  std::iota(now.begin(), now.end(), 0u);
  // Backwards: where a corner goes is known before what went into it.
  for (std::size_t m = steps == 0 ? 0 : sequence.steps[steps - 1].moves_end; m-- > 0;) {
    now[sequence.moves[m].from] = now[sequence.moves[m].to];
  }
  for (const auto& triangle : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) point_of_corner[triangle.corner[k]] = triangle.point[k];
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> vertex{}, point{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = surface.triangles[t].corner[k];
      const bool stays = now[corner] == corner;
      vertex[k] = stays ? originals[3 * t + k] : surface.vertex_of_corner[now[corner]];
      point[k] = point_of_corner[now[corner]];
    }
    const bool has_area = point[0] != point[1] && point[1] != point[2] && point[2] != point[0];
    if (has_area) triangles.insert(triangles.end(), vertex.begin(), vertex.end());
  }
  return triangles;
}

}  // namespace coif
