#pragma once

#include "write/asset_writer.h"

#include <cstdint>
#include <string>

namespace coif {

/// A chain as notes and warnings call it: its first bone's name in quotes, or its number where that has none.
[[nodiscard]] std::string chain_name(const AssetContents& contents, std::uint32_t chain);

}  // namespace coif
