#pragma once

#include "render/crowd_stage.h"

#include <optional>
#include <span>
#include <vector>

namespace coif {

struct FrameTime {
  double seconds = 0;                 ///< Wall time until the device has finished, median.
  double spread_pct = 0;              ///< Width of the middle half of the frames, % of the median.
  std::optional<double> gpu_seconds{};  ///< As the device itself tells, median; nothing where it does not.
};

inline constexpr unsigned kLeastFrames = 3;  ///< Of each way, however long they take.

/// Draws frames in turns for about `seconds` (> 0), so that a machine that is slower for a while is slower for all. Each
/// must be one that `stage` can draw.
[[nodiscard]] std::vector<FrameTime> time_frames(CrowdStage& stage, std::span<const DrawnFrame> frames, double seconds);

}  // namespace coif
