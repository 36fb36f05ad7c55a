#include "motion/head_looks.h"

#include "base/geometry.h"

namespace coif::motion {

std::span<const HeadLook> head_looks() {
  static const HeadLook kLooks[] = {{"look-down", "looking down", Eigen::Vector3d::UnitX(), 55, 0.4},
                                    {"look-aside", "a rapid turn", Eigen::Vector3d::UnitY(), 80, 0.25},
                                    {"look-up", "looking up", Eigen::Vector3d::UnitX(), -50, 0.4}};
  return kLooks;
}

std::unique_ptr<HeadPath> path_of(const HeadLook& look) {
  return held_turn(look.axis, look.degrees * kDegree, look.seconds);
}

}  // namespace coif::motion
