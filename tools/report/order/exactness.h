#pragma once

#include "report/order/drawn_way.h"
#include "report/order_report.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <vector>

namespace coif {

/// How far exact pictures are from each other over a few views: the same taken again, and taken layer by layer instead of by
/// lists of texels. Makes and frees OpenGL contexts of its own: none may be current. Errors: those of OrderPictures.
tl::expected<std::vector<SelfDifferenceRow>, ToolError> measure_exactness(const Asset& asset, const PosedHair& hair,
                                                                          std::uint32_t width, std::uint32_t height);

}  // namespace coif
