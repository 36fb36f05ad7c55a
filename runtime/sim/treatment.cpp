#include "head_lanes.h"
#include "world_heads.h"

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

/// Swaps lanes with all numbers, also with lanes that are not in use: those stay at rest.
void swap_places(const Crowd& crowd, const BlockPlace& from, const BlockPlace& to) {
  Block &a = *from.part, &b = *to.part;
  const std::uint32_t i = from.lane, k = to.lane;
  if (&a == &b && i == k) return;
  constexpr std::size_t kFloats = offsetof(HeadLanes, next_position);
  swap_lanes(&a.heads, i, &b.heads, k, kFloats);
  for (int axis = 0; axis < 3; ++axis) std::swap(a.heads.next_position[axis][i], b.heads.next_position[axis][k]);
  swap_bits(a.teleports, i, b.teleports, k);
  swap_bits(a.is_lost, i, b.is_lost, k);
  swap_bits(a.may_sleep, i, b.may_sleep, k);
  std::swap(a.head[i], b.head[k]);
  if (crowd.order != LaneOrder::kHeads) return;
  const RowCount& rows = crowd.worn->count;
  swap_lanes(a.state, i, b.state, k, rows.bones * rows.state_bytes);
  if (a.poses != nullptr) swap_lanes(a.poses, i, b.poses, k, rows.bones * sizeof(PoseLanes));
  if (a.twist != nullptr) swap_lanes(a.twist, i, b.twist, k, rows.bones * sizeof(TwistState));
}

void set_place(WorldState& world, const BlockPlace& place) {
  WornHead& head = world.heads[place.part->head[place.lane]];
  head.block = place.part;
  head.lane = std::uint8_t(place.lane);
}

/// Moves the head to the end of its list, so that taking it out leaves no hole.
BlockPlace move_to_end(WorldState& world, const Crowd& crowd, DenseList<Block>& list, const WornHead& head) {
  const BlockPlace here{head.block, head.lane}, end = list.back();
  swap_places(crowd, here, end);
  set_place(world, here);
  set_place(world, end);
  return end;
}

BlockPlace push(Crowd& crowd, std::uint32_t treatment) {
  const BlockPlace place = crowd.lists[treatment].blocks.push(crowd.blocks);
  place.part->treatment = treatment;
  return place;
}

/// Number of phases of all intervals together: 1, 1 + 2, 1 + 2 + 4.
constexpr std::uint32_t phase_count(std::uint32_t intervals) { return (1u << intervals) - 1; }

bool ends_interval(const WorldState& world, std::uint32_t phase, std::uint32_t power) {
  return ((world.step_index + phase) & ((1u << power) - 1u)) == 0;
}

void move_to_block(WorldState& world, std::uint32_t index, std::uint32_t to) {
  WornHead& head = world.heads[index];
  Crowd& crowd = world.crowd_of(head);
  DenseList<Block>& list = crowd.lists[head.block->treatment].blocks;
  DenseList<Block>& goal = crowd.lists[to].blocks;
  const BlockPlace end = move_to_end(world, crowd, list, head);
  if (end.lane == 0 && goal.is_full()) {
    goal.append(list.remove_last());
    end.part->treatment = to;
    return;
  }
  const BlockPlace there = push(crowd, to);
  swap_places(crowd, end, there);
  set_place(world, there);
  list.pop(crowd.blocks);
}

}  // namespace

std::uint32_t treatment_count(std::uint32_t levels, std::uint32_t intervals, std::uint32_t sets) {
  return 1 + sets * levels * phase_count(intervals);
}

std::uint32_t busy_treatment_of(const WorldState& world, std::uint32_t index) {
  const WornHead& head = world.heads[index];
  const Crowd& crowd = world.crowd_of(head);
  const std::uint32_t interval = 1u << head.detail.interval_power, phase = index / kLanes % interval;
  const std::uint32_t kind = head.detail.level * crowd.sets + (crowd.sets > 1 ? head.set : 0);
  return 1 + kind * phase_count(world.rules.intervals) + (interval - 1) + phase;
}

std::uint32_t treatment_of(const WorldState& world, std::uint32_t index) {
  const HeadDetail& detail = world.heads[index].detail;
  return !detail.simulated || detail.asleep ? kIdle : busy_treatment_of(world, index);
}

void set_treatments(std::uint32_t intervals, Crowd& crowd) {
  const std::uint32_t phases = phase_count(intervals);
  for (std::uint32_t i = kIdle + 1; i < crowd.lists.size(); ++i) {
    const std::uint32_t kind = (i - 1) / phases, at = (i - 1) % phases;
    const auto power = std::uint32_t(std::bit_width(at + 1)) - 1;
    crowd.lists[i].treatment = {kind / crowd.sets, kind % crowd.sets, power, at + 1 - (1u << power)};
  }
}

void take_up_interval(WorldState& world, std::uint32_t index) {
  HeadDetail& detail = world.heads[index].detail;
  const std::uint8_t longer = detail.asked_power > detail.interval_power ? detail.asked_power : detail.interval_power;
  // No time has passed for a head that is not simulated, nor before the first step.
  const bool is_free = treatment_of(world, index) == kIdle || world.step_index == 0;
  if (is_free || ends_interval(world, index / kLanes, longer)) detail.interval_power = detail.asked_power;
  if (detail.interval_power != detail.asked_power) world.has_asked = true;
}

void sort_in_first(WorldState& world, std::uint32_t index) {
  WornHead& head = world.heads[index];
  const BlockPlace place = push(world.crowd_of(head), treatment_of(world, index));
  place.part->head[place.lane] = index;
  set_place(world, place);
}

void sort_out_of_block(WorldState& world, std::uint32_t index) {
  WornHead& head = world.heads[index];
  Crowd& crowd = world.crowd_of(head);
  DenseList<Block>& list = crowd.lists[head.block->treatment].blocks;
  const BlockPlace end = move_to_end(world, crowd, list, head);
  Block& block = *end.part;
  for (std::uint16_t* const bits : {&block.teleports, &block.is_lost, &block.may_sleep}) clear_bit(*bits, end.lane);
  list.pop(crowd.blocks);
}

void sort_in(WorldState& world, std::uint32_t index) {
  WornHead& head = world.heads[index];
  const std::uint32_t to = treatment_of(world, index);
  if (head.block->treatment == to) return;
  const bool is_shared = world.crowd_of(head).order == LaneOrder::kShared;
  if (is_shared && head.has_lanes) world.shared->leave_lanes(world, index);
  move_to_block(world, index, to);
  if (is_shared && to != kIdle) world.shared->enter(world, index);
}

void wake(WorldState& world, std::uint32_t index) {
  WornHead& head = world.heads[index];
  head.detail.asleep = false;
  head.block->heads.quiet.v[head.lane] = 0.0f;
  sort_in(world, index);
}

}  // namespace coif
