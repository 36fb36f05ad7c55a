#pragma once

#include "sample/surface_mesh.h"

namespace coif::sample {

/// The hair: five broad panels under twenty strips in two layers and a fringe. 2870 triangles in 25 connected groups
/// that share no vertex.
[[nodiscard]] SurfaceMesh make_bob_hair();

}  // namespace coif::sample
