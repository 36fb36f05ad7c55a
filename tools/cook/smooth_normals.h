#pragma once

#include "cook/hair_mesh.h"

namespace coif {

/// Fills in normals that are missing or not unit: the mean of the faces around a place, weighted by area, as far as they
/// look the same way as the vertex's own faces (a strip's two sides share places). `place` of each vertex from
/// weld_places(). Returns how many were filled in.
std::size_t complete_normals(HairMesh& mesh, std::span<const std::uint32_t> place);

}  // namespace coif
