#pragma once

#include "platform/stop.h"
#include "visibility/hair_surface.h"
#include "visibility/order_error.h"

#include <coif/asset_records.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::visibility {

/// Units in the order in which they are drawn.
using UnitOrder = std::vector<std::uint32_t>;

/// Of each unit below `units` its place in `order`; 0 where it is not there.
[[nodiscard]] std::vector<std::uint32_t> places_in(std::span<const std::uint32_t> order, std::size_t units);

/// What an order loses of the votes: the weights of those that it goes against.
[[nodiscard]] double votes_against(std::span<const Vote> votes, std::span<const std::uint32_t> order);

/// The same, from each unit's place (places_in()), for many votes on one order.
[[nodiscard]] double votes_against_places(std::span<const Vote> votes, std::span<const std::uint32_t> place);

/// The units `order` has, in an order that loses no more than that one does: each unit is taken out and put back where
/// it loses least, until no move helps (insertion neighbourhood, Laguna, Marti and Campos 1999, "Intensification and
/// diversification with elite tabu search solutions for the linear ordering problem"). A sweep costs the number of
/// votes. Those on units that the order does not have do not count.
[[nodiscard]] UnitOrder improve_order(std::span<const Vote> votes, UnitOrder order);

/// Units by what votes say of each in sum: those that others want before them come late. A start for improve_order().
[[nodiscard]] UnitOrder order_by_sums(std::span<const Vote> votes, std::span<const std::uint32_t> units);

/// What each cell of directions (coif/view_cells.h) wants of an order.
using CellVotes = std::array<std::vector<Vote>, kViewCells>;

/// A few orders, and which of them each cell draws with.
struct CellOrders {
  std::vector<UnitOrder> orders;
  std::array<std::uint8_t, kViewCells> order_of{};

  /// The votes of all cells that draw with one of them.
  [[nodiscard]] std::vector<Vote> votes_on(std::size_t order, const CellVotes& cells,
                                           const platform::Threads& threads = 1) const;
};

/// At most `count` orders for all cells, of the units that `start` has. The cells whose own order would save most of
/// all cells' lost votes found the clusters; then cells go to the order that loses least of their votes and orders are
/// improved for their cells, until neither changes anything (Lloyd's iteration, with votes for distances). Never loses
/// more votes than `start` does; the same for every number of threads.
[[nodiscard]] CellOrders cluster_orders(const CellVotes& cells, const UnitOrder& start, std::size_t count,
                                        const platform::Threads& threads);

/// The second half of that alone, from the orders of `found`, which other votes led to.
[[nodiscard]] CellOrders refine_clusters(const CellVotes& cells, CellOrders found, const platform::Threads& threads);

/// Each order found once more for the votes of its cells, from its triangles as they lie along the mean of the cells'
/// directions, the furthest first; then as refine_clusters(). Pairs of triangles that no vote was seen for end in the
/// order of their depth, which is mostly right, and fewer votes are lost as well than from an order of whole patches.
/// `positions` of all vertices.
[[nodiscard]] CellOrders refine_from_depth(const HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                                           const CellVotes& cells, CellOrders found, const platform::Threads& threads);

/// Triangles of `order` in an order that shares vertices between neighbours as far as the votes allow: two triangles
/// that have a vote on each other stay in the order they have, all others may move. What no vote was seen for moves
/// too, so judge the result. Greedy: of the triangles that nothing holds back, the one with most vertices among the
/// last few that were shaded.
[[nodiscard]] UnitOrder order_for_cache(const HairSurface& hair, std::span<const Vote> votes, const UnitOrder& order);

}  // namespace coif::visibility
