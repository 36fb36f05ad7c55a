#pragma once

#include "report/measure_accuracy.h"
#include "report/shadow_report.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <vector>

namespace coif {

struct ShadowSettings {
  std::vector<std::uint32_t> sizes{256, 512, 1024};  ///< Of the maps, 16..4096, not empty.
  double spacing = 0.002;                            ///< Metres between lines of the reference, 0.0005..0.02.
};

/// Draws the map of each technique under some lights and in some poses, asks it how much light reaches points of hair and
/// head, and compares with what is exact. Errors: kUsage for settings out of range, kBadInput for an asset without a mesh,
/// kUnsupported where nothing can be drawn.
tl::expected<ShadowReport, ToolError> measure_shadows(const Asset& asset, const ShadowSettings& settings,
                                                      const ReportProgress& progress);

}  // namespace coif
