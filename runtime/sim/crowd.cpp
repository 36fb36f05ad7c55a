#include "crowd.h"

#include "vector_math.h"

namespace coif {
namespace {

void stand_still(HeadLanes& heads, std::uint32_t i) {
  set_lane(heads.rotation, i, lane(heads.next_rotation, i));
  for (Lanes3* const vector :
       {&heads.way, &heads.velocity, &heads.angular_velocity, &heads.mean_velocity, &heads.mean_angular_velocity}) {
    set_lane(*vector, i, Vec3{});
  }
  heads.last_dt.v[i] = 0.0f;
  heads.quiet.v[i] = 0.0f;
}

}  // namespace

void put_to_rest(CrowdState& crowd, std::uint32_t slot) {
  Block& block = crowd.blocks[slot / kLanes];
  const std::uint32_t i = slot % kLanes;
  const auto keep = std::uint16_t(~(1u << i));
  block.teleports &= keep;
  block.is_lost &= keep;
  block.may_sleep &= keep;
  stand_still(block.heads, i);
  const Quat rotation = lane(block.heads.rotation, i);
  for_each_chain(crowd, slot,
                 [&](const ChainRecord&, const ChainLane& chain) { crowd.solver->put_to_rest(chain, rotation); });
  for (Mat34& matrix : crowd.palette(block.instance[i])) matrix = Mat34{};
}

void come_into_view(CrowdState& crowd, std::uint32_t slot) {
  Block& block = crowd.blocks[slot / kLanes];
  const std::uint32_t i = slot % kLanes;
  const Quat turn = lane(block.heads.next_rotation, i) * conjugate(lane(block.heads.rotation, i));
  turn_hair(crowd, slot, turn);
  for_each_chain(crowd, slot, [&](const ChainRecord&, const ChainLane& chain) { crowd.solver->calm(chain); });
  stand_still(block.heads, i);
  block.is_lost = std::uint16_t(block.is_lost & ~(1u << i));
}

void turn_hair(CrowdState& crowd, std::uint32_t slot, const Quat& by) {
  for_each_chain(crowd, slot, [&](const ChainRecord&, const ChainLane& chain) { crowd.solver->turn(chain, by); });
}

}  // namespace coif
