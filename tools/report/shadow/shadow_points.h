#pragma once

#include "visibility/fragment_view.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace coif {

/// A point and how much of a light reaches it, exactly.
struct ShadowPoint {
  Eigen::Vector3f place;   ///< Head space, metres.
  Eigen::Vector3f normal;  ///< Of the surface, any length; 0: as if it faced the light.
  float transmittance = 1;
  float weight = 1;  ///< Of hair: its alpha, which is how much of it there is to see.
  bool is_head = false;
};

/// Where lines from the light meet hair, up to the head, and where they meet the head. What lies before a point on its line is
/// known exactly, so no point needs a margin to its own card. `seen`: from the light, `hair` with its vertices at `positions`.
[[nodiscard]] std::vector<ShadowPoint> shadow_points(const FragmentView& seen, const HairSurface& hair,
                                                     std::span<const Eigen::Vector3f> positions);

}  // namespace coif
