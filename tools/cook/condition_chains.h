#pragma once

#include "write/asset_writer.h"

#include <functional>
#include <string>
#include <vector>

namespace coif {

/// What was done so that every chain's equation has a solution to converge to.
struct ConditionedChains {
  std::vector<DynamicsRecord> dynamics;  ///< One per bone.
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// Checks that the model (runtime/docs/MODEL.md, "Well-posed or not") is one for every chain: over motions of the suite two
/// computations of the reference, one with half the other's step, differ by at most 0.1 % of the chain's length (RMS), and
/// 240 steps a second of the runtime follow it within 5 %. Where they do not, damping and friction are raised and
/// `parent_share` lowered, as little as it takes; the note names the chain. A chain that nothing helps keeps the last try
/// and is warned of.
///
/// Of chains with equally many bones the softest and the longest are computed, and the others treated as they are.
/// `contents` holds skeleton, dynamics and colliders. The result does not depend on `threads`.
[[nodiscard]] ConditionedChains condition_chains(const AssetContents& contents, unsigned threads);

}  // namespace coif
