#pragma once

#include "write/asset_writer.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif::cook {

/// Chains of one model with equally many bones, and the telling ones among them: the softest and the longest.
struct ChainGroup {
  std::vector<std::uint32_t> chains;
  std::vector<std::uint32_t> telling;  ///< One or two of them.
};

/// Every chain of the skeleton in one group, by its model and number of bones.
[[nodiscard]] std::vector<ChainGroup> group_chains(const AssetContents& contents);

/// How much a straight chain amplifies the motion of its root, at the worst frequency of each bone, in the linear model
/// (runtime/docs/MODEL.md, "Well-posed or not"). At least 1. A bound on how far a computation can be trusted, not a
/// prediction: 1e4 turns a rounding error into a visible one within a second.
[[nodiscard]] double chain_growth(const AssetContents& contents, std::uint32_t chain);

/// A chain as notes and warnings call it: its first bone's name in quotes, or its number where that has none.
[[nodiscard]] std::string chain_name(const AssetContents& contents, std::uint32_t chain);

/// "chain 'tail' and 3 like it": this chain of the group, and the number of others.
[[nodiscard]] std::string names_of(const AssetContents& contents, const ChainGroup& group, std::uint32_t chain);

// Parts of a skeleton, so that passes can run them through the runtime as a game would.

/// A skeleton's rigid bones, colliders and these chains (indices into contents.chains), in this order, without names
/// and surface. Chains do not act on each other, so each moves as it does among all.
[[nodiscard]] AssetContents chains_alone(const AssetContents& contents, std::span<const std::uint32_t> chains);

}  // namespace coif::cook
