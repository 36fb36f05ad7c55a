// The air that hosts set: around each head, and gusts.

#include <coif/hair.h>

#include "crowd_step.h"
#include "float_environment.h"
#include "vector_math.h"

namespace coif {
namespace {

bool same_air(const HeadAir& a, const HeadAir& b) { return a.wind == b.wind && a.exposure == b.exposure; }

bool same_gusts(const Gusts& a, const Gusts& b) {
  return a.amplitude == b.amplitude && a.length == b.length && a.speed == b.speed && a.direction == b.direction &&
         a.seed == b.seed;
}

}  // namespace

Status Hair::set_air(std::uint32_t instance, const HeadAir& air) {
  if (block_of(crowd_, instance) == nullptr) return missing(crowd_);
  if (crowd_->character.airs.empty()) return Status::kNotAsked;
  if (!is_finite(air.wind) || !(air.exposure >= 0.0f && air.exposure <= 1.0f)) return Status::kBadArgument;
  HeadAir& told = crowd_->character.airs[instance];
  if (same_air(told, air)) return Status::kOk;
  told = air;
  if (crowd_->details[instance].asleep) wake(*crowd_, instance);
  return Status::kOk;
}

Status Hair::set_gusts(const Gusts& gusts) {
  if (crowd_ == nullptr) return Status::kNotCreated;
  if (crowd_->character.gusts.empty()) return Status::kNotAsked;
  if (!are_gusts(gusts)) return Status::kBadArgument;
  GustField& field = crowd_->character.gusts[0];
  if (same_gusts(field.told, gusts)) return Status::kOk;
  const FloatEnvironment plain;
  const bool blow = field.told.amplitude != 0.0f || gusts.amplitude != 0.0f;
  field.told = gusts;
  field.waves = waves_of(gusts);
  for (std::uint32_t instance = 0; blow && instance < crowd_->instance_count(); ++instance) {
    if (crowd_->details[instance].asleep) wake(*crowd_, instance);
  }
  return Status::kOk;
}

double Hair::gusts_way() const {
  return crowd_ == nullptr || crowd_->character.gusts.empty() ? 0.0 : crowd_->character.gusts[0].way;
}

}  // namespace coif
