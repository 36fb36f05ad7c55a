#pragma once

#include "visibility/linear_order.h"

#include <coif/asset_records.h>

#include <array>
#include <vector>

namespace coif {

/// What each cell of directions (coif/view_cells.h) wants of an order.
using CellVotes = std::array<std::vector<Vote>, kViewCells>;

/// A few orders, and which of them each cell draws with.
struct OrderClusters {
  std::vector<UnitOrder> orders;
  std::array<std::uint8_t, kViewCells> order_of{};
};

/// At most `count` orders for all cells, of the units that `start` has. The cells whose own order would save most of all cells'
/// lost votes found the clusters; then cells go to the order that loses least of their votes and orders are improved for their
/// cells, until neither changes anything (Lloyd's iteration, with votes for distances). Never loses more votes than `start`
/// does; the same for every number of threads.
[[nodiscard]] OrderClusters cluster_orders(const CellVotes& cells, const UnitOrder& start, std::size_t count,
                                           unsigned threads);

/// The second half of that alone, from the orders of `found`, which other votes led to.
[[nodiscard]] OrderClusters refine_clusters(const CellVotes& cells, OrderClusters found, unsigned threads);

}  // namespace coif
