// Heads whose hair has other dynamics than the rest of the crowd. Each set has its own coefficients, and its heads blocks of their own.

#include <coif/hair.h>

#include "crowd_step.h"

namespace coif {
namespace {

bool same(const DynamicsScale& a, const DynamicsScale& b) {
  return a.stiffness == b.stiffness && a.damping == b.damping && a.friction == b.friction;
}

std::uint32_t set_count(const CrowdState& crowd) {
  return crowd.set_scales.empty() ? 1 : std::uint32_t(crowd.set_scales.size());
}

}  // namespace

Status Hair::set_dynamics(std::uint32_t set, const DynamicsScale& scale) {
  if (crowd_ == nullptr) return Status::kNotCreated;
  if (crowd_->set_scales.empty() || set >= set_count(*crowd_)) return Status::kNotAsked;
  if (!fits(scale)) return Status::kBadArgument;
  if (same(crowd_->set_scales[set], scale)) return Status::kOk;
  crowd_->set_scales[set] = scale;
  for (std::uint32_t instance = 0; instance < crowd_->instance_count(); ++instance) {
    if (crowd_->sets[instance] == set && crowd_->details[instance].asleep) wake(*crowd_, instance);
  }
  return Status::kOk;
}

Status Hair::choose_dynamics(std::uint32_t instance, std::uint32_t set) {
  if (block_of(crowd_, instance) == nullptr) return missing(crowd_);
  if (set >= set_count(*crowd_)) return Status::kNotAsked;
  if (crowd_->sets.empty() || crowd_->sets[instance] == set) return Status::kOk;
  const bool differs = !same(crowd_->set_scales[set], crowd_->set_scales[crowd_->sets[instance]]);
  crowd_->sets[instance] = std::uint8_t(set);
  if (differs && crowd_->details[instance].asleep) wake(*crowd_, instance);
  sort_in(*crowd_, instance);
  return Status::kOk;
}

}  // namespace coif
