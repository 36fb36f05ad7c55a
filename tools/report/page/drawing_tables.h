#pragma once

#include "report/cost_report.h"
#include "report/page/html_page.h"

namespace coif {

// Times on the device itself have a column where at least one row has one.

[[nodiscard]] Table rendering_table(const RenderingCost& rendering);
/// The thesis's Table 1: what was measured here beside what it has.
[[nodiscard]] Table thesis_table(const ThesisTable& measured);
[[nodiscard]] Table thesis_ratios_table(const ThesisTable& measured);
/// What a head costs at every size, with the level of detail that suits it and without.
[[nodiscard]] Table distances_table(const RenderingCost& rendering);

}  // namespace coif
