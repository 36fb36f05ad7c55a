#pragma once

#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <vector>

namespace coif {

/// Which points of two surfaces are the same.
struct SurfaceMatch {
  std::vector<std::uint32_t> vertex_a;  ///< Vertices of A's finest level, ascending.
  std::vector<std::uint32_t>
      vertex_b;              ///< For each the nearest of B's at rest; at one place that with nearest texture.
  std::vector<double> area;  ///< Share of A's surface around it; all add up to one.
  double rest_rms = 0;       ///< Metres between the two at rest.
};

/// Two rest surfaces farther apart than this, RMS, metres, are not of the same source.
inline constexpr double kSameSurface = 1.0e-3;

/// Matches vertices in the model's space, so that the assets may have different head bones. Errors: kUnsupported for an
/// asset without a skinned mesh, kBadInput for surfaces that are not the same. Near-linear time.
tl::expected<SurfaceMatch, ToolError> match_surfaces(const Asset& a, const Asset& b);

}  // namespace coif
