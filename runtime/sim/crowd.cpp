#include "crowd.h"

#include "chain_motion.h"
#include "head_lanes.h"

namespace coif {

void stand_still(CrowdState& crowd, std::uint32_t slot) {
  if (crowd.character.code != nullptr) crowd.character.code->appear(crowd, slot);
  stop_head(crowd.blocks[slot / kLanes].heads, slot % kLanes);
}

void put_to_rest(CrowdState& crowd, std::uint32_t slot) {
  Block& block = crowd.blocks[slot / kLanes];
  const std::uint32_t i = slot % kLanes;
  const auto keep = std::uint16_t(~(1u << i));
  block.teleports &= keep;
  block.is_lost &= keep;
  block.may_sleep &= keep;
  stand_still(crowd, slot);
  const Quat rotation = lane(block.heads.rotation, i);
  for_each_chain(crowd, slot, [&](const Solver& solver, const ChainRecord&, const ChainLane& chain) {
    solver.put_to_rest(chain, rotation);
  });
  for (Mat34& matrix : crowd.palette(block.instance[i])) matrix = Mat34{};
}

void put_idle_lanes_to_rest(CrowdState& crowd) {
  const bool by_heads = crowd.order == LaneOrder::kHeads;
  const std::size_t count = by_heads ? crowd.blocks.size() : crowd.slots.size();
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t slot = by_heads ? std::uint32_t(k) * kLanes : crowd.slots[k];
    for (const Row& row : crowd.rows) {
      ChainLane chain = row_of(crowd, row, slot);
      for (std::uint32_t i = by_heads ? crowd.blocks[k].count : row.chain_count; i < kLanes; ++i) {
        chain.constant_lane = chain.state_lane = i;
        row.solver->put_to_rest(chain, Quat{});
      }
    }
  }
}

namespace {

/// Moves the hair along when its head jumps.
void move_hair(CrowdState& crowd, std::uint32_t slot, const HairJump& by) {
  const Vec3 velocity = by.velocity * crowd.blocks[slot / kLanes].heads.per_scale.v[slot % kLanes];
  for_each_chain(crowd, slot, [&](const Solver& solver, const ChainRecord&, const ChainLane& chain) {
    solver.turn(chain, by.turn);
    if (by.is_faster()) add_motion(solver, chain, velocity, by.turning);
  });
}

}  // namespace

void turn_hair(CrowdState& crowd, std::uint32_t slot, const Quat& by) { move_hair(crowd, slot, {by, {}, {}}); }

void jump(CrowdState& crowd, std::uint32_t slot, float dt) {
  move_hair(crowd, slot, jump_head(crowd.blocks[slot / kLanes].heads, slot % kLanes, dt));
}

}  // namespace coif
