#include "chain_motion.h"
#include "head_lanes.h"
#include "world_heads.h"

namespace coif {

void visit_chains(WorldState& world, std::uint32_t index, const ChainVisit& visit) {
  const WornHead& head = world.heads[index];
  const WornAsset& worn = world.worn_by(head);
  if (worn.crowd->order == LaneOrder::kShared) return world.shared->visit(world, index, visit);
  const RowNumbers numbers = numbers_of(worn, head);
  for (const Row& row : worn.rows) {
    ChainLane chain = row_of(worn, row, numbers);
    for (std::uint32_t i = 0; i < row.chain_count; ++i) {
      chain.constant_lane = i;
      chain.state_lane = worn.crowd->order == LaneOrder::kHeads ? head.lane : i;
      visit(*row.solver, row.first_chain + i, chain);
    }
  }
}

void stand_still(WorldState& world, std::uint32_t head) {
  if (world.rules.character != nullptr) world.rules.character->appear(world, head);
  const WornHead& worn = world.heads[head];
  stop_head(worn.block->heads, worn.lane);
}

void put_to_rest(WorldState& world, std::uint32_t head) {
  const WornHead& worn = world.heads[head];
  Block& block = *worn.block;
  for (std::uint16_t* const bits : {&block.teleports, &block.is_lost, &block.may_sleep}) clear_bit(*bits, worn.lane);
  stand_still(world, head);
  const Quat rotation = lane(block.heads.rotation, worn.lane);
  for_each_chain(world, head, [&](const Solver& solver, std::uint32_t, const ChainLane& chain) {
    solver.put_to_rest(chain, rotation);
  });
  for (Mat34& matrix : world.palette(worn)) matrix = Mat34{};
}

namespace {

/// Moves the hair along when its head jumps.
void move_hair(WorldState& world, std::uint32_t head, const HairJump& by) {
  const WornHead& worn = world.heads[head];
  const Vec3 velocity = by.velocity * worn.block->heads.per_scale.v[worn.lane];
  for_each_chain(world, head, [&](const Solver& solver, std::uint32_t, const ChainLane& chain) {
    solver.turn(chain, by.turn);
    if (by.is_faster()) add_motion(solver, chain, velocity, by.turning);
  });
}

}  // namespace

void turn_hair(WorldState& world, std::uint32_t head, const Quat& by) { move_hair(world, head, {by, {}, {}}); }

void jump(WorldState& world, std::uint32_t head, float dt) {
  const WornHead& worn = world.heads[head];
  move_hair(world, head, jump_head(worn.block->heads, worn.lane, dt));
}

}  // namespace coif
