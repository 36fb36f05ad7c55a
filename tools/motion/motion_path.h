#pragma once
// The built-in motions as formulas in time.

#include "motion/head_path.h"
#include "motion/jet.h"

namespace coif {

/// A movement that turns about one axis.
struct HeadMovement {
  Jet x, y, z;                                      ///< Metres.
  Jet turn;                                         ///< Radians about `axis`.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();  ///< Unit, the same for all times.
};

/// At `seconds`, by the piece of the motion that `inside` lies in; both >= 0.
[[nodiscard]] HeadMovement movement(Motion motion, double seconds, double inside);

/// As HeadPath::breaks().
[[nodiscard]] std::vector<PathBreak> breaks_of(Motion motion, double until);

}  // namespace coif
