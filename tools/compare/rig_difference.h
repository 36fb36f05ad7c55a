#pragma once

#include "animation/recording.h"
#include "base/tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <vector>

namespace coif::compare {

/// Corresponding points of two surfaces.
struct SurfaceMatch {
  std::vector<std::uint32_t> vertex_a;  ///< Vertices of A's finest level, ascending.
  /// For each the nearest vertex of B at rest; among those at one place the one with the nearest texture coordinates.
  std::vector<std::uint32_t> vertex_b;
  std::vector<double> area;  ///< Share of A's surface around it; all add up to one.
  double rest_rms = 0;       ///< Metres between the two at rest.
};

/// Two rest surfaces farther apart than this, RMS, metres, are not of the same source.
inline constexpr double kSameSurface = 1.0e-3;

/// Matches vertices in the model's space, so that the assets may have different head bones. Errors: kUnsupported for an
/// asset without a skinned mesh, kBadInput for surfaces that are not the same. Near-linear time.
tl::expected<SurfaceMatch, ToolError> match_surfaces(const Asset& a, const Asset& b);

/// The difference between the motions of one surface by two rigs. A point's displacement is from its place at rest, in
/// head space; RMS is over the surface and all frames.
struct RigDifference {
  double rms = 0;    ///< Metres, between the displacements by A and by B.
  double max = 0;    ///< Metres, at the worst point and frame.
  double moved = 0;  ///< Metres, RMS displacement by A.
  double ratio = 0;  ///< rms / moved. 0: the same motion; 1: as wrong as B not moving at all. 0 where A does not move.
  /// The ratio of a rig that holds A's mean pose throughout: gravity's sag is right, everything else is missing.
  double still_ratio = 0;
};

/// Simulates both with the same settings and compares frame by frame. Errors: those of record().
tl::expected<RigDifference, ToolError> compare_rigs(const Asset& a, const Asset& b, const SurfaceMatch& match,
                                                    const animation::RecordingSettings& settings);

/// Diagonal of the box around the asset's hair at rest, metres.
[[nodiscard]] double hair_size(const Asset& asset);

}  // namespace coif::compare
