#pragma once

// What a recipe says of the directions that bones may have.

#include <array>
#include <string>
#include <vector>

namespace coif::cook {

/// A limit around the direction in which a bone was modelled. What the kinds bound: LimitRecord.
struct RecipeBoneLimit {
  std::vector<std::string> bones;       ///< Patterns with * and ?, letters of either case.
  std::string kind;                     ///< "cone", "hinge", "spherical" or "none".
  double angle = 0;                     ///< Degrees: of a cone or hinge to either side; of a spherical limit its pitch.
  double yaw = 0;                       ///< Degrees, of a spherical limit, 0..90.
  std::array<double, 3> axis{1, 0, 0};  ///< Model space: what a hinge turns about, and the pitch; not 0.
};

}  // namespace coif::cook
