#pragma once

#include "sample/long_locks.h"
#include "sample/surface_mesh.h"

#include <span>

namespace coif::sample {

/// The hair: for each lock a broad strip on it, and one above that bridges the gap to the next lock of its row. 20000
/// triangles in 200 connected groups that share no vertex, skinned to the locks' chains.
[[nodiscard]] SurfaceMesh make_long_hair(std::span<const Lock> locks);

}  // namespace coif::sample
