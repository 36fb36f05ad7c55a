#pragma once

#include "motion/head_path.h"

#include <memory>
#include <span>

namespace coif::motion {

/// A turn of the head that stays where it ends, unlike the built-in motions: what the thesis's gallery of motion shows.
struct HeadLook {
  const char* name;     ///< As the page of `coif view` calls it.
  const char* caption;  ///< "looking down"
  Eigen::Vector3d axis;
  double degrees;
  double seconds;
};

[[nodiscard]] std::span<const HeadLook> head_looks();
[[nodiscard]] std::unique_ptr<HeadPath> path_of(const HeadLook& look);

}  // namespace coif::motion
