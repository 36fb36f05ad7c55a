#pragma once

#include <coif/asset.h>
#include <coif/hair.h>

#include <cstdint>

namespace coif::view {

/// How hair is simulated, of which the asset may know how wrong it is.
struct SimulatedSo {
  float rate = 60;             ///< Steps a second.
  std::uint32_t substeps = 1;  ///< Of a step.
  const Solver* solver = &kCoifSolver;
  bool is_tuned = false;  ///< Bones move by other numbers than the asset's own.
};

/// Where a number comes from, or why there is none.
enum class TipErrorSource : std::uint8_t {
  kMeasured,       ///< In this very way.
  kCoarser,        ///< At a slower rate with sub-steps no shorter: it is no larger than that.
  kDraft,          ///< Drafts are not measured.
  kNotMeasured,    ///< This asset was not.
  kOtherSolver,    ///< What was measured is kCoifSolver.
  kOtherDynamics,  ///< What was measured is how the asset moves by its own numbers.
  kTooCoarse,      ///< Nothing as slow was measured.
};

/// Of tips against the converged solution, shares of the chain's length, by the asset's own records (QualityRecord).
struct RecordedTipError {
  TipErrorSource source = TipErrorSource::kNotMeasured;
  float rms = 0;  ///< Of the worst motion. 0 without a number.
  float max = 0;  ///< Largest of all.
};
[[nodiscard]] inline bool is_known(const RecordedTipError& error) { return error.source <= TipErrorSource::kCoarser; }

/// Of the rows that are no finer in either, rate and sub-step, the fastest with the shortest sub-steps.
[[nodiscard]] RecordedTipError tip_error_of(const Asset& asset, const SimulatedSo& so);

/// Nanoseconds that a sub-step of one simulated bone takes in this browser, in a crowd of heads that shake: what a game
/// would pay, where all lanes are full. Takes some milliseconds; 0 where nothing is simulated.
[[nodiscard]] double crowd_cost(const Asset& asset, const Solver& solver);

}  // namespace coif::view
