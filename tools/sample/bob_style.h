#pragma once

#include "sample/surface_mesh.h"

namespace coif::sample {

/// How finely the sample is made; the sample itself has the defaults. Others are for measuring how costs grow.
struct BobDensity {
  double quads = 1;  ///< Rows and columns of each strip, as a share of the sample's.
  int copies = 1;    ///< Strips in place of each, slightly apart.
};

/// The hair: five broad panels under twenty strips in two layers and a fringe. 2870 triangles in 25 connected groups
/// that share no vertex, or with another density accordingly more or fewer.
[[nodiscard]] SurfaceMesh make_bob_hair(const BobDensity& density = {});

}  // namespace coif::sample
