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

/// For each unit below `units` its place in `order`; 0 where the order does not have it.
[[nodiscard]] std::vector<std::uint32_t> places_in(std::span<const std::uint32_t> order, std::size_t units);

/// The loss of an order: the sum of the weights of the votes against it.
[[nodiscard]] double votes_against(std::span<const Vote> votes, std::span<const std::uint32_t> order);

/// The same from each unit's place (places_in()), for many votes on one order.
[[nodiscard]] double votes_against_places(std::span<const Vote> votes, std::span<const std::uint32_t> place);

/// Sorts the units of `order` without increasing its loss: each unit is taken out and put back where the loss is least,
/// until no move helps (insertion neighbourhood, Laguna, Marti and Campos 1999, "Intensification and diversification
/// with elite tabu search solutions for the linear ordering problem"). A sweep takes time in proportion to the votes.
/// Votes on units that the order does not have do not count.
[[nodiscard]] UnitOrder improve_order(std::span<const Vote> votes, UnitOrder order);

/// Sorts units by the sum of their votes: units before which others want to be come late. A start for improve_order().
[[nodiscard]] UnitOrder order_by_sums(std::span<const Vote> votes, std::span<const std::uint32_t> units);

/// The votes of each cell of directions (coif/view_cells.h).
using CellVotes = std::array<std::vector<Vote>, kViewCells>;

/// A few orders, and the order that each cell uses.
struct CellOrders {
  std::vector<UnitOrder> orders;
  std::array<std::uint8_t, kViewCells> order_of{};

  /// The votes of all cells that use one of them.
  [[nodiscard]] std::vector<Vote> votes_on(std::size_t order, const CellVotes& cells,
                                           const platform::Threads& threads = 1) const;
};

/// Finds at most `count` orders for all cells, of the units of `start`. The cells whose own order would save most of
/// all cells' lost votes start the clusters; then cells go to the order that loses least of their votes and orders are
/// improved for their cells, until neither changes anything (Lloyd's iteration, with votes as distances). Never loses
/// more votes than `start`; the result does not depend on the number of threads.
[[nodiscard]] CellOrders cluster_orders(const CellVotes& cells, const UnitOrder& start, std::size_t count,
                                        const platform::Threads& threads);

/// The second half of that alone, from the orders of `found`, which other votes led to.
[[nodiscard]] CellOrders refine_clusters(const CellVotes& cells, CellOrders found, const platform::Threads& threads);

/// Finds each order again for the votes of its cells, starting with its triangles sorted by depth along the mean of the
/// cells' directions, the furthest first; then as refine_clusters(). Pairs of triangles without a vote end in the order
/// of their depth, which is mostly right; and fewer votes are lost than from an order of whole patches. `positions` of
/// all vertices.
[[nodiscard]] CellOrders refine_from_depth(const HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                                           const CellVotes& cells, CellOrders found, const platform::Threads& threads);

/// Reorders triangles of `order` so that neighbours share vertices, as far as the votes allow: two triangles with a
/// vote between them keep their order, all others may move. Pairs without a vote change too, so judge the result.
/// Greedy: among the triangles that nothing holds back, it takes the one with most vertices among the last few that
/// were shaded.
[[nodiscard]] UnitOrder order_for_cache(const HairSurface& hair, std::span<const Vote> votes, const UnitOrder& order);

}  // namespace coif::visibility
