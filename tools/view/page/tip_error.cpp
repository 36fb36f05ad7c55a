#include "view/page/motion_figures.h"

#include <utility>

namespace coif::view {
namespace {

constexpr double kRounding = 1.0001;  // Factor on rates.

/// Frames and sub-steps a second.
std::pair<double, double> rates_of(const QualityRecord& row) {
  return {double(row.frame_rate), double(row.frame_rate) * row.substeps};
}

bool is_near(double a, double b) { return a <= b * kRounding && b <= a * kRounding; }

}  // namespace

RecordedTipError tip_error_of(const Asset& asset, const SimulatedSo& so) {
  const ProvenanceRecord* const origin = asset.provenance();
  if (asset.quality().empty()) {
    const bool is_draft = origin != nullptr && (origin->flags & kProvenanceDraft) != 0;
    return {is_draft ? TipErrorSource::kDraft : TipErrorSource::kNotMeasured};
  }
  if (so.solver != &kCoifSolver) return {TipErrorSource::kOtherSolver};
  if (so.is_tuned) return {TipErrorSource::kOtherDynamics};
  const double rate = double(so.rate), parts = rate * so.substeps;
  const QualityRecord* best = nullptr;
  for (const QualityRecord& row : asset.quality()) {
    const auto [row_rate, row_parts] = rates_of(row);
    if (row_rate > rate * kRounding || row_parts > parts * kRounding) continue;
    if (best == nullptr || rates_of(row) > rates_of(*best)) best = &row;
  }
  if (best == nullptr) return {TipErrorSource::kTooCoarse};
  const bool is_same = is_near(double(best->frame_rate), rate) && best->substeps == so.substeps;
  return {is_same ? TipErrorSource::kMeasured : TipErrorSource::kCoarser, best->rms_error, best->max_error};
}

}  // namespace coif::view
