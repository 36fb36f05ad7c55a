#pragma once

#include "render/order_pictures.h"
#include "report/order/compare_pictures.h"
#include "report/order/drawn_way.h"

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// Milliseconds of a frame of each way, one head, all ways in turns for about `seconds`. Ways that sort in every frame sort
/// `indices`, too, but do not hand them to the device.
[[nodiscard]] std::vector<double> measure_order_times(OrderPictures& pictures, const PictureComparer& comparer,
                                                      std::span<const DrawnWay> ways, const PosedHair& hair,
                                                      std::span<const std::uint32_t> indices, double seconds);

}  // namespace coif
