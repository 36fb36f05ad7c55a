#pragma once

#include "tool_error.h"

#include <coif/asset.h>
#include <coif/math.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// A crowd to draw; whoever measures says how it is simulated.
struct DrawnCrowd {
  std::function<void()> step;  ///< One frame of all heads.
  std::function<std::span<const Mat34>(std::uint32_t head)> palette;
};
using MakeCrowd = std::function<tl::expected<DrawnCrowd, ToolError>(std::uint32_t heads)>;

struct DrawCostSettings {
  std::vector<std::uint32_t> heads{1, 10, 100};  ///< Sizes of the crowd, 1..10000.
  std::uint32_t width = 512, height = 384;       ///< Pixels, 16..8192, one sample each.
  double seconds = 6;  ///< To spend, > 0. Crowds that would take longer are left out; one head never is.
};

/// One way to draw a crowd that fills the picture.
struct DrawCostRow {
  std::uint32_t heads = 1;
  std::uint32_t lod = 0;
  bool transparency = true;  ///< DrawDesc::transparency: four passes or one.
  bool simulation = false;   ///< The crowd is stepped before it is drawn.
  double seconds = 0;        ///< Wall time of a frame until the device has finished, median.
  double spread_pct = 0;     ///< Width of the middle half of the frames, % of the median.
};

/// A crowd that was not measured.
struct DrawCostLeftOut {
  std::uint32_t heads = 0;
  std::string why;
};

struct DrawCost {
  std::string device;                     ///< GL_RENDERER.
  std::vector<DrawCostRow> rows;          ///< By heads; for one head every level of detail, for the others the finest.
  std::vector<DrawCostLeftOut> left_out;  ///< Ascending; all crowds from some size on.
};

/// Times the runtime's own renderer on a framebuffer without a window. Errors: kUnsupported where no EGL display with
/// OpenGL ES 3.0 can be had or the driver refuses the asset, kBadInput for an asset without a mesh, kUsage for settings
/// out of range; those of `make_crowd`.
tl::expected<DrawCost, ToolError> measure_drawing(const Asset& asset, const DrawCostSettings& settings,
                                                  const MakeCrowd& make_crowd);

}  // namespace coif
