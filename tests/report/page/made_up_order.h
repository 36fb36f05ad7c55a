#pragma once

#include "report/order_report.h"

namespace coif {

/// Orders head (20 dB), view (40 dB) and triangles (44 dB) at rest and in a turn over 4 views, the modes blend and opaque at
/// rest, an own threshold of 0.8 where 0.9 would be better, hair that gets thin at 16 pixels; no bones.
[[nodiscard]] OrderReport made_up_order();

}  // namespace coif
