#pragma once

#include "cook/shrinking_surface.h"

namespace coif {

/// How a patch loses its triangles, one edge after the other. Any number of first steps makes a coarser patch out of the
/// finest one's vertices, so levels of detail share them.
struct CollapseSequence {
  struct Step {
    float error = 0;                   ///< Metres, in the worst of the poses, when it was made; ascending.
    std::uint32_t triangles_left = 0;  ///< After it.
    std::uint32_t moves_end = 0;       ///< moves[0 .. moves_end) belong to this step and those before.
  };
  std::vector<Step> steps;
  std::vector<CornerMove> moves;
};

struct CollapseLimits {
  double largest_error = 0.01;  ///< Metres.
  double fewest_share = 0;      ///< Of its triangles that a patch keeps in any case.
};

/// Collapses edges onto one of their ends, those first that change the shape least. Corners of the outline stay, so that
/// strips keep their points and their width, and something of every piece stays.
///
/// A step's error is measured: how far the points that are gone lie from the triangles now around where they went.
/// Near-linear in the triangles.
[[nodiscard]] CollapseSequence collapse_patch(const PatchSurface& surface, const CollapseLimits& limits);

/// The patch after its first `steps` steps: for each corner the one that it has become.
[[nodiscard]] std::vector<std::uint32_t> collapsed_corners(const PatchSurface& surface,
                                                           const CollapseSequence& sequence, std::size_t steps);

/// How far the surface's points lie from the patch after `steps` steps, in the worst of the poses, metres. Each looks for what
/// is nearest from where it has gone, as long as neighbours are nearer, so the true distance may be less.
[[nodiscard]] double collapsed_error(const PatchSurface& surface, const CollapseSequence& sequence, std::size_t steps);

/// The patch after its first `steps` steps: three vertices of the mesh for each triangle that is left. `originals` are
/// the vertices of the patch's triangles as they were, in the order of PatchSurface::triangles.
[[nodiscard]] std::vector<std::uint32_t> collapsed_triangles(const PatchSurface& surface,
                                                             const CollapseSequence& sequence, std::size_t steps,
                                                             std::span<const std::uint32_t> originals);

}  // namespace coif
