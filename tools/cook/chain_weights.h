#pragma once

#include "cook/lock_curve.h"
#include "cook/skin_weights.h"

namespace coif {

/// Bones of one lock in the skeleton; none where the lock follows the head.
struct LockBones {
  std::uint32_t first = 0;
  std::vector<double> joint_depth;  ///< Bones + 1, or empty.
};

/// Weights that change smoothly in space, so that no two vertices at one place move apart: along a chain from bone to
/// bone, from the head to its first bone, and from lock to lock over `blend` metres of connected hair.
/// `rigid`: vertices that follow the head. `place_of`: vertices with the same value get the same weights.
[[nodiscard]] SkinWeights blend_chain_weights(const HairMesh& mesh, const HairCells& cells, const HangingHair& hair,
                                              std::span<const HairLock> locks, std::span<const LockBones> bones,
                                              const std::vector<bool>& rigid,
                                              std::span<const std::uint32_t> place_of, double blend);

}  // namespace coif
