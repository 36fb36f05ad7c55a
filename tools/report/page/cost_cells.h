#pragma once

#include "report/page/html_page.h"

#include <cstdint>

namespace coif {

[[nodiscard]] Cell count_cell(std::uint64_t count);

/// Half the width of the middle half of samples, which `spread_pct` is, in % of their median; stands out where the
/// machine was not steady.
[[nodiscard]] Cell spread_cell(double spread_pct);

}  // namespace coif
