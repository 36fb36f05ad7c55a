// Steps some heads while the others and the world's clock stand still.

#include <coif/hair.h>

#include "float_environment.h"
#include "vector_math.h"
#include "world_step.h"

#include <cmath>

namespace coif {
namespace {

constexpr float kSettlingStep = 1.0f / 60;

/// Everything of a world that a step changes, except the heads that it steps.
struct Clock {
  explicit Clock(const WorldState& world)
      : settings(world.settings), step_index(world.step_index), has_asked(world.has_asked) {
    for (std::uint32_t i = 0; i < kMaxInterval; ++i) dts[i] = world.last_dts[i];
    if (!world.gusts.empty()) gusts_way = world.gusts[0].way;
  }
  void put_back(WorldState& world) const {
    world.settings = settings;
    world.step_index = step_index;
    world.has_asked = has_asked;
    for (std::uint32_t i = 0; i < kMaxInterval; ++i) world.last_dts[i] = dts[i];
    if (!world.gusts.empty()) world.gusts[0].way = gusts_way;
    world.job_count = 0;
  }
  StepSettings settings;
  std::uint32_t step_index;
  bool has_asked;
  float dts[kMaxInterval] = {};
  double gusts_way = 0;
};

/// Bits of HeadDetail::asked_power that keep a head's detail while others settle. No step reads that member unless
/// world.has_asked is set.
enum Kept : std::uint8_t { kAskedBits = 0x03, kWasSimulated = 0x10, kWasAsleep = 0x20, kSettles = 0x40 };
constexpr std::uint32_t kIntervalAt = 2;

void keep(HeadDetail& detail) {
  const std::uint32_t simulated = detail.simulated ? kWasSimulated : 0, asleep = detail.asleep ? kWasAsleep : 0;
  detail.asked_power =
      std::uint8_t(detail.asked_power | std::uint32_t(detail.interval_power) << kIntervalAt | simulated | asleep);
  detail.simulated = false;
}

void put_back(HeadDetail& detail) {
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

/// Wakes the head and steps it in every step, at its last pose.
void begin_settling(WorldState& world, std::uint32_t index) {
  WornHead& head = world.heads[index];
  head.detail.asked_power = std::uint8_t(head.detail.asked_power | kSettles);
  head.detail.interval_power = 0;
  head.detail.simulated = true;
  head.detail.asleep = false;
  clear_bit(head.block->teleports, head.lane);
  head.block->heads.quiet.v[head.lane] = 0.0f;
}

bool settles(const HeadDetail& detail) { return (detail.asked_power & kSettles) != 0; }

void end_settling(HeadDetail& detail, bool may_sleep) {
  const bool has_settled = settles(detail), was_asleep = (detail.asked_power & kWasAsleep) != 0;
  put_back(detail);
  detail.asleep = has_settled ? detail.asleep && may_sleep : was_asleep;
}

/// Jobs do not say so: a head without chains has none, and takes its time to fall asleep all the same.
bool are_all_idle(const WorldState& world) {
  for (const Crowd& crowd : world.crowds) {
    if (crowd.users == 0) continue;
    for (const TreatedHeads& list : crowd.lists.subspan(kIdle + 1)) {
      if (list.blocks.first != nullptr) return false;
    }
  }
  return true;
}

void run_steps(WorldState& world, std::uint32_t count, const StepSettings& settings) {
  world.settings = settings;  // So that nobody wakes because the settings changed.
  world.has_asked = false;
  for (GustField& field : world.gusts) field.way -= double(field.told.speed) * double(kSettlingStep) * count;
  for (std::uint32_t i = 0; i < count && !are_all_idle(world); ++i) {
    begin_step(world, settings);
    for (std::uint32_t job = 0; job < world.job_count; ++job) run_job(world, job);
    finish_step(world);
  }
}

/// `head_at(i)` is the number of the i-th of `count` heads to settle; all are there.
template <typename HeadAt>
Status settle(WorldState& world, std::size_t count, const HeadAt& head_at, float seconds,
              const StepSettings& settings) {
  if (!(seconds >= 0.0f && seconds <= kLongestSettling)) return Status::kBadTimeStep;
  StepSettings steps = settings;
  steps.dt = kSettlingStep;
  if (const Status status = check_settings(steps); status != Status::kOk) return status;
  if (count == 0) return Status::kOk;

  const Clock clock(world);
  for_each_head(world, [&](std::uint32_t head) { keep(world.heads[head].detail); });
  for (std::size_t i = 0; i < count; ++i) {
    if (!settles(world.heads[head_at(i)].detail)) begin_settling(world, head_at(i));
  }
  for_each_head(world, [&](std::uint32_t head) { sort_in(world, head); });
  for_each_head(world, [&](std::uint32_t head) {
    const WornHead& worn = world.heads[head];
    if (settles(worn.detail) && !stands(*worn.block, worn.lane)) come_into_view(world, head);
  });
  run_steps(world, std::uint32_t(std::ceil(seconds / kSettlingStep - 1e-3f)), steps);
  clock.put_back(world);
  const bool may_sleep = clock.step_index != 0 && rests_under_both(clock.settings, steps);
  for_each_head(world, [&](std::uint32_t head) { end_settling(world.heads[head].detail, may_sleep); });
  for_each_head(world, [&](std::uint32_t head) { sort_in(world, head); });
  return Status::kOk;
}

}  // namespace

Status HairWorld::settle(std::span<const WorldHead> heads, float seconds, const StepSettings& settings) {
  if (world_ == nullptr) return Status::kNotCreated;
  const FloatEnvironment plain;
  for (const WorldHead head : heads) {
    if (find(world_, head) == nullptr) return Status::kBadIndex;
  }
  const auto head_at = [&](std::size_t i) { return heads[i].index; };
  return coif::settle(*world_, heads.size(), head_at, seconds, settings);
}

Status Hair::settle(std::span<const std::uint32_t> instances, float seconds, const StepSettings& settings) {
  WorldState* const world = world_.world_;
  if (world == nullptr) return Status::kNotCreated;
  const FloatEnvironment plain;
  for (const std::uint32_t instance : instances) {
    if (instance >= instance_count()) return Status::kBadIndex;
  }
  return coif::settle(
      *world, instances.size(), [&](std::size_t i) { return instances[i]; }, seconds, settings);
}

}  // namespace coif
