#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif {

struct WigSettings {
  std::uint32_t strips = 60;  ///< Evenly around the crown, in three layers.
  std::uint32_t bones_per_chain = 4;
  std::uint32_t texture_size = 256;  ///< Texels each way, a power of two.
};

/// A made-up bob: curved strips over an ellipsoid head, one chain of bones per strip, a procedural strand texture with
/// soft tips. The bytes of a .coif.
[[nodiscard]] std::vector<std::byte> made_up_wig(const WigSettings& settings = {});

}  // namespace coif
