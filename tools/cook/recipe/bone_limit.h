#pragma once

// The recipe's limits of bones' directions.

#include <array>
#include <string>
#include <vector>

namespace coif::cook {

/// A limit around the direction in which a bone was modelled. The kinds are described at LimitRecord.
struct RecipeBoneLimit {
  std::vector<std::string> bones;       ///< Patterns with * and ?, letters of either case.
  std::string kind;                     ///< "cone", "hinge", "spherical" or "none".
  double angle = 0;                     ///< Degrees. Cone and hinge: to either side. Spherical limit: its pitch.
  double yaw = 0;                       ///< Degrees, of a spherical limit, 0..90.
  std::array<double, 3> axis{1, 0, 0};  ///< Model space: the axis of a hinge or of the pitch; not 0.
};

}  // namespace coif::cook
