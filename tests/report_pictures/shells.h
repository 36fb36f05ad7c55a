#pragma once

#include "write/asset_writer.h"

namespace coif {

/// Two boxes of half-transparent cards that face outwards, a dark one in a bright one: from every side the inner one's
/// front has to be drawn before the outer one's. The file has the outer box first; head distances are true; stored as
/// in the file. One-sided, so that a box's far side does not show.
[[nodiscard]] AssetContents shells();

/// The same with one further order, inner box first, for all directions.
[[nodiscard]] AssetContents shells_with_orders();

}  // namespace coif
