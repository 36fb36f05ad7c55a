#pragma once

// The accuracy of hair on a character while a hand moves through it.

#include "report/page/report_columns.h"

#include <coif/asset.h>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::report {

/// `coif` on a character (kCharacterSolver) at one frame rate, while a hand strokes the hair of a head that stands
/// still. Errors are relative to the same solver with the same hand at far shorter steps: the loss by frames, not by
/// the model.
struct StrokeRow {
  double fps = 0;
  std::uint32_t substeps = 1;        ///< Per frame.
  double rms_error_pct = kNoNumber;  ///< Distance of tips, head space, in % of the chain's length.
  double max_error_pct = kNoNumber;
  /// RMS distance of that run from one with steps of twice the length.
  double self_difference_pct = kNoNumber;
  double of_motion_pct = kNoNumber;        ///< The RMS error in % of how far the tips are from their rest, RMS too.
  double stretch_max_pct = kNoNumber;      ///< Worst |length / rest - 1|.
  double penetration_max_pct = kNoNumber;  ///< Deepest that any part of a bone was in the hand, in % of its radius.
};

[[nodiscard]] inline Columns<StrokeRow> stroke_columns() {
  using Row = StrokeRow;
  return {{"fps", &Row::fps, {"fps", "{}"}, {"fps", 6}},
          {"substeps", &Row::substeps, {"steps"}, {"steps", 7}},
          {"rms_error_pct", &Row::rms_error_pct, {"RMS error %"}, {"rms %", 10}},
          {"max_error_pct", &Row::max_error_pct, {"max error %"}, {"max %", 10}},
          {"self_difference_pct", &Row::self_difference_pct, {"its own reference to itself %"}, {"reference %", 13}},
          {"of_motion_pct", &Row::of_motion_pct, {"of the motion %"}, {"of motion %", 13}},
          {"stretch_max_pct", &Row::stretch_max_pct, {"stretch %"}, {"stretch %", 11}},
          {"penetration_max_pct", &Row::penetration_max_pct, {"in the hand %"}, {"in the hand %", 15}}};
}

struct StrokeSettings {
  std::vector<double> fps;
  std::vector<std::uint32_t> substeps;
  double seconds = 4;
  double reference_steps_per_second = 3840;
};

/// A row for each frame rate and number of sub-steps, for chains with at most 128 of the asset's bones together.
/// `asset` must have simulated bones.
[[nodiscard]] std::vector<StrokeRow> measure_stroke(const Asset& asset, const StrokeSettings& settings);

}  // namespace coif::report
