#include "world.h"

#include "../chain_motion.h"
#include "../head_lanes.h"
#include "../memory_carver.h"

#include <new>

namespace coif {
namespace {

void carve(MemoryCarver& carver, const Asset& asset, std::size_t kept_floats, WornHead& head) {
  head.palette = carver.take<Mat34>(asset.bones().size());
  head.places = carver.take<ChainPlace>(asset.chains().size());
  head.kept = carver.take<float>(kept_floats);
}

std::size_t own_bytes(const Asset& asset, std::size_t kept_floats) {
  MemoryCarver counter(nullptr);
  WornHead head;
  carve(counter, asset, kept_floats, head);
  return std::size_t(counter.used());
}

bool add_member(WorldState& world, DenseList<WorldBlock>& blocks) {
  if (blocks.is_full()) {
    std::byte* const memory = world.heap.take(sizeof(WorldBlock));
    if (memory == nullptr) return false;
    auto* const block = ::new (static_cast<void*>(memory)) WorldBlock{};
    stand_upright(block->heads);
    blocks.append(block);
  }
  ++blocks.members;
  return true;
}

void remove_member(WorldState& world, DenseList<WorldBlock>& blocks) {
  --blocks.members;
  if (WorldBlock* const spare = blocks.take_spare()) world.heap.give_back(spare, sizeof(WorldBlock));
}

/// Removes the first `chains` of a head's chains from their shapes' members.
void remove_members(WorldState& world, const WornAsset& worn, std::size_t chains) {
  for (std::size_t c = 0; c < chains; ++c) remove_member(world, *worn.shapes[c]);
  remove_member(world, worn.pace->blocks);
}

bool add_members(WorldState& world, const WornAsset& worn) {
  if (!add_member(world, worn.pace->blocks)) return false;
  for (std::size_t c = 0; c < worn.shapes.size(); ++c) {
    if (add_member(world, *worn.shapes[c])) continue;
    remove_members(world, worn, c);
    return false;
  }
  return true;
}

void move_bit(std::uint16_t& from, std::uint32_t i, std::uint16_t& to, std::uint32_t k) {
  const std::uint32_t bit = (from >> i) & 1u;
  from = std::uint16_t(from & ~(1u << i));
  to = std::uint16_t((to & ~(1u << k)) | bit << k);
}

void copy_head(const HeadLanes& from, std::uint32_t i, HeadLanes& to, std::uint32_t k) {
  copy_lane(&from, i, &to, k, offsetof(HeadLanes, next_position));
  for (int axis = 0; axis < 3; ++axis) to.next_position[axis][k] = from.next_position[axis][i];
}

/// Moves everything except the head's place.
void move_lane(const DenseList<WorldBlock>::Place& from, const DenseList<WorldBlock>::Place& to) {
  WorldBlock &a = *from.part, &b = *to.part;
  copy_head(a.heads, from.lane, b.heads, to.lane);
  move_bit(a.teleports, from.lane, b.teleports, to.lane);
  move_bit(a.is_lost, from.lane, b.is_lost, to.lane);
  move_bit(a.may_sleep, from.lane, b.may_sleep, to.lane);
  b.head[to.lane] = a.head[from.lane];
}

/// Removes the lane of a head; the last one of its list takes its place.
void close_gap(WorldState& world, DenseList<WorldBlock>& blocks, const DenseList<WorldBlock>::Place& gap) {
  const auto last = blocks.back();
  if (last.part != gap.part || last.lane != gap.lane) {
    move_lane(last, gap);
    world.heads[gap.part->head[gap.lane]].place = gap;
  }
  blocks.pop();
}

void move_head(WorldState& world, std::uint32_t head, DenseList<WorldBlock>& from, DenseList<WorldBlock>& to) {
  WornHead& worn = world.heads[head];
  const auto here = worn.place, there = to.push();
  move_lane(here, there);
  worn.place = there;
  close_gap(world, from, here);
}

/// Copies the state of the head's chains out of their lanes, or back into them.
template <typename Copy>
void for_each_kept(const WorldState& world, const WornHead& head, const Copy& copy) {
  float* kept = head.kept.data();
  const WornAsset& worn = world.assets[head.asset];
  const auto shapes = worn.shapes;
  for (std::size_t c = 0; c < shapes.size(); ++c) {
    const ChainPlace& place = head.places[c];
    const std::size_t bones = worn.asset.chains()[c].bone_count;
    const std::size_t state = bones * shapes[c]->solver->state_bytes, twist = bones * sizeof(TwistState);
    copy(place.part->state, place.lane, kept, state);
    kept += state / sizeof(Lanes);
    if (!shapes[c]->twists) continue;
    copy(place.part->twist, place.lane, kept, twist);
    kept += twist / sizeof(Lanes);
  }
}

void push_chains(WorldState& world, std::uint32_t head) {
  const auto chains = std::uint32_t(world.heads[head].places.size());
  for (std::uint32_t c = 0; c < chains; ++c) push_chain(world, head, c);
}

void pop_chains(WorldState& world, std::uint32_t head) {
  const auto chains = std::uint32_t(world.heads[head].places.size());
  for (std::uint32_t c = 0; c < chains; ++c) pop_chain(world, head, c);
}

}  // namespace

std::size_t head_bytes(const Asset& asset, std::uint32_t heads, const Solver& asked) {
  const std::size_t blocks = (std::size_t(heads) + kLanes - 1) / kLanes;
  return blocks * WorldHeap::rounded(sizeof(WorldBlock)) +
         heads * WorldHeap::rounded(own_bytes(asset, kept_floats(asset, asked)));
}

bool add_head(WorldState& world, std::uint32_t asset, std::uint32_t head, const HeadPose& unit) {
  WornAsset& worn = world.assets[asset];
  const std::size_t bytes = own_bytes(worn.asset, worn.kept_floats);
  std::byte* const memory = world.heap.take(bytes);
  if (memory == nullptr) return false;
  if (!add_members(world, worn)) {
    world.heap.give_back(memory, bytes);
    return false;
  }
  WornHead& added = world.heads[head];
  added.asset = asset;
  added.is_asleep = false;
  added.memory = {memory, bytes};
  MemoryCarver carver(memory);
  carve(carver, worn.asset, worn.kept_floats, added);
  added.place = worn.pace->blocks.push();
  WorldBlock& block = *added.place.part;
  block.head[added.place.lane] = head;
  (void)aim_head(block.heads, added.place.lane, unit);  // However far it is: it is put there.
  push_chains(world, head);
  put_to_rest(world, added);
  ++worn.heads;
  return true;
}

void remove_head(WorldState& world, std::uint32_t head) {
  WornHead& gone = world.heads[head];
  WornAsset& worn = world.assets[gone.asset];
  if (!gone.is_asleep) pop_chains(world, head);
  close_gap(world, gone.is_asleep ? world.asleep : worn.pace->blocks, gone.place);
  remove_members(world, worn, worn.shapes.size());
  world.heap.give_back(gone.memory.data(), gone.memory.size());
  --worn.heads;
  gone = WornHead{};
}

void put_to_rest(WorldState& world, WornHead& head) {
  WorldBlock& block = *head.place.part;
  const auto keep = std::uint16_t(~(1u << head.place.lane));
  block.teleports &= keep;
  block.is_lost &= keep;
  block.may_sleep &= keep;
  stop_head(block.heads, head.place.lane);
  const Quat rotation = lane(block.heads.rotation, head.place.lane);
  for_each_chain(world, head,
                 [&](const ChainShape& shape, const ChainLane& chain) { shape.solver->put_to_rest(chain, rotation); });
  for (Mat34& matrix : head.palette) matrix = Mat34{};
}

void turn_hair(WorldState& world, WornHead& head, const Quat& by) {
  for_each_chain(world, head, [&](const ChainShape& shape, const ChainLane& chain) { shape.solver->turn(chain, by); });
}

void jump(WorldState& world, WornHead& head, float dt) {
  HeadLanes& heads = head.place.part->heads;
  const HairJump by = jump_head(heads, head.place.lane, dt);
  turn_hair(world, head, by.turn);
  if (!by.is_faster()) return;
  const Vec3 velocity = by.velocity * heads.per_scale.v[head.place.lane];
  for_each_chain(world, head, [&](const ChainShape& shape, const ChainLane& chain) {
    add_motion(*shape.solver, chain, velocity, by.turning);
  });
}

void fall_asleep(WorldState& world, std::uint32_t head) {
  WornHead& worn = world.heads[head];
  for_each_kept(world, worn, [](const void* lanes, std::uint32_t lane, float* kept, std::size_t bytes) {
    copy_lane_out(lanes, lane, kept, bytes);
  });
  pop_chains(world, head);
  move_head(world, head, world.assets[worn.asset].pace->blocks, world.asleep);
  worn.is_asleep = true;
}

void wake(WorldState& world, std::uint32_t head) {
  WornHead& worn = world.heads[head];
  worn.is_asleep = false;
  move_head(world, head, world.asleep, world.assets[worn.asset].pace->blocks);
  worn.place.part->heads.quiet.v[worn.place.lane] = 0.0f;
  push_chains(world, head);
  for_each_kept(world, worn, [](void* lanes, std::uint32_t lane, const float* kept, std::size_t bytes) {
    copy_lane_in(kept, lanes, lane, bytes);
  });
}

Status move_head(WorldState& world, std::uint32_t index, const HeadPose& pose, const HeadVelocity* velocity) {
  HeadPose unit;
  if (const Status status = make_unit(pose, unit); status != Status::kOk) return status;
  if (velocity != nullptr && !(is_finite(velocity->linear) && is_finite(velocity->angular))) return Status::kBadPose;
  WornHead& head = world.heads[index];
  head.told = pose;
  if (velocity != nullptr) forget_told(head.told);
  if (head.is_asleep) {
    if (stays(head.place.part->heads, head.place.lane, unit)) return Status::kOk;
    wake(world, index);
  }
  WorldBlock& block = *head.place.part;
  const std::uint32_t i = head.place.lane;
  if (!aim_head(block.heads, i, unit)) block.is_lost = std::uint16_t(block.is_lost | 1u << i);
  tell_velocity(block.heads, i, velocity);
  return Status::kOk;
}

}  // namespace coif
