#pragma once

#include "visibility/fragment_view.h"
#include "visibility/linear_order.h"
#include "visibility/order_error.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// A line of sight that meets two triangles of which no order is right all over a picture: they cross there, or lie before each other
/// in turns.
struct CrossingSample {
  std::uint32_t view = 0;
  std::uint32_t near = 0, far = 0;  ///< Triangles of the surface.
  Eigen::Vector3f near_point, far_point;
  float weight = 0;  ///< Squared error of the pixel where these two alone are swapped.
};

/// What no order of whole triangles can draw, seen from all sides at rest.
struct SeenCrossings {
  std::vector<CrossingSample> samples;  ///< By view.
  std::size_t pairs = 0;                ///< Of triangles, each counted once for all views.
  double unavoidable =
      0;            ///< What any order loses of all weights, since it draws one of two triangles first everywhere.
  double lost = 0;  ///< What the orders lose, that included.
};

/// Looks at the hair along as many lines, from as many sides and with the threads that `settings` say. `orders`: of all triangles.
[[nodiscard]] SeenCrossings find_seen_crossings(const HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                                                const CellOrders& orders, const DrawRule& rule,
                                                const SampleSettings& settings);

}  // namespace coif
