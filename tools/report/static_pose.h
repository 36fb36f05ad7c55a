#pragma once

#include "report/chain_solver.h"
#include "report/rig.h"

#include <vector>

namespace coif {

/// Where hair hangs under a head that stands still: the equilibrium of the model's forces.
struct StaticPose {
  std::vector<Eigen::Vector3d> ends;  ///< Bone tails, head space, metres; the order of Rig::bones.
  /// False where a bone, or one that it hangs from, would be inside a collider or beyond its angle limit: the pose then
  /// says only where it would hang without.
  std::vector<bool> is_free;
};

/// In closed form, root to tip: a bone points along stiffness times length times its default direction, plus gravity
/// and wind, and its frame is turned there by the shortest arc.
[[nodiscard]] StaticPose static_pose(const Rig& rig, const SolverScene& scene,
                                     const Eigen::Quaterniond& head_rotation = Eigen::Quaterniond::Identity());

}  // namespace coif
