#pragma once

#include "render/order_pictures.h"
#include "report/order/drawn_way.h"
#include "report/order_report.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <vector>

namespace coif {

/// How much of the hair is left where `asset`, which `pictures` has as `model` with all its levels, is drawn as in a game
/// at 512, 256, ... 16 pixels, mean over some views around it. Errors: those of OrderPictures.
tl::expected<std::vector<DistanceRow>, ToolError> measure_distances(const Asset& asset, OrderPictures& pictures,
                                                                    std::size_t model, const DrawnWay& exact,
                                                                    const PosedHair& hair);

}  // namespace coif
