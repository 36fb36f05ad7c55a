// The level of detail of heads. A file of its own, so that programs that never set it do not link it.

#include <coif/hair.h>

#include "crowd_step.h"
#include "float_environment.h"
#include "vector_math.h"

namespace coif {

void come_into_view(CrowdState& crowd, std::uint32_t slot) {
  Block& block = crowd.blocks[slot / kLanes];
  const std::uint32_t i = slot % kLanes;
  const Quat turn = lane(block.heads.next_rotation, i) * conjugate(lane(block.heads.rotation, i));
  turn_hair(crowd, slot, turn);
  for_each_chain(crowd, slot,
                 [](const Solver& solver, const ChainRecord&, const ChainLane& chain) { solver.calm(chain); });
  stand_still(crowd, slot);
  block.is_lost = std::uint16_t(block.is_lost & ~(1u << i));
}

Status Hair::set_detail(std::uint32_t instance, const Detail& detail) {
  if (block_of(crowd_, instance) == nullptr) return missing(crowd_);
  if (detail.level >= levels_of(crowd_->asset) || !is_interval(detail.interval)) return Status::kBadArgument;
  if (power_of(detail.interval) >= crowd_->interval_count) return Status::kBadArgument;
  InstanceDetail& own = crowd_->details[instance];
  const bool appears = detail.simulated && !own.simulated;
  const bool refines = detail.level < own.level;
  own.level = std::uint8_t(detail.level);
  own.asked_power = std::uint8_t(power_of(detail.interval));
  take_up_interval(*crowd_, instance);  // With its treatment as it was; if it becomes idle, the next step takes it up.
  own.simulated = detail.simulated;
  // Bones that were rigid have to find their own rest.
  if (own.asleep && (appears || refines)) wake(*crowd_, instance);
  sort_in(*crowd_, instance);
  const FloatEnvironment plain;
  if (appears) come_into_view(*crowd_, crowd_->slots[instance]);
  return Status::kOk;
}

bool Hair::is_asleep(std::uint32_t instance) const {
  return block_of(crowd_, instance) != nullptr && crowd_->details[instance].asleep;
}

}  // namespace coif
