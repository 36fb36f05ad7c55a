#pragma once

#include "render/affordable_crowds.h"
#include "render/crowd_stage.h"
#include "render/frame_timing.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// A crowd and how far away it is.
struct CrowdDistance {
  std::uint32_t heads = 1;  ///< 1..kMostDrawnHeads.
  double times_as_far = 1;  ///< As where the crowd fills the picture, >= 1.
};

struct DrawDistance {
  CrowdDistance crowd;
  double screen_share = 0;    ///< Of the picture's height, that of a head: what choose_lod() is asked with.
  std::uint32_t lod = 0;      ///< What it answers.
  double covered_pixels = 0;  ///< That hair touches, of the whole crowd, at that level; each counted once.
  FrameTime time;             ///< Of the whole crowd, at that level,
  FrameTime finest;           ///< and at level 0.
};

struct DrawDistances {
  std::vector<DrawDistance> rows;         ///< In the order asked for.
  std::vector<DrawCostLeftOut> left_out;  ///< All from some crowd on.
};

/// Height of a head in metres: of the tallest collider that hair stays out of, or of the hair where there is none.
[[nodiscard]] double head_height(const Asset& asset);

/// Times crowds with blend, at rest, for about `seconds` (> 0). Those whose frames would take too long are left out;
/// one head never is. `crowds`: no fewer heads than before. Errors: those of AffordableCrowds::add().
tl::expected<DrawDistances, ToolError> measure_distances(const Asset& asset, CrowdStage& stage,
                                                         std::span<const CrowdDistance> crowds,
                                                         const MakeCrowd& make_crowd, double seconds);

}  // namespace coif
