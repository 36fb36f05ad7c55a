// One part of a step for the rows of a block's heads.

#include "world_step.h"

namespace coif {
namespace {

/// A row's step, and what it reads on a character.
struct RowWork {
  RowStep row;
  RowCharacter character;
};

/// Sets what all rows share. `only_head`: the head of the block where the rows' lanes are its chains; else -1.
void set_up(const WorldState& world, const BlockStep& step, std::int32_t only_head, std::uint32_t part, RowWork& work) {
  const CharacterCode* const character = world.rules.character;
  RowStep& row = work.row;
  row.scratch = step.block.scratch;
  row.dt = step.parts.part_dt();
  row.iterations = world.settings.iterations;
  row.level = step.treatment.level;
  const ColliderTable* const table = step.crowd.worn->colliders;
  row.colliders = table == nullptr ? nullptr : &table->placed;
  if (character == nullptr) return;
  const Block& block = step.block;
  const RowHeads heads{&block.heads, block.head, block.count, only_head, block.bounds, block.most_ways, block.gusts};
  character->set_up(world, heads, step.parts, part, work.character);
  row.character = &work.character;
}

/// Sets the arguments of one row, for its first `lanes` lanes.
void enter(const WorldState& world, const BlockStep& step, const Row& row, const RowNumbers& numbers,
           std::uint32_t lanes, RowWork& work) {
  const WornAsset& worn = *step.crowd.worn;
  const std::uint32_t first = row.first_bone;
  const Treatment& treatment = step.treatment;
  RowStep& job = work.row;
  job.bones = worn.row_bones.subspan(first, row.bone_count);
  job.constants = &worn.constants[first];
  job.limits = worn.limits.empty() ? nullptr : &worn.limits[first];
  job.keep_in_limit = world.keep_in_limit[width_for(lanes)];
  job.coefficients =
      worn.table(treatment.set * world.rules.intervals + treatment.power) + first * worn.coefficient_bytes;
  job.state = numbers.state + first * worn.count.state_bytes;
  job.twist = numbers.twist == nullptr || !row.solver->carries_frames ? nullptr : numbers.twist + first;
  job.lanes = lanes;
  job.is_linked = worn.links.code != nullptr && worn.links.has(row.first_chain);
  work.character.poses = work.character.is_posed ? numbers.poses + first : nullptr;
  work.character.body_sets = worn.body_sets.empty() ? nullptr : &worn.body_sets[std::size_t{first} * kLanes];
}

}  // namespace

void step_heads(WorldState& world, BlockStep& step, const MoveLanes& move, std::uint32_t part) {
  const WornAsset& worn = *step.crowd.worn;
  const Block& block = step.block;
  const LinkCode* const links = worn.links.code;
  const RowNumbers numbers{block.state, block.twist, block.poses};
  const bool is_last = part + 1 == step.parts.count;
  RowWork work;
  set_up(world, step, -1, part, work);
  work.row.move = &move;
  Mat34 *first[kLanes], *palettes[kLanes];  // Only lanes in use.
  for (std::uint32_t i = 0; i < block.count; ++i) first[i] = world.palette(world.heads[block.head[i]]).data();
  Lanes unused{};
  for (std::size_t r = 0; r < worn.rows.size(); ++r) {
    const Row& row = worn.rows[r];
    const std::uint32_t bone = worn.asset.chains()[row.first_chain].first_bone;
    for (std::uint32_t i = 0; i < block.count; ++i) palettes[i] = first[i] + bone;
    enter(world, step, row, numbers, block.count, work);
    work.row.palette = is_last ? palettes : nullptr;
    work.row.motion = work.row.is_linked ? &unused : &step.motion;
    row.steps[width_for(block.count)](work.row);
    if (links != nullptr) links->keep_row(worn, block.links, r, work.row);
  }
  if (links == nullptr) return;
  for (std::uint32_t i = 0; i < block.count; ++i) {
    step.motion.v[i] += links->keep(worn.links, block.links, std::int32_t(i));
  }
}

void step_chains(WorldState& world, BlockStep& step, std::uint32_t lane, const MoveLanes& moves, std::uint32_t part) {
  const WornAsset& worn = *step.crowd.worn;
  const WornHead& head = world.heads[step.block.head[lane]];
  const LinkCode* const links = worn.links.code;
  const RowNumbers numbers = numbers_of(worn, head);
  const bool is_last = part + 1 == step.parts.count;
  RowWork work;
  set_up(world, step, std::int32_t(lane), part, work);
  MoveLanes move;
  head_code_for(world, step.block.count).spread(moves, lane, move);
  work.row.move = &move;
  const std::span<Mat34> palette = world.palette(head);
  Mat34* palettes[kLanes] = {};
  for (std::size_t r = 0; r < worn.rows.size(); ++r) {
    const Row& row = worn.rows[r];
    for (std::uint32_t i = 0; i < row.chain_count; ++i) {
      palettes[i] = &palette[worn.asset.chains()[row.first_chain + i].first_bone];
    }
    enter(world, step, row, numbers, row.chain_count, work);
    work.row.palette = is_last ? palettes : nullptr;
    Lanes motion{};
    work.row.motion = &motion;
    row.steps[width_for(row.chain_count)](work.row);
    // In the order of the chains, as for kHeads, without unused lanes.
    for (std::uint32_t i = 0; i < row.chain_count; ++i) {
      if (!worn.links.has(row.first_chain + i)) step.motion.v[lane] += motion.v[i];
    }
    if (links != nullptr) links->keep_row(worn, step.block.links, r, work.row);
  }
  if (links != nullptr) step.motion.v[lane] += links->keep(worn.links, step.block.links, -1);
}

}  // namespace coif
