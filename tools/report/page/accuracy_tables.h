#pragma once

#include "report/accuracy_report.h"
#include "report/page/html_page.h"

namespace coif {

/// Every solver and setting at one frame rate, over all motions; cells are coloured against the budget.
[[nodiscard]] Table settings_table(const AccuracyReport& report);

/// Frame-rate spread: a row for each setting, a column for each motion.
[[nodiscard]] Table spread_table(const AccuracyReport& report);

[[nodiscard]] Table reference_table(const AccuracyReport& report);
[[nodiscard]] Table settle_table(const AccuracyReport& report);

/// All rows of the report.
[[nodiscard]] Table rows_table(const AccuracyReport& report);

}  // namespace coif
