// Steps some heads of a crowd while the others and the crowd's clock stand still.

#include <coif/hair.h>

#include "crowd_step.h"
#include "float_environment.h"
#include "vector_math.h"

#include <cmath>

namespace coif {
namespace {

constexpr float kSettlingStep = 1.0f / 60;

/// Everything of a crowd that a step changes, except the heads that it steps.
struct Clock {
  explicit Clock(const CrowdState& crowd)
      : settings(crowd.settings), step_index(crowd.step_index), has_asked(crowd.has_asked) {
    for (std::uint32_t i = 0; i < kMaxInterval; ++i) dts[i] = crowd.last_dts[i];
    if (!crowd.character.gusts.empty()) gusts_way = crowd.character.gusts[0].way;
  }
  void put_back(CrowdState& crowd) const {
    crowd.settings = settings;
    crowd.step_index = step_index;
    crowd.has_asked = has_asked;
    for (std::uint32_t i = 0; i < kMaxInterval; ++i) crowd.last_dts[i] = dts[i];
    if (!crowd.character.gusts.empty()) crowd.character.gusts[0].way = gusts_way;
    crowd.job_count = 0;
  }
  StepSettings settings;
  std::uint32_t step_index;
  bool has_asked;
  float dts[kMaxInterval] = {};
  double gusts_way = 0;
};

/// Bits of InstanceDetail::asked_power that keep an instance's detail while others settle. No step reads that member
/// unless crowd.has_asked is set.
enum Kept : std::uint8_t { kAskedBits = 0x03, kWasSimulated = 0x10, kWasAsleep = 0x20, kSettles = 0x40 };
constexpr std::uint32_t kIntervalAt = 2;

void keep(InstanceDetail& detail) {
  const std::uint32_t simulated = detail.simulated ? kWasSimulated : 0, asleep = detail.asleep ? kWasAsleep : 0;
  detail.asked_power =
      std::uint8_t(detail.asked_power | std::uint32_t(detail.interval_power) << kIntervalAt | simulated | asleep);
  detail.simulated = false;
}

void put_back(InstanceDetail& detail) {
  const std::uint8_t kept = detail.asked_power;
  detail.simulated = (kept & kWasSimulated) != 0;
  detail.interval_power = kept >> kIntervalAt & kAskedBits;
  detail.asked_power = kept & kAskedBits;
}

bool stands(const Block& block, std::uint32_t i) {
  const HeadLanes& heads = block.heads;
  const bool is_there = lane(heads.way, i) == Vec3{} && lane(heads.rotation, i) == lane(heads.next_rotation, i);
  const bool is_still = lane(heads.velocity, i) == Vec3{} && lane(heads.angular_velocity, i) == Vec3{} &&
                        lane(heads.mean_velocity, i) == Vec3{} && lane(heads.mean_angular_velocity, i) == Vec3{};
  return is_there && is_still && ((block.is_lost >> i) & 1u) == 0;
}

/// Wakes the instance and steps it in every step, at its last pose.
void begin_settling(CrowdState& crowd, std::uint32_t instance) {
  InstanceDetail& detail = crowd.details[instance];
  detail.asked_power = std::uint8_t(detail.asked_power | kSettles);
  detail.interval_power = 0;
  detail.simulated = true;
  detail.asleep = false;
  const std::uint32_t slot = crowd.slots[instance], i = slot % kLanes;
  Block& block = crowd.blocks[slot / kLanes];
  block.teleports = std::uint16_t(block.teleports & ~(1u << i));
  block.heads.quiet.v[i] = 0.0f;
  if (!stands(block, i)) come_into_view(crowd, slot);
}

void end_settling(CrowdState& crowd, std::uint32_t instance, bool may_sleep) {
  InstanceDetail& detail = crowd.details[instance];
  const bool settles = (detail.asked_power & kSettles) != 0;
  const bool was_asleep = (detail.asked_power & kWasAsleep) != 0;
  put_back(detail);
  detail.asleep = settles ? detail.asleep && may_sleep : was_asleep;
}

void run_steps(CrowdState& crowd, std::uint32_t count, const StepSettings& settings) {
  crowd.settings = settings;  // So that nobody wakes because the settings changed.
  crowd.has_asked = false;
  if (!crowd.character.gusts.empty()) {
    GustField& field = crowd.character.gusts[0];
    field.way -= double(field.told.speed) * double(kSettlingStep) * count;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    begin_step(crowd, settings);
    if (crowd.job_count == 0) return;
    for (std::uint32_t job = 0; job < crowd.job_count; ++job) step_block(crowd, crowd.jobs[job]);
    finish_step(crowd);
  }
}

}  // namespace

Status Hair::settle(std::span<const std::uint32_t> instances, float seconds, const StepSettings& settings) {
  if (crowd_ == nullptr) return Status::kNotCreated;
  CrowdState& crowd = *crowd_;
  for (const std::uint32_t instance : instances) {
    if (instance >= crowd.instance_count()) return Status::kBadIndex;
  }
  if (!(seconds >= 0.0f && seconds <= kLongestSettling)) return Status::kBadTimeStep;
  StepSettings steps = settings;
  steps.dt = kSettlingStep;
  if (const Status status = check_settings(steps); status != Status::kOk) return status;
  if (instances.empty()) return Status::kOk;

  const FloatEnvironment plain;
  const Clock clock(crowd);
  const std::uint32_t all = crowd.instance_count();
  for (InstanceDetail& detail : crowd.details) keep(detail);
  for (const std::uint32_t instance : instances) {
    if ((crowd.details[instance].asked_power & kSettles) == 0) begin_settling(crowd, instance);
  }
  for (std::uint32_t instance = 0; instance < all; ++instance) sort_in(crowd, instance);
  run_steps(crowd, std::uint32_t(std::ceil(seconds / kSettlingStep - 1e-3f)), steps);
  clock.put_back(crowd);
  const bool may_sleep = clock.step_index != 0 && rests_under_both(clock.settings, steps);
  for (std::uint32_t instance = 0; instance < all; ++instance) end_settling(crowd, instance, may_sleep);
  for (std::uint32_t instance = 0; instance < all; ++instance) sort_in(crowd, instance);
  return Status::kOk;
}

}  // namespace coif
