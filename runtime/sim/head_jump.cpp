#include "head_jump.h"

#include "rotation_vector.h"
#include "vector_math.h"

namespace coif {

void jump(CrowdState& crowd, std::uint32_t slot, float dt) {
  HeadLanes& heads = crowd.blocks[slot / kLanes].heads;
  const std::uint32_t i = slot % kLanes;
  const Quat now = lane(heads.rotation, i);
  const Quat expected = rotation_by(lane(heads.angular_velocity, i) * dt) * now;
  const Quat turn = renormalised(lane(heads.next_rotation, i) * conjugate(expected));
  for (Lanes3* const velocity :
       {&heads.velocity, &heads.angular_velocity, &heads.mean_velocity, &heads.mean_angular_velocity}) {
    set_lane(*velocity, i, rotate(turn, lane(*velocity, i)));
  }
  set_lane(heads.rotation, i, renormalised(turn * now));
  set_lane(heads.way, i, lane(heads.velocity, i) * dt);
  turn_hair(crowd, slot, turn);
}

}  // namespace coif
