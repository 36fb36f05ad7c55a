#include "report/solvers/segment_spring.h"

namespace coif {

std::vector<double> segment_springs(const Rig& rig) {
  constexpr double kEarth = 9.81;
  std::vector<double> carried(rig.bones.size(), 1.0);
  for (std::size_t i = rig.bones.size(); i-- > 0;) {  // Parents come first, so children have been counted.
    if (rig.bones[i].parent >= 0) carried[std::size_t(rig.bones[i].parent)] += carried[i];
  }
  std::vector<double> springs(rig.bones.size());
  for (std::size_t i = 0; i < springs.size(); ++i) {
    springs[i] = carried[i] * kEarth / (kSpringStretch * rig.bones[i].length);
  }
  return springs;
}

}  // namespace coif
