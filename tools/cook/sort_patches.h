#pragma once

#include "cook/hair_mesh.h"

#include <vector>

namespace coif {

struct PatchOrder {
  std::vector<std::uint32_t> patch;  ///< Draw position -> patch, inner ones first.
  std::vector<double> distance;      ///< Per draw position, metres, ascending.
  /// Per draw position: which of the patches it is in the file, by their first triangles.
  std::vector<std::uint32_t> file_place;
};

/// The thesis's order (5.3.1): by the distance of the patch's middle, weighted by area, from the head's centre. Equal
/// distances keep the order of the file.
[[nodiscard]] PatchOrder sort_patches(const HairMesh& mesh, const PatchSet& patches,
                                      const Eigen::Vector3d& head_center);

}  // namespace coif
