#pragma once

#include "base/tool_error.h"
#include "visibility/fragment_view.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <string_view>
#include <vector>

namespace coif::cook {

/// The hair in the poses that orders are found for: at rest, then, where it moves, thrown to both sides and back, and
/// blown back. `solver`: by its name in a recipe. Errors: those of simulate_pose().
tl::expected<std::vector<visibility::HairPositions>, ToolError> find_order_poses(const Asset& asset,
                                                                                 std::string_view solver);

}  // namespace coif::cook
