#pragma once

#include "cook/hair_mesh.h"
#include "cook/skeleton.h"

namespace coif {

/// One record per vertex: the four bones with most weight, in bytes that add up to exactly 255 (largest remainder).
/// Vertices without influences follow the head.
[[nodiscard]] std::vector<SkinRecord> quantize_skin(const HairMesh& mesh, const Skeleton& skeleton);

}  // namespace coif
