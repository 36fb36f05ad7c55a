#include "solver.h"
#include "vector_math.h"

namespace coif {

void tails_of_palette(const ChainLane& chain, const Quat&, std::span<const Mat34> palette, std::span<Vec3> ends) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    const BoneLanes& bone = chain.constants[i];
    const float length = bone.length.v[chain.constant_lane];
    const Vec3 rest = lane(bone.joint, chain.constant_lane) + lane(bone.rest, chain.constant_lane) * length;
    const auto row = [&](int k) {
      const float* const m = palette[i].m[k];
      return m[0] * rest.x + m[1] * rest.y + m[2] * rest.z + m[3];
    };
    ends[i] = {row(0), row(1), row(2)};
  }
}

}  // namespace coif
