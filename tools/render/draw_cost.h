#pragma once

#include "base/tool_error.h"
#include "render/crowd_stage.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::render {

/// A crowd and how far away it is.
struct CrowdDistance {
  std::uint32_t heads = 1;  ///< 1..kMostDrawnHeads.
  double times_as_far = 1;  ///< Multiple of the distance at which the crowd fills the picture, >= 1.
};

struct DrawDistance {
  CrowdDistance crowd;
  double screen_share = 0;    ///< A head's share of the picture's height, the argument of choose_lod().
  std::uint32_t lod = 0;      ///< The result of choose_lod().
  double covered_pixels = 0;  ///< Pixels that hair touches, of the whole crowd at that level; each counted once.
  FrameTime time;             ///< The whole crowd at that level.
  FrameTime finest;           ///< The whole crowd at level 0.
};

struct DrawDistances {
  std::vector<DrawDistance> rows;         ///< In the order of the request.
  std::vector<DrawCostLeftOut> left_out;  ///< All from some crowd on.
};

/// Height of a head in metres: of the tallest collider that hair keeps out of, or of the hair where there is none.
[[nodiscard]] double head_height(const Asset& asset);

/// Limits for measuring.
struct DrawTime {
  double seconds = 6;  ///< About the time to spend, > 0, but at least some frames of each way.
  /// Seconds. Crowds whose frames take longer are left out, but never one head. Without it, crowds that need more than
  /// a good part of `seconds` are left out.
  std::optional<double> longest_frame;
};

/// Times crowds with blend, at rest. `crowds`: each has at least as many heads as the one before. Errors: those of
/// AffordableCrowds::add().
tl::expected<DrawDistances, ToolError> measure_distances(const Asset& asset, CrowdStage& stage,
                                                         std::span<const CrowdDistance> crowds,
                                                         const MakeCrowd& make_crowd, const DrawTime& time);

struct DrawCostSettings {
  std::vector<std::uint32_t> heads{1, 10, 100};  ///< Sizes of the crowd, 1..kMostDrawnHeads.
  /// Crowds that show the savings by distance, each with at least as many heads as the one before; empty: none.
  std::vector<CrowdDistance> distances{{1, 1}, {4, 1}, {16, 1}, {16, 2}, {16, 4}, {16, 8}};
  std::uint32_t width = 512, height = 384;  ///< Pixels, 16..8192.
  DrawTime time;
};

/// One way to draw a crowd that fills the picture.
struct DrawCostRow {
  std::uint32_t heads = 1;
  std::string transparency;   ///< name_of() the mode.
  std::uint32_t samples = 1;  ///< Per pixel.
  std::uint32_t lod = 0;
  bool simulation = false;    ///< The crowd is stepped before it is drawn.
  bool strand_terms = false;  ///< As in DrawnFrame.
  FrameTime time;
};

struct DrawCost {
  std::string device;  ///< GL_RENDERER.
  /// By heads; every crowd with blend and opaque, simulated and not. The smallest crowd also with every level of
  /// detail, with all strand terms, and in every mode, with one sample per pixel, and with four where the mode is for
  /// them.
  std::vector<DrawCostRow> rows;
  DrawDistances distances;
  std::vector<DrawCostLeftOut> left_out;  ///< Crowds missing in `rows`: ascending, all from some size on.
};

/// Times the runtime's own renderer on a framebuffer without a window. Errors: those of CrowdStage::create(), kUsage
/// for settings out of range; those of `make_crowd`.
tl::expected<DrawCost, ToolError> measure_drawing(const Asset& asset, const DrawCostSettings& settings,
                                                  const MakeCrowd& make_crowd);

/// As in the thesis's Table 1 (6. Results).
struct ThesisCrowdSettings {
  std::vector<std::uint32_t> heads{20, 50, 100, 200};  ///< 1..kMostDrawnHeads, not empty.
  std::uint32_t width = 1024, height = 768;            ///< Pixels, 16..8192.
  DrawTime time{14, {}};                               ///< Without a longest frame, one may take 15 s.
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

/// Times crowds with and without transparency and simulation, all in turns. Every crowd is seen from the distance at
/// which all heads of the largest fit into the picture, so that heads have the same size in all. Errors: those of
/// CrowdStage::create() and AffordableCrowds::add(), kUsage for settings out of range.
tl::expected<ThesisCrowds, ToolError> measure_thesis_crowds(const Asset& asset, const ThesisCrowdSettings& settings,
                                                            const MakeCrowd& make_crowd);

}  // namespace coif::render
