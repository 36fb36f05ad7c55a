#pragma once

#include "animation/recording.h"
#include "compare/surface_match.h"

namespace coif {

/// How differently two rigs move one surface. A point's displacement is from its place at rest, in head space; RMS is over
/// the surface and all frames.
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
                                                    const RecordingSettings& settings);

/// Diagonal of the box around the asset's hair at rest, metres.
[[nodiscard]] double hair_size(const Asset& asset);

}  // namespace coif
