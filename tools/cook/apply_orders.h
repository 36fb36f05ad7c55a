#pragma once

#include "visibility/order_search.h"
#include "write/asset_writer.h"

namespace coif {

/// Puts the patches of every level of detail into the order found for the finest one, and their triangles with them; writes
/// the orders by direction, and in the material how they are to be drawn. Patches of coarser levels go where those of the
/// finest with the same place in the file are; in orders of triangles, where these are on average.
void apply_orders(const FoundOrders& found, AssetContents& contents);

}  // namespace coif
