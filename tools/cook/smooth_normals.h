#pragma once

#include "cook/hair_mesh.h"

namespace coif {

/// Fills in normals that are missing or not unit: the mean of the faces around a place, weighted by area, as far as they
/// look the same way as the vertex's own faces (a strip's two sides share places). Returns how many were filled in.
std::size_t complete_normals(HairMesh& mesh, double weld_distance);

}  // namespace coif
