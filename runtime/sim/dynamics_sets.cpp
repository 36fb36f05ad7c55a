// Heads whose hair has other dynamics than the rest. Each set has its own coefficients.

#include <coif/hair.h>

#include "float_environment.h"
#include "world_heads.h"

namespace coif {

Status HairWorld::set_dynamics(std::uint32_t set, const DynamicsScale& scale) {
  if (world_ == nullptr) return Status::kNotCreated;
  if (world_->rules.sets == 1 || set >= world_->rules.sets) return Status::kNotAsked;
  const FloatEnvironment plain;
  if (!fits(scale)) return Status::kBadArgument;
  DynamicsScale& told = world_->dynamics_sets[set];
  if (same(told, scale)) return Status::kOk;
  told = scale;
  for_each_head(*world_, [&](std::uint32_t head) {
    if (world_->heads[head].set == set) wake_if_asleep(*world_, head);
  });
  return Status::kOk;
}

Status HairWorld::choose_dynamics(WorldHead head, std::uint32_t set) {
  WornHead* const worn = find(world_, head);
  if (worn == nullptr) return missing(world_);
  const std::span<const DynamicsScale> all = world_->dynamics_sets;
  if (set >= all.size()) return Status::kNotAsked;
  if (worn->set == set) return Status::kOk;
  const FloatEnvironment plain;
  const bool differs = !same(all[set], all[worn->set]);
  const bool has_lanes = worn->has_lanes;
  if (has_lanes) world_->shared->leave_lanes(*world_, head.index);
  worn->set = std::uint8_t(set);
  if (has_lanes) world_->shared->enter(*world_, head.index);
  if (differs) wake_if_asleep(*world_, head.index);
  sort_in(*world_, head.index);
  return Status::kOk;
}

}  // namespace coif
