#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace coif {

/// Something that is not in the asset.
struct LeftOut {
  std::string what;         ///< With its number, name or place.
  std::string why;          ///< The rule, or the recipe's key.
  std::uint64_t bytes = 0;  ///< That the asset would have for it; 0 for what no asset has, such as a body.
  double ns_per_frame = 0;  ///< Nominal nanoseconds per head that it would have cost; 0 where it would have cost none.

  /// "what: why (12 bytes, 175 ns a frame)", without what is 0.
  [[nodiscard]] std::string text() const;
};

}  // namespace coif
