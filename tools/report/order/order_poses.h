#pragma once

#include "report/order/drawn_way.h"
#include "report/order_report.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <vector>

namespace coif {

/// "rest", the settled hair, and for hair that moves "turn" and "charge", each at three moments: the head at its fastest, the
/// hair at its furthest, on its way back. Errors: those of simulate_pose().
tl::expected<std::vector<OrderPose>, ToolError> make_order_poses(const Asset& asset);

/// Directions to look from, each for the same share of the sphere, neighbours in the list far apart: a spherical Fibonacci
/// lattice (Gonzalez 2010, "Measurement of areas on a sphere using Fibonacci and latitude-longitude lattices").
[[nodiscard]] std::vector<ViewAngle> spread_directions(std::uint32_t count);

}  // namespace coif
