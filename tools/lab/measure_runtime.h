#pragma once

#include "lab/reference_solver.h"
#include "lab/rig.h"
#include "motion/head_path.h"

#include <coif/asset.h>

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace coif::lab {

/// The converged solution of one motion, to compare the runtime with at several frame rates.
struct KnownMotion {
  motion::Motion motion = motion::Motion::kStill;
  ReferenceRun reference;
};

/// Errors of the runtime's default solver at one frame rate. Shares, not percent; NaN where it did not stay finite.
struct RuntimeError {
  double rms = 0;  ///< Distance of the tips to the reference over the chain's length, at every frame.
  double max = 0;
  double worst_second = 0;  ///< RMS error of the worst second.
  double stretch = 0;       ///< Worst |length / rest - 1|.
  double penetration = 0;   ///< Worst depth over the collider's smallest radius.
};

/// The times up to `seconds` at which frames of any of these rates (whole numbers) end.
[[nodiscard]] std::vector<double> frame_times(std::span<const std::uint32_t> rates, double seconds);

/// RMS over the worst second of frames, of which each has the mean square of its distances; over all where that is
/// shorter.
[[nodiscard]] double worst_second(std::span<const double> mean_squares, double frames_per_second);

/// Runs `motion` from rest at `rate` frames per second with this many sub-steps, and compares at every frame that the
/// reference has. `rig` must be the asset's.
[[nodiscard]] RuntimeError measure_runtime(const Asset& asset, const Rig& rig, const KnownMotion& motion,
                                           std::uint32_t rate, std::uint32_t substeps,
                                           const std::stop_token& stop = {});

}  // namespace coif::lab
