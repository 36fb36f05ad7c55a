#pragma once

#include "cook/hair_mesh.h"

namespace coif {

/// For each vertex the smallest vertex at its place: closer than `distance` metres along a chain of neighbours. 0: a
/// 50,000th of the diagonal of all positions, so that a model's size does not decide what is joined. Linear time for
/// meshes whose vertices are not all in one spot of that size.
[[nodiscard]] std::vector<std::uint32_t> weld_places(std::span<const Eigen::Vector3f> positions, double distance);

/// Makes vertices that agree in every attribute one, in order of first use, and drops unused ones. Importers write
/// three vertices per triangle; only after this do indices say what the artist joined.
void weld_vertices(HairMesh& mesh);

}  // namespace coif
