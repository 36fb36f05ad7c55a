#pragma once
// The poses of the bones of one head, in the lanes of its chains.

#include "vector_math.h"
#include "world_heads.h"

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

/// Calls visit(bone of the asset, chain of the asset, PoseLanes, lane, pull at rest) for each simulated bone of a head.
template <typename Visit>
void for_each_pose(WorldState& world, std::uint32_t head, const Visit& visit) {
  const auto chains = world.worn_by(world.heads[head]).asset.chains();
  for_each_chain(world, head, [&](const Solver&, std::uint32_t c, const ChainLane& chain) {
    for (std::uint32_t i = 0; i < chains[c].bone_count; ++i) {
      visit(chains[c].first_bone + i, c, chain.poses[i], chain.state_lane,
            coif::lane(chain.constants[i].pull, chain.constant_lane));
    }
  });
}

}  // namespace coif
