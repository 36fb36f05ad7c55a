#pragma once

#include "cook/fit_head.h"
#include "cook/hair_mesh.h"

namespace coif {

struct StrandField {
  std::vector<Eigen::Vector3f> tangent;  ///< Per vertex, unit, root to tip, perpendicular to the normal.
  std::vector<float> place;              ///< Per vertex, 0 root .. 1 tip.
  bool along_u = false;                  ///< In the texture most patches run along U, not V.
};

/// The direction of the strands on every vertex: along the texture axis that runs down the patch's longer side, or along the
/// patch itself where there are no texture coordinates. The end that is nearer to the head is the root; where both
/// are as near, the upper one. Vertices are not shared between patches.
[[nodiscard]] StrandField find_strand_direction(const HairMesh& mesh, const PatchSet& patches, const FittedHead& head,
                                                unsigned threads);

}  // namespace coif
