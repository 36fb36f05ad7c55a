#pragma once

#include "platform/stop.h"
#include "visibility/fragment_view.h"
#include "visibility/linear_order.h"
#include "visibility/order_error.h"
#include "visibility/order_judge.h"
#include "visibility/rest_votes.h"

#include <optional>
#include <vector>

namespace coif::visibility {

/// All triangles of each unit after those of the unit before it; in stored order within a unit.
[[nodiscard]] UnitOrder triangles_in_order(std::span<const std::uint32_t> unit_order,
                                           std::span<const std::uint32_t> unit_of_triangle);

struct OrderSearchSettings {
  std::size_t max_orders = 8;  ///< The stored one included; 1: no others.
  /// dB by which other orders must be better than the stored one: eight bits do not show less.
  double min_gain = 0.5;
  float opaque_threshold = 0.95f;
  std::optional<bool> faces_together;  ///< None: the better one.
  /// Views that orders are found from; with more, time grows and fewer conflicts are missed.
  std::size_t views_per_cell = 32;
  /// Other views that orders are judged by; at most as many as the judged hair has.
  std::size_t judge_views_per_cell = 2;
  std::size_t lines_per_view = 4000;
  platform::Threads threads = 1;  ///< Without influence on the result.
};

/// How to draw the hair, and the quality of that.
struct FoundOrders {
  DrawRule rule;
  UnitOrder patches;    ///< The best order of whole patches.
  CellOrders by_view;   ///< Orders of triangles for directions; none where they would gain too little.
  OrderQuality head;    ///< By distance from the head, faces apart.
  OrderQuality single;  ///< `patches`, for all directions.
  OrderQuality found;   ///< The result: `by_view`, else `single`.
  double limit = 0;     ///< dB that the best conceivable order has.
};

/// The views by which the settings judge. Also for any other settings with as many lines.
[[nodiscard]] JudgedHair judged_hair(const SeenHair& hair, std::span<const HairPositions> poses,
                                     const OrderSearchSettings& settings);

/// Looks for better orders than `by_head_distance`, which has all patches. `poses`: the first at rest. Orders that are
/// judged worse than that one are never given back. `judged`: the same hair, whatever its mips' alpha.
///
/// Layers vote (votes_of()), orders are improved until no single move helps, cells of directions share a few orders of
/// triangles (cluster_orders()); all are judged by views of their own. Source of the idea: Chen, Sander, Nehab, Yang
/// and Hu 2012, "Depth-presorted triangle lists", here for blending, with alphas for weights.
[[nodiscard]] FoundOrders search_orders(const HairSurface& hair, const JudgedHair& judged,
                                        std::span<const HairPositions> poses, const UnitOrder& by_head_distance,
                                        const OrderSearchSettings& settings);

/// Continues a search with fewer views, with its faces and at most its number of orders: most of a search's time goes
/// into grouping the directions, for which few views suffice. `seen`: votes of the same hair in its first pose, along
/// as many lines, that need not be found again.
[[nodiscard]] FoundOrders refine_orders(const HairSurface& hair, const JudgedHair& judged,
                                        std::span<const HairPositions> poses, const UnitOrder& by_head_distance,
                                        const FoundOrders& found, const OrderSearchSettings& settings,
                                        const RestVotes& seen = {});

/// The share of the squared error of pictures in orders by direction, found with any threshold, that the best order
/// would not have.
[[nodiscard]] double share_of_order(const HairSurface& hair, const JudgedHair& judged, const FoundOrders& orders,
                                    const OrderSearchSettings& settings);

/// The quality of orders that were found with another threshold, by the views that the search judges by.
[[nodiscard]] OrderQuality judge_orders(const HairSurface& hair, const JudgedHair& judged, const FoundOrders& orders,
                                        const OrderSearchSettings& settings);

}  // namespace coif::visibility
