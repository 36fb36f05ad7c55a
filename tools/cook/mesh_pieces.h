#pragma once

#include "import/source_model.h"

#include <cstdint>
#include <vector>

namespace coif {

/// Connected pieces of one source mesh: triangles that share places, since exporters split vertices freely.
struct MeshPieces {
  std::vector<std::uint32_t> piece_of;  ///< For each triangle, numbered by first appearance.
  std::uint32_t count = 0;
};

[[nodiscard]] MeshPieces find_pieces(const SourceMesh& mesh, double weld_distance);

}  // namespace coif
