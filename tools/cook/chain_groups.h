#pragma once

#include "write/asset_writer.h"

#include <cstdint>
#include <vector>

namespace coif {

/// Chains with equally many bones, and those of them that tell most about all: the softest and the longest.
struct ChainGroup {
  std::vector<std::uint32_t> chains;
  std::vector<std::uint32_t> telling;  ///< One or two of them.
};

/// Every chain of the skeleton in one group, by their number of bones.
[[nodiscard]] std::vector<ChainGroup> group_chains(const AssetContents& contents);

}  // namespace coif
