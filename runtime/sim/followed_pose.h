#pragma once
// The poses of the bones of one head, in the lanes of its rows.

#include "crowd.h"

namespace coif {

/// Sets the rest pose, which adds no pull of its own.
inline void set_rest_pose(PoseLanes& pose, std::uint32_t lane, const Vec3& pull) {
  set_lane(pose.before, lane, Quat{});
  set_lane(pose.now, lane, Quat{});
  set_lane(pose.pull_before, lane, pull);
  set_lane(pose.pull_now, lane, pull);
  pose.weight.v[lane] = 1.0f;
}

/// The pose has arrived at its target.
inline void arrive(PoseLanes& pose, std::uint32_t lane) {
  set_lane(pose.before, lane, coif::lane(pose.now, lane));
  set_lane(pose.pull_before, lane, coif::lane(pose.pull_now, lane));
}

/// Calls visit(bone of the asset, PoseLanes, lane, constants, lane of those, bone in the row) for each simulated bone
/// of a head.
template <typename Visit>
void for_each_pose(CrowdState& crowd, std::uint32_t slot, const Visit& visit) {
  const std::size_t first = crowd.first_state(slot);
  for (const Row& row : crowd.rows) {
    for (std::uint32_t chain = 0; chain < row.chain_count; ++chain) {
      const std::uint32_t lane = crowd.order == LaneOrder::kHeads ? slot % kLanes : chain;
      for (std::uint32_t i = 0; i < row.bone_count; ++i) {
        const std::uint32_t bone = bone_in_lane(crowd.asset, row, i, chain);
        const std::size_t at = row.first_bone + i;
        visit(bone, row.first_chain + chain, crowd.character.poses[first + at], lane,
              coif::lane(crowd.constants[at].pull, chain));
      }
    }
  }
}

}  // namespace coif
