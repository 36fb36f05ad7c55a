#pragma once

#include "cards/even_strands.h"
#include "cards/ribbon.h"
#include "platform/stop.h"

#include <cstdint>
#include <vector>

namespace coif::cards {

/// Strands that go onto one card.
struct Wisp {
  std::vector<std::uint32_t> members;  ///< Ascending, not empty.
  Ribbon ribbon;
};

/// All strands in `count` wisps, or as many as there are strands, by their whole shape: each strand is in the wisp on
/// whose card it loses least, and cards are the best of their strands (Lloyd 1982, with ribbons in place of points; the
/// first ones by Arthur and Vassilvitskii 2007, "k-means++"). Of very many strands a sample finds the cards. Repeats
/// for equal input, whatever `threads` is.
[[nodiscard]] std::vector<Wisp> find_wisps(const EvenStrands& strands, std::size_t count,
                                           const platform::Threads& threads);

}  // namespace coif::cards
