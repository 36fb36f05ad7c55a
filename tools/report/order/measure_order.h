#pragma once

#include "report/measure_accuracy.h"
#include "report/order_report.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>

namespace coif {

inline constexpr std::uint32_t kMostOrderViews = 1000;

struct OrderSettings {
  std::uint32_t width = 160, height = 160;  ///< Pixels, 16..1024, one sample each but for modes that need more.
  std::uint32_t views = 64;                 ///< 1..kMostOrderViews, evenly spread over the sphere.
  std::uint32_t orbit_frames = 30;          ///< By steps of one degree, 0 (popping is not measured) or 2..360.
  double timing_seconds = 3;                ///< To spend on times of frames, > 0; five of each are taken at least.
  bool modes = true;                        ///< Also compares other ways to draw, thresholds and distances, at rest.
};

/// Draws the finest level in every order and pose and from every view with the runtime's renderer, and compares each picture
/// with the exact one. The camera is the studio's, with perspective as in a game, and the directions are not those of
/// the cells for which the cooker chose. Errors: kUsage for settings out of range, kBadInput for an asset without a mesh,
/// kUnsupported where nothing can be drawn.
tl::expected<OrderReport, ToolError> measure_order(const Asset& asset, const OrderSettings& settings,
                                                   const ReportProgress& progress);

}  // namespace coif
