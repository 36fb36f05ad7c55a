// The air that hosts set: around each head, and gusts.

#include <coif/hair.h>

#include "float_environment.h"
#include "rules.h"
#include "vector_math.h"
#include "world_heads.h"

namespace coif {
namespace {

bool same_air(const HeadAir& a, const HeadAir& b) { return a.wind == b.wind && a.exposure == b.exposure; }

bool same_gusts(const Gusts& a, const Gusts& b) {
  return a.amplitude == b.amplitude && a.length == b.length && a.speed == b.speed && a.direction == b.direction &&
         a.seed == b.seed;
}

}  // namespace

Status HairWorld::set_air(WorldHead head, const HeadAir& air) {
  if (find(world_, head) == nullptr) return missing(world_);
  if (world_->airs.empty()) return Status::kNotAsked;
  const FloatEnvironment plain;
  if (const Status status = check(air); status != Status::kOk) return status;
  HeadAir& told = world_->airs[head.index];
  if (same_air(told, air)) return Status::kOk;
  told = air;
  wake_if_asleep(*world_, head.index);
  return Status::kOk;
}

Status HairWorld::set_gusts(const Gusts& gusts) {
  if (world_ == nullptr) return Status::kNotCreated;
  if (world_->gusts.empty()) return Status::kNotAsked;
  const FloatEnvironment plain;
  if (!are_gusts(gusts)) return Status::kBadArgument;
  GustField& field = world_->gusts[0];
  if (same_gusts(field.told, gusts)) return Status::kOk;
  const bool blow = field.told.amplitude != 0.0f || gusts.amplitude != 0.0f;
  field.told = gusts;
  field.waves = waves_of(gusts);
  if (blow) for_each_head(*world_, [&](std::uint32_t head) { wake_if_asleep(*world_, head); });
  return Status::kOk;
}

double HairWorld::gusts_way() const { return world_ == nullptr || world_->gusts.empty() ? 0.0 : world_->gusts[0].way; }

}  // namespace coif
