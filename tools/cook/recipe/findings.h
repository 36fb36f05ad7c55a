#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace coif {

/// Something that is not in the asset.
struct LeftOut {
  std::string what;                  ///< With its number, name or place.
  std::string why;                   ///< The rule, or the recipe's key.
  std::uint64_t bytes = 0;           ///< That the asset would have for it; 0 for what no asset has, such as a body.
  std::uint64_t bytes_per_head = 0;  ///< Of the runtime's memory that each head of a crowd would take for it.
  double ns_per_frame = 0;  ///< Nominal nanoseconds per head that it would have cost; 0 where it would have cost none.

  /// "what: why (12 bytes, 40 bytes a head, 175 ns a frame)", without what is 0.
  [[nodiscard]] std::string text() const;
};

}  // namespace coif
