#include "report/page/cost_cells.h"

#include <fmt/format.h>

namespace coif {

Cell count_cell(std::uint64_t count) { return {std::to_string(count)}; }

Cell spread_cell(double spread_pct) {
  // Samples that differ by a quarter are of a machine that had other work.
  constexpr double kUnsteadyPct = 25;
  const std::string text = fmt::format("\u00b1{:.1f} %", spread_pct / 2);
  return {text, spread_pct > kUnsteadyPct ? CellLook::kWarning : CellLook::kPlain};
}

}  // namespace coif
