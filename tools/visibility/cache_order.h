#pragma once

#include "visibility/hair_surface.h"
#include "visibility/linear_order.h"

namespace coif {

/// Triangles of `order` in an order that shares vertices between neighbours as far as the votes allow: two triangles that have
/// a vote on each other stay in the order they have, all others may move. What no vote was seen for moves too, so judge the
/// result. Greedy: of the triangles that nothing holds back, the one with most vertices among the last few that were shaded.
[[nodiscard]] UnitOrder order_for_cache(const HairSurface& hair, std::span<const Vote> votes, const UnitOrder& order);

}  // namespace coif
