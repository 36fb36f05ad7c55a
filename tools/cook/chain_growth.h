#pragma once

#include "write/asset_writer.h"

namespace coif {

/// By how much a straight chain amplifies what moves its root, at the worst frequency of each bone, in the linear model
/// (runtime/docs/MODEL.md, "Well-posed or not"). At least 1. A bound of what a computation can be trusted with, not a
/// prediction: 1e4 turns a rounding error into a visible one within a second.
[[nodiscard]] double chain_growth(const AssetContents& contents, std::uint32_t chain);

}  // namespace coif
