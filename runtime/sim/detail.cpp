// The level of detail of heads. A file of its own, so that programs that never set it do not link it.

#include <coif/hair.h>

#include "float_environment.h"
#include "vector_math.h"
#include "world_heads.h"

namespace coif {

void come_into_view(WorldState& world, std::uint32_t index) {
  const WornHead& head = world.heads[index];
  const HeadLanes& heads = head.block->heads;
  turn_hair(world, index, lane(heads.next_rotation, head.lane) * conjugate(lane(heads.rotation, head.lane)));
  for_each_chain(world, index, [](const Solver& solver, std::uint32_t, const ChainLane& chain) { solver.calm(chain); });
  stand_still(world, index);
  clear_bit(head.block->is_lost, head.lane);
}

Status HairWorld::set_detail(WorldHead head, const Detail& detail) {
  WornHead* const worn = find(world_, head);
  if (worn == nullptr) return missing(world_);
  if (detail.level >= levels_of(world_->worn_by(*worn).asset) || !is_interval(detail.interval)) {
    return Status::kBadArgument;
  }
  if (power_of(detail.interval) >= world_->rules.intervals) return Status::kBadArgument;
  const FloatEnvironment plain;
  HeadDetail& own = worn->detail;
  const bool appears = detail.simulated && !own.simulated;
  const bool refines = detail.level < own.level;
  own.level = std::uint8_t(detail.level);
  own.asked_power = std::uint8_t(power_of(detail.interval));
  take_up_interval(*world_, head.index);  // As it was; if it becomes idle, the next step takes it up.
  own.simulated = detail.simulated;
  // Bones that were rigid have to find their own rest.
  if (own.asleep && (appears || refines)) wake(*world_, head.index);
  sort_in(*world_, head.index);
  if (appears) come_into_view(*world_, head.index);
  return Status::kOk;
}

bool HairWorld::is_asleep(WorldHead head) const {
  const WornHead* const worn = find(world_, head);
  return worn != nullptr && worn->detail.asleep;
}

}  // namespace coif
