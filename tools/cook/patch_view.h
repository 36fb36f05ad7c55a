#pragma once

#include "cook/hair_mesh.h"

#include <vector>

namespace coif {

/// What belongs to one patch.
struct PatchView {
  std::vector<std::size_t> triangles;   ///< First index of each.
  std::vector<std::uint32_t> vertices;  ///< Ascending, each once.
};

/// Every patch's triangles and vertices.
[[nodiscard]] std::vector<PatchView> view_patches(const HairMesh& mesh, const PatchSet& patches);

/// Twice the area of the triangle whose first index is at `t`, square metres.
[[nodiscard]] float doubled_area(const HairMesh& mesh, std::size_t t);

}  // namespace coif
