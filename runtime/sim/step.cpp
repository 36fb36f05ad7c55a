// A step in parts, as hosts call them.

#include <coif/hair_world.h>

#include "float_environment.h"
#include "world_step.h"

namespace coif {

Status HairWorld::begin_step(const StepSettings& settings) {
  if (world_ == nullptr) return Status::kNotCreated;
  world_->job_count = 0;
  world_->is_in_step = false;
  const FloatEnvironment plain;
  if (const Status status = check_settings(settings); status != Status::kOk) return status;
  coif::begin_step(*world_, settings);
  return Status::kOk;
}

std::uint32_t HairWorld::job_count() const { return world_ == nullptr ? 0 : world_->job_count; }

void HairWorld::run_job(std::uint32_t job) {
  const FloatEnvironment plain;
  if (job < job_count()) coif::run_job(*world_, job);
}

void HairWorld::finish_step() {
  if (world_ == nullptr || !world_->is_in_step) return;
  const FloatEnvironment plain;
  coif::finish_step(*world_);
}

Status HairWorld::step(const StepSettings& settings) {
  if (const Status status = begin_step(settings); status != Status::kOk) return status;
  for (std::uint32_t job = 0; job < job_count(); ++job) run_job(job);
  finish_step();
  return Status::kOk;
}

std::span<const Mat34> HairWorld::palette(WorldHead head) const {
  const WornHead* const worn = find(world_, head);
  return worn == nullptr ? std::span<const Mat34>{} : world_->palette(*worn);
}

Status step_all(std::span<Hair* const> crowds, const StepSettings& settings) {
  for (Hair* const hair : crowds) {
    if (const Status status = hair->step(settings); status != Status::kOk) return status;
  }
  return Status::kOk;
}

}  // namespace coif
