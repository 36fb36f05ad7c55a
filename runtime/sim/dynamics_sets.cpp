// Heads whose hair has other dynamics than the rest of the crowd. Each set has its own coefficients, and its heads have
// blocks of their own.

#include <coif/hair.h>

#include "crowd_step.h"

namespace coif {
Status Hair::set_dynamics(std::uint32_t set, const DynamicsScale& scale) {
  if (crowd_ == nullptr) return Status::kNotCreated;
  if (crowd_->sets.empty() || set >= crowd_->dynamics_sets.size()) return Status::kNotAsked;
  if (!fits(scale)) return Status::kBadArgument;
  DynamicsScale& told = crowd_->dynamics_sets[set].scale;
  if (same(told, scale)) return Status::kOk;
  told = scale;
  for (std::uint32_t instance = 0; instance < crowd_->instance_count(); ++instance) {
    if (crowd_->sets[instance] == std::byte(set) && crowd_->details[instance].asleep) wake(*crowd_, instance);
  }
  return Status::kOk;
}

Status Hair::choose_dynamics(std::uint32_t instance, std::uint32_t set) {
  if (block_of(crowd_, instance) == nullptr) return missing(crowd_);
  const std::span<const DynamicsSet> all = crowd_->dynamics_sets;
  if (set >= all.size()) return Status::kNotAsked;
  if (crowd_->sets.empty() || crowd_->sets[instance] == std::byte(set)) return Status::kOk;
  const bool differs = !same(all[set].scale, all[std::size_t(crowd_->sets[instance])].scale);
  crowd_->sets[instance] = std::byte(set);
  if (differs && crowd_->details[instance].asleep) wake(*crowd_, instance);
  sort_in(*crowd_, instance);
  return Status::kOk;
}

}  // namespace coif
