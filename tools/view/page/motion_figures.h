#pragma once

#include <coif/asset.h>
#include <coif/hair.h>

#include <cstdint>

namespace coif::view {

/// A way to simulate hair, for which the asset may know the error.
struct SimulatedSo {
  float rate = 60;             ///< Steps a second.
  std::uint32_t substeps = 1;  ///< Per step.
  const Solver* solver = &kCoifSolver;
  bool is_tuned = false;  ///< Bones move by other numbers than the asset's own.
};

/// The source of a number, or the reason why there is none.
enum class TipErrorSource : std::uint8_t {
  kMeasured,       ///< Measured with these settings.
  kCoarser,        ///< Measured at a slower rate with sub-steps that are not shorter: an upper bound.
  kDraft,          ///< Drafts are not measured.
  kNotMeasured,    ///< The asset was not measured.
  kOtherSolver,    ///< kCoifSolver was measured.
  kOtherDynamics,  ///< The asset's own dynamics were measured.
  kTooCoarse,      ///< Nothing as slow was measured.
};

/// Errors of tips against the converged solution, shares of the chain's length, from the asset's own records
/// (QualityRecord).
struct RecordedTipError {
  TipErrorSource source = TipErrorSource::kNotMeasured;
  float rms = 0;  ///< In the worst motion. 0 without a number.
  float max = 0;  ///< Largest of all.
};
[[nodiscard]] inline bool is_known(const RecordedTipError& error) { return error.source <= TipErrorSource::kCoarser; }

/// From the rows that are not finer in rate or sub-step: the fastest one with the shortest sub-steps.
[[nodiscard]] RecordedTipError tip_error_of(const Asset& asset, const SimulatedSo& so);

/// Nanoseconds per sub-step and simulated bone in this browser, in a crowd of heads that shake: the price in a game,
/// where all lanes are full. Takes some milliseconds; 0 where nothing is simulated.
[[nodiscard]] double crowd_cost(const Asset& asset, const Solver& solver);

}  // namespace coif::view
