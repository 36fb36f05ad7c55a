#pragma once

#include <coif/asset.h>

namespace coif {

/// Reads whatever a runtime may read of an open asset, through every reference in it; a value outside its promise shows as
/// a sum that is not finite, or under AddressSanitizer.
[[nodiscard]] double touch_asset(const Asset& asset);

}  // namespace coif
