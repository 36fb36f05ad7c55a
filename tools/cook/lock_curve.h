#pragma once

#include "cook/group_locks.h"

namespace coif {

/// The bones of one lock as a line of joints: bone i goes from joint i to joint i + 1.
struct LockCurve {
  std::vector<Eigen::Vector3d> joints;  ///< Model space, metres, from the scalp to the tip; empty: too short.
  std::vector<double> depth;            ///< Of each joint, ascending from 0: hair of this depth is level with it.
};

/// The middle of the lock from where it leaves the scalp to its tip, cut into `recipe.chain_bone_length` or, where that
/// would be more than `most_bones`, into longer equal bones. Joints are outside of the head, so that its collider does
/// not push the modelled pose.
[[nodiscard]] LockCurve fit_lock_curve(const HairCells& cells, const HangingHair& hair, const HairLock& lock,
                                       const FittedHead& head, const Recipe& recipe, std::size_t most_bones);

}  // namespace coif
