#pragma once

#include "report/measure_accuracy.h"
#include "report/order_report.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>

namespace coif {

struct OrderSettings {
  std::uint32_t width = 256, height = 256;  ///< Pixels, 16..1024, one sample each but for modes that need more.
  std::uint32_t views = 96;         ///< 1..kViewCells; evenly taken from the middles of the cells of directions.
  std::uint32_t orbit_frames = 90;  ///< By steps of one degree, 0 (popping is not measured) or 2..360.
  bool modes = true;                ///< Also compares other ways to draw, thresholds and distances.
};

/// Draws the finest level in every order and pose and from every view with the runtime's renderer, and compares each picture
/// with the exact one. The head is in the middle of the studio's perspective picture, as a game shows it: a card's place before
/// another may differ a little from that along the view's parallel lines, for which the cooker chose. Errors: kUsage for
/// settings out of range, kBadInput for an asset without a mesh, kUnsupported where nothing can be drawn.
tl::expected<OrderReport, ToolError> measure_order(const Asset& asset, const OrderSettings& settings,
                                                   const ReportProgress& progress);

}  // namespace coif
