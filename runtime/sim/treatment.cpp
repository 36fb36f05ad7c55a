#include "crowd_step.h"

#include <bit>
#include <utility>

namespace coif {
namespace {

/// Swaps lane `i` of `a` with lane `k` of `b`; both have `bytes` bytes of Lanes.
void swap_lanes(void* a, std::uint32_t i, void* b, std::uint32_t k, std::size_t bytes) {
  Lanes* const from = static_cast<Lanes*>(a);
  Lanes* const to = static_cast<Lanes*>(b);
  for (std::size_t n = 0; n < bytes / sizeof(Lanes); ++n) std::swap(from[n].v[i], to[n].v[k]);
}

void swap_bits(std::uint16_t& a, std::uint32_t i, std::uint16_t& b, std::uint32_t k) {
  const std::uint32_t differ = ((a >> i) ^ (b >> k)) & 1u;
  a = std::uint16_t(a ^ (differ << i));
  b = std::uint16_t(b ^ (differ << k));
}

void swap_heads(Block& a, std::uint32_t i, Block& b, std::uint32_t k) {
  constexpr std::size_t kFloats = offsetof(HeadLanes, next_position);
  swap_lanes(&a.heads, i, &b.heads, k, kFloats);
  for (int axis = 0; axis < 3; ++axis) std::swap(a.heads.next_position[axis][i], b.heads.next_position[axis][k]);
  swap_bits(a.teleports, i, b.teleports, k);
  swap_bits(a.is_lost, i, b.is_lost, k);
  swap_bits(a.may_sleep, i, b.may_sleep, k);
  std::swap(a.instance[i], b.instance[k]);
}

/// Does nothing for kChains, where an instance's rows stay where they are.
void swap_states(CrowdState& crowd, std::uint32_t a, std::uint32_t b) {
  const std::size_t bones = crowd.row_bone_count();
  if (crowd.order == LaneOrder::kChains || bones == 0) return;
  const std::size_t bytes = crowd.state_bytes, from = crowd.first_state(a), to = crowd.first_state(b);
  swap_lanes(&crowd.states[from * bytes], a % kLanes, &crowd.states[to * bytes], b % kLanes, bones * bytes);
  if (!crowd.character.poses.empty()) {
    PoseLanes* const poses = crowd.character.poses.data();
    swap_lanes(poses + from, a % kLanes, poses + to, b % kLanes, bones * sizeof(PoseLanes));
  }
  if (crowd.twists.empty()) return;
  swap_lanes(&crowd.twists[from], a % kLanes, &crowd.twists[to], b % kLanes, bones * sizeof(TwistState));
}

void swap_slots(CrowdState& crowd, std::uint32_t a, std::uint32_t b) {
  if (a == b) return;
  swap_heads(crowd.blocks[a / kLanes], a % kLanes, crowd.blocks[b / kLanes], b % kLanes);
  swap_states(crowd, a, b);
}

/// Adds an empty block to the end of the treatment's list.
std::uint32_t append_block(CrowdState& crowd, std::uint32_t treatment) {
  const std::uint32_t block = crowd.first_free;
  crowd.first_free = crowd.blocks[block].previous;
  crowd.blocks[block].previous = crowd.last_block[treatment];
  crowd.treatments[block] = treatment;
  crowd.last_block[treatment] = block;
  return block;
}

void remove_last_block(CrowdState& crowd, std::uint32_t treatment) {
  const std::uint32_t block = crowd.last_block[treatment];
  crowd.last_block[treatment] = crowd.blocks[block].previous;
  crowd.blocks[block].previous = crowd.first_free;
  crowd.treatments[block] = kIdle;
  crowd.first_free = block;
}

/// Number of phases of all intervals together: 1, 1 + 2, 1 + 2 + 4.
constexpr std::uint32_t phase_count(std::uint32_t intervals) { return (1u << intervals) - 1; }

bool ends_interval(const CrowdState& crowd, std::uint32_t phase, std::uint32_t power) {
  return ((crowd.step_index + phase) & ((1u << power) - 1u)) == 0;
}

bool has_room(const CrowdState& crowd, std::uint32_t block) {
  return block != kNone && crowd.blocks[block].count < kLanes;
}

}  // namespace

std::uint32_t treatment_count(std::uint32_t levels, std::uint32_t intervals, std::uint32_t sets) {
  return 1 + sets * levels * phase_count(intervals);
}

std::uint32_t block_count(std::uint32_t instances, std::uint32_t treatments) {
  // Each list has at most one block that is not full, and at least one head.
  const std::uint32_t lists = treatments < instances ? treatments : instances;
  return (instances + kLanes - 1) / kLanes + lists - 1;
}

std::uint32_t treatment_of(const CrowdState& crowd, std::uint32_t instance) {
  const InstanceDetail& detail = crowd.details[instance];
  if (!detail.simulated || detail.asleep) return kIdle;
  const std::uint32_t interval = 1u << detail.interval_power, phase = instance / kLanes % interval;
  const std::uint32_t set = crowd.sets.empty() ? 0 : std::uint32_t(crowd.sets[instance]);
  const std::uint32_t kind = detail.level * std::uint32_t(crowd.dynamics_sets.size()) + set;
  return 1 + kind * phase_count(crowd.interval_count) + (interval - 1) + phase;
}

std::uint32_t set_of(const CrowdState& crowd, std::uint32_t treatment) {
  return (treatment - 1) / phase_count(crowd.interval_count) % std::uint32_t(crowd.dynamics_sets.size());
}

std::uint32_t level_of(const CrowdState& crowd, std::uint32_t treatment) {
  return (treatment - 1) / phase_count(crowd.interval_count) / std::uint32_t(crowd.dynamics_sets.size());
}

std::uint32_t interval_power_of(const CrowdState& crowd, std::uint32_t treatment) {
  const std::uint32_t phase = (treatment - 1) % phase_count(crowd.interval_count);
  return std::uint32_t(std::bit_width(phase + 1)) - 1;
}

bool has_its_turn(const CrowdState& crowd, std::uint32_t treatment) {
  const std::uint32_t phase = (treatment - 1) % phase_count(crowd.interval_count);
  const std::uint32_t power = interval_power_of(crowd, treatment);
  return ends_interval(crowd, phase + 1 - (1u << power), power);
}

void take_up_interval(CrowdState& crowd, std::uint32_t instance) {
  InstanceDetail& detail = crowd.details[instance];
  const std::uint8_t longer = detail.asked_power > detail.interval_power ? detail.asked_power : detail.interval_power;
  // No time has passed for an instance that is not simulated, nor before the first step.
  const bool is_free = treatment_of(crowd, instance) == kIdle || crowd.step_index == 0;
  if (is_free || ends_interval(crowd, instance / kLanes, longer)) detail.interval_power = detail.asked_power;
  if (detail.interval_power != detail.asked_power) crowd.has_asked = true;
}

void fill_blocks(CrowdState& crowd) {
  for (std::uint32_t& last : crowd.last_block) last = kNone;
  const std::uint32_t blocks = std::uint32_t(crowd.blocks.size());
  crowd.first_free = 0;
  for (std::uint32_t i = 0; i < blocks; ++i) crowd.blocks[i].previous = i + 1 < blocks ? i + 1 : kNone;
  for (std::uint32_t instance = 0; instance < crowd.instance_count(); ++instance) {
    const std::uint32_t treatment = treatment_of(crowd, instance);
    std::uint32_t block = crowd.last_block[treatment];
    if (!has_room(crowd, block)) block = append_block(crowd, treatment);
    Block& to = crowd.blocks[block];
    crowd.slots[instance] = block * kLanes + to.count;
    to.instance[to.count++] = instance;
  }
}

void wake(CrowdState& crowd, std::uint32_t instance) {
  crowd.details[instance].asleep = false;
  const std::uint32_t slot = crowd.slots[instance];
  crowd.blocks[slot / kLanes].heads.quiet.v[slot % kLanes] = 0.0f;
  sort_in(crowd, instance);
}

void sort_in(CrowdState& crowd, std::uint32_t instance) {
  const std::uint32_t from = crowd.treatments[crowd.slots[instance] / kLanes];
  const std::uint32_t to = treatment_of(crowd, instance);
  if (from == to) return;

  // First moved to the end of its list, so that removing it leaves no hole.
  const std::uint32_t last = crowd.last_block[from];
  Block& tail = crowd.blocks[last];
  const std::uint32_t here = crowd.slots[instance], end = last * kLanes + tail.count - 1;
  swap_slots(crowd, here, end);
  crowd.slots[crowd.blocks[here / kLanes].instance[here % kLanes]] = here;
  crowd.slots[instance] = end;

  std::uint32_t goal = crowd.last_block[to];
  const bool is_alone = tail.count == 1;
  if (is_alone && !has_room(crowd, goal)) {
    remove_last_block(crowd, from);
    (void)append_block(crowd, to);  // This is the block that was just freed, with the head in it.
    return;
  }
  if (!has_room(crowd, goal)) goal = append_block(crowd, to);
  Block& head = crowd.blocks[goal];
  const std::uint32_t there = goal * kLanes + head.count;
  swap_slots(crowd, end, there);
  crowd.slots[instance] = there;
  ++head.count;
  --tail.count;
  if (tail.count == 0) remove_last_block(crowd, from);
}

}  // namespace coif
