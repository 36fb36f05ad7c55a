#pragma once
// Parts of a skeleton, so that passes can run through the runtime what a game will run.

#include "write/asset_writer.h"

#include <span>

namespace coif {

/// The rigid bones, colliders and these chains of a skeleton (indices into contents.chains, ascending), without names and
/// surface. Chains do not act on each other, so each moves as it does among all.
[[nodiscard]] AssetContents chains_alone(const AssetContents& contents, std::span<const std::uint32_t> chains);

}  // namespace coif
