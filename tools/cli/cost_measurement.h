#pragma once

#include "report/measure_cost.h"

#include <cstdint>

namespace coif {

/// What `coif report cost` measures.
struct CostChoice {
  CostSettings simulation;                  ///< Its time is set from `seconds`.
  std::uint32_t width = 512, height = 384;  ///< Pixels of a drawn frame.
  bool draws = true;
  double seconds = 18;        ///< About, for all but the thesis's table, which takes as long again.
  bool thesis_table = false;  ///< Also the thesis's Table 1.
  std::uint32_t thesis_width = 1024, thesis_height = 768;  ///< Pixels of its frames.
};

/// Simulation by tools/report and drawing by tools/render as one report. Hair that cannot be drawn, here or at all, is
/// no error: the report says why. Errors: those of measure_cost(), and kBadInput for an asset with neither simulated
/// bones nor a mesh.
tl::expected<CostReport, ToolError> measure_all_cost(const Asset& asset, const CostChoice& choice,
                                                     const ReportProgress& progress);

}  // namespace coif
