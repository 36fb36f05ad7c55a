#pragma once

#include "visibility/sight_lines.h"

#include <array>
#include <vector>

namespace coif {

/// Hair in one pose.
using HairPositions = std::vector<Eigen::Vector3f>;

/// The hair from all sides, in several poses: what orders are found from, or judged by.
struct ViewSamples {
  struct View {
    std::uint32_t cell = 0;  ///< That its direction lies in.
    std::uint32_t pose = 0;
    SightLines lines;
  };
  std::vector<View> views;
};

struct SampleSettings {
  std::size_t views_per_cell = 1;
  std::uint32_t seed = 0;     ///< Other seeds look from other directions.
  std::size_t lines = 3000;   ///< Wanted per view.
  float solid_alpha = 0.95f;  ///< Layers behind one of at least this alpha do not matter.
  float pixel = 0.001f;       ///< Metres; as ViewGrid.
  unsigned threads = 1;       ///< Of sample_views(); without influence on the result.
};

/// Views in directions that fill a cell evenly. They take the poses by turns; every cell begins with another, the first
/// pose, at rest, comes every other time.
[[nodiscard]] ViewSamples sample_cell(const HairSurface& hair, std::span<const HairPositions> poses,
                                      const SampleSettings& settings, std::uint32_t cell);

/// Those of all cells.
[[nodiscard]] ViewSamples sample_views(const HairSurface& hair, std::span<const HairPositions> poses,
                                       const SampleSettings& settings);

/// Direction `index` of a sequence that fills a cell evenly, unit.
[[nodiscard]] Eigen::Vector3f direction_in_cell(std::uint32_t cell, std::uint32_t index);

}  // namespace coif
