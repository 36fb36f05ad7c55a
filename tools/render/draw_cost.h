#pragma once

#include "render/affordable_crowds.h"
#include "render/crowd_stage.h"
#include "render/draw_distances.h"
#include "render/frame_timing.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace coif {

struct DrawCostSettings {
  std::vector<std::uint32_t> heads{1, 10, 100};  ///< Sizes of the crowd, 1..kMostDrawnHeads.
  /// Crowds that show what distance spares, no fewer heads than before; empty: none.
  std::vector<CrowdDistance> distances{{1, 1}, {4, 1}, {16, 1}, {16, 2}, {16, 4}, {16, 8}};
  std::uint32_t width = 512, height = 384;  ///< Pixels, 16..8192.
  double seconds = 6;  ///< To spend, > 0. Crowds that would take longer are left out; one head never is.
};

/// One way to draw a crowd that fills the picture.
struct DrawCostRow {
  std::uint32_t heads = 1;
  std::string transparency;   ///< name_of() the mode.
  std::uint32_t samples = 1;  ///< Of a pixel.
  std::uint32_t lod = 0;
  bool simulation = false;  ///< The crowd is stepped before it is drawn.
  FrameTime time;
};

struct DrawCost {
  std::string device;  ///< GL_RENDERER.
  /// By heads; every crowd with blend and opaque, simulated and not. The smallest crowd also with every level of detail
  /// and in every mode, with one sample a pixel and with four where the mode is for them.
  std::vector<DrawCostRow> rows;
  DrawDistances distances;
  std::vector<DrawCostLeftOut> left_out;  ///< Of `rows`; ascending; all crowds from some size on.
};

/// Times the runtime's own renderer on a framebuffer without a window. Errors: those of CrowdStage::create(), kUsage
/// for settings out of range; those of `make_crowd`.
tl::expected<DrawCost, ToolError> measure_drawing(const Asset& asset, const DrawCostSettings& settings,
                                                  const MakeCrowd& make_crowd);

}  // namespace coif
