#pragma once

#include "render/order_pictures.h"
#include "report/order/drawn_way.h"
#include "report/order_report.h"
#include "tool_error.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <vector>

namespace coif {

/// What is compared of one asset. `finest` is moved into it, so that materials of ways may point there.
struct OrderWays {
  AssetContents finest;          ///< The asset without coarser levels.
  DrawnWay exact;                ///< What all others are compared with.
  DrawnWay own;                  ///< Blended, with all the asset's own orders.
  std::vector<DrawnWay> orders;  ///< Blended.
  std::vector<DrawnWay> modes;   ///< The asset's own orders.
  std::vector<OrderLeftOut> left_out;
};

/// Uploads the asset once per order. Errors: those of OrderPictures; kUnsupported where there is no exact mode.
tl::expected<OrderWays, ToolError> make_order_ways(const Asset& asset, OrderPictures& pictures);

}  // namespace coif
