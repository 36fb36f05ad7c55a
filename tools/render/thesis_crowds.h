#pragma once

#include "render/affordable_crowds.h"
#include "render/crowd_stage.h"
#include "render/frame_timing.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace coif {

/// As in the thesis's Table 1 (6. Results).
struct ThesisCrowdSettings {
  std::vector<std::uint32_t> heads{20, 50, 100, 200};  ///< 1..kMostDrawnHeads, not empty.
  std::uint32_t width = 1024, height = 768;            ///< Pixels, 16..8192.
  double seconds = 14;                                 ///< To spend, > 0, but for at least some frames of each way.
  double longest_frame = 15;                           ///< Seconds; crowds with longer ones are left out.
};

struct ThesisCrowdRow {
  std::uint32_t heads = 0;
  bool transparency = true;  ///< kBlendMode; else kOpaqueMode.
  bool simulation = true;    ///< The crowd is stepped before it is drawn.
  FrameTime time;
};

struct ThesisCrowds {
  std::string device;                ///< GL_RENDERER.
  std::vector<ThesisCrowdRow> rows;  ///< Four for each crowd, by heads.
  std::vector<DrawCostLeftOut> left_out;
};

/// Times crowds with and without transparency and simulation, all in turns. Every crowd is seen from where all heads of
/// the largest fit into the picture, so that a head is as large in one as in the other. Errors: those of
/// CrowdStage::create() and AffordableCrowds::add(), kUsage for settings out of range.
tl::expected<ThesisCrowds, ToolError> measure_thesis_crowds(const Asset& asset, const ThesisCrowdSettings& settings,
                                                            const MakeCrowd& make_crowd);

}  // namespace coif
