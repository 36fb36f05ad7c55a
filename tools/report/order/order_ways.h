#pragma once

#include "render/order_pictures.h"
#include "report/order/drawn_way.h"
#include "report/order_report.h"
#include "tool_error.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <memory>
#include <vector>

namespace coif {

/// What is compared of one asset.
struct OrderWays {
  AssetContents finest;                                  ///< The asset without coarser levels.
  DrawnWay exact;                                        ///< What all others are compared with, with `exact_material`.
  std::unique_ptr<const MaterialRecord> exact_material;  ///< The asset's, every texel's alpha as it is.
  DrawnWay own;                                          ///< Blended, with all the asset's own orders.
  std::vector<DrawnWay> orders;                          ///< Blended.
  std::vector<DrawnWay> modes;                           ///< The asset's own orders.
  std::vector<OrderLeftOut> left_out;
};

/// Of the renderer that takes exact pictures: four times what it takes by itself, for pictures of a thousand pixels each way.
inline constexpr std::uint32_t kListBytes = 256u << 20;

/// The reference: none but texels of full alpha are solid, and none but those that no 8-bit picture shows are left out. Hair
/// that is cut by a mask stays as it is: there its alpha only says where the edge is.
[[nodiscard]] MaterialRecord with_true_alphas(MaterialRecord material);

/// Uploads the asset once per order. Errors: those of OrderPictures.
tl::expected<OrderWays, ToolError> make_order_ways(const Asset& asset, OrderPictures& pictures);

}  // namespace coif
