#include "rows.h"

#include "placed_colliders.h"
#include "solver.h"
#include "vector_math.h"

namespace coif {
namespace {

bool twists(const DynamicsRecord& dynamics) { return dynamics.torsion < kShortestArc; }

}  // namespace

std::int32_t parent_in_chain(std::span<const BoneRecord> bones, const ChainRecord& chain, std::uint32_t i) {
  const std::uint32_t parent = bones[chain.first_bone + i].parent;
  return parent >= chain.first_bone && parent != kNone ? std::int32_t(parent - chain.first_bone) : -1;
}

namespace {

/// Whether one solver moves both chains, their bones correspond, and each pair of bones twists in both chains or in
/// neither and is bounded in both or in neither. A bone without twist gets other bits beside one with twist, and a bone
/// without limit meets its colliders in fewer rounds. All other features compute zeros where they are not used.
bool fit_in_one_row(const Asset& asset, const Solver& solver, const ChainRecord& a, const ChainRecord& b) {
  if (a.bone_count != b.bone_count || &solver_for(solver, a) != &solver_for(solver, b)) return false;
  for (std::uint32_t i = 0; i < a.bone_count; ++i) {
    const std::uint32_t one = a.first_bone + i, other = b.first_bone + i;
    if (parent_in_chain(asset.bones(), a, i) != parent_in_chain(asset.bones(), b, i)) return false;
    if (twists(asset.dynamics()[one]) != twists(asset.dynamics()[other])) return false;
    if (is_bounded(asset, one) != is_bounded(asset, other)) return false;
  }
  return true;
}

/// Calls visit(first chain, count) for each row. The cooker stores chains of equal shape next to each other.
template <typename Visit>
void for_each_row(const Asset& asset, const Solver& solver, LaneOrder order, const Visit& visit) {
  const auto chains = asset.chains();
  const std::uint32_t most = order == LaneOrder::kHeads ? 1 : kLanes;
  for (std::uint32_t first = 0; first < chains.size();) {
    std::uint32_t count = 1;
    while (count < most && first + count < chains.size() &&
           fit_in_one_row(asset, solver, chains[first], chains[first + count])) {
      ++count;
    }
    visit(first, count);
    first += count;
  }
}

}  // namespace

/// Gives each bone with children the first slot that is free: not held by a bone that still waits for children. Sixteen
/// suffice, as open() has checked.
void assign_slots(std::span<RowBone> bones) {
  for (const RowBone& bone : bones) {
    if (bone.parent >= 0) ++bones[std::size_t(bone.parent)].children;
  }
  std::uint32_t children_left[kMaxOpenBones] = {};
  for (RowBone& bone : bones) {
    if (bone.parent >= 0) {
      bone.parent_slot = bones[std::size_t(bone.parent)].slot;
      --children_left[bone.parent_slot];
    }
    if (bone.children == 0) continue;
    std::uint8_t slot = 0;
    while (slot + 1u < kMaxOpenBones && children_left[slot] != 0) ++slot;
    bone.slot = slot;
    bone.features |= kRowHasChildren;
    children_left[slot] = bone.children;
  }
}

std::uint32_t features_of(const BoneRecord& bone, const DynamicsRecord& dynamics) {
  std::uint32_t features = 0;
  if (bone.colliders != 0) features |= kRowCollides;
  if (dynamics.angle_limit < kNoAngleLimit) features |= kRowHasLimit;
  if (dynamics.parent_share != 1.0f) features |= kRowSharesPull;
  if (twists(dynamics)) features |= kRowTwists;
  if (dynamics.friction != 0.0f) features |= kRowFeelsAir;
  if (dynamics.lean[0] != 0.0f || dynamics.lean[1] != 0.0f) features |= kRowLeans;
  return features;
}

namespace {

/// Number of levels of detail in which the bone moves; without levels it always moves.
std::uint8_t levels_of(const Asset& asset, std::uint32_t bone) {
  return asset.lod_bones().empty() ? std::uint8_t(kMaxLods) : asset.lod_bones()[bone];
}

void set_constants(const Asset& asset, std::uint32_t bone, std::uint32_t lane, BoneLanes& lanes) {
  const BoneRecord& record = asset.bones()[bone];
  const DynamicsRecord& dynamics = asset.dynamics()[bone];
  const float* const rest = record.rest_direction;
  const float* const joint = record.joint;
  set_lane(lanes.rest, lane, {rest[0], rest[1], rest[2]});
  float pull[3];
  pull_direction(record.rest_direction, dynamics.lean, pull);
  const bool leans = dynamics.lean[0] != 0.0f || dynamics.lean[1] != 0.0f;
  set_lane(lanes.pull, lane, leans ? Vec3{pull[0], pull[1], pull[2]} : Vec3{rest[0], rest[1], rest[2]});
  set_lane(lanes.joint, lane, {joint[0], joint[1], joint[2]});
  lanes.length.v[lane] = record.length;
  lanes.per_length.v[lane] = 1.0f / record.length;
  lanes.hit_radius.v[lane] = dynamics.hit_radius;
  const bool is_limited = dynamics.angle_limit < kNoAngleLimit;
  lanes.limit_cosine.v[lane] = is_limited ? float(plain::sine_cosine(dynamics.angle_limit).cosine) : -2.0f;
  lanes.parent_share.v[lane] = dynamics.parent_share;
  lanes.torsion.v[lane] = dynamics.torsion;
  lanes.resistance.v[lane] = dynamics.resistance;
  lanes.colliders[lane] = record.colliders & PlacedColliders::first(asset.colliders().size());
  lanes.levels[lane] = levels_of(asset, bone);
}

}  // namespace

void add_bone(const Asset& asset, std::uint32_t bone, std::uint32_t lane, RowBone& shape, BoneLanes& constants) {
  const std::uint8_t levels = levels_of(asset, bone);
  set_constants(asset, bone, lane, constants);
  shape.features |= features_of(asset.bones()[bone], asset.dynamics()[bone]);
  shape.colliders |= constants.colliders[lane];
  if (levels < shape.fewest_levels) shape.fewest_levels = levels;
  if (levels > shape.most_levels) shape.most_levels = levels;
}

namespace {

/// Makes one bone of a row. Lanes without a chain repeat the first one: they are computed too, but not stored.
void make_bone(const Asset& asset, const Row& row, std::uint32_t i, RowBone& shape, BoneLanes& constants) {
  shape = RowBone{};
  shape.parent = parent_in_chain(asset.bones(), asset.chains()[row.first_chain], i);
  if (shape.parent < 0) shape.features |= kRowHangsFromHead;
  shape.fewest_levels = kMaxLods;
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    add_bone(asset, bone_in_lane(asset, row, i, lane), lane, shape, constants);
  }
  if (shape.colliders == 0) shape.features &= ~std::uint32_t(kRowCollides);
}

std::size_t larger(std::size_t a, std::size_t b) { return a > b ? a : b; }

}  // namespace

RowCount count_rows(const Asset& asset, const Solver& solver, LaneOrder order) {
  RowCount count;
  for_each_row(asset, solver, order, [&](std::uint32_t first, std::uint32_t) {
    const ChainRecord& chain = asset.chains()[first];
    const Solver& own = solver_for(solver, chain);
    ++count.rows;
    count.bones += chain.bone_count;
    count.state_bytes = larger(count.state_bytes, own.state_bytes);
    count.coefficient_bytes = larger(count.coefficient_bytes, own.coefficient_bytes);
    if (chain.bone_count > own.scratch_from) {
      count.scratch_bytes = larger(count.scratch_bytes, chain.bone_count * own.scratch_bytes);
    }
    count.has_substeps = count.has_substeps || own.has_substeps;
  });
  return count;
}

LaneOrder choose_lane_order(const Asset& asset, const Solver& solver, std::uint32_t instances) {
  const std::uint64_t by_heads =
      std::uint64_t(count_rows(asset, solver, LaneOrder::kHeads).bones) * ((instances + kLanes - 1) / kLanes);
  const std::uint64_t by_chains = std::uint64_t(count_rows(asset, solver, LaneOrder::kChains).bones) * instances;
  return by_chains < by_heads ? LaneOrder::kChains : LaneOrder::kHeads;
}

void make_rows(const Asset& asset, const Solver& solver, LaneOrder order, std::span<Row> rows, std::span<RowBone> bones,
               std::span<BoneLanes> constants) {
  std::uint32_t next_row = 0, next_bone = 0;
  for_each_row(asset, solver, order, [&](std::uint32_t first, std::uint32_t count) {
    const ChainRecord& chain = asset.chains()[first];
    Row& row = rows[next_row++];
    row = {&solver_for(solver, chain), {}, next_bone, chain.bone_count, first, count};
    for (std::uint32_t i = 0; i < row.bone_count; ++i) {
      make_bone(asset, row, i, bones[next_bone + i], constants[next_bone + i]);
    }
    const auto of_row = bones.subspan(next_bone, row.bone_count);
    assign_slots(of_row);
    for (std::uint32_t lane = 0; row.solver->complete_lane != nullptr && lane < kLanes; ++lane) {
      row.solver->complete_lane(of_row, lane, &constants[next_bone]);
    }
    next_bone += row.bone_count;
  });
}

}  // namespace coif
