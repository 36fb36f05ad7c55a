#pragma once

#include "cook/patch_view.h"

#include <vector>

namespace coif {

/// How the strands of two patches that lie beside each other run.
struct Neighbour {
  std::uint32_t patch = 0;
  float agreement =
      0;  ///< 1: the same way, -1: opposite ways; sums to at most 1 in magnitude over a patch's neighbours.
};

/// For each patch the ones whose vertices are within `reach` metres of its own and whose tangents are about parallel or
/// opposite there. Looks at a bounded number of vertices per patch: near-linear.
[[nodiscard]] std::vector<std::vector<Neighbour>> find_neighbours(const HairMesh& mesh,
                                                                  const std::vector<PatchView>& views,
                                                                  std::span<const Eigen::Vector3f> tangents,
                                                                  double reach);

}  // namespace coif
