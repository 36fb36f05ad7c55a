#include "chunk_checks.h"
#include "number_checks.h"

namespace coif {
namespace {

constexpr float kMostRate = 1.0e5f;   ///< Per second.
constexpr float kMostError = 1.0e3f;  ///< Chain lengths: something that is no longer hair.
constexpr float kMostCost = 1.0e12f;  ///< Nanoseconds.
constexpr std::uint32_t kMostSubsteps = 1024;
constexpr std::uint32_t kMotions = 8;

bool fits(const TuningRecord& t) {
  return in_range(t.substep_rate, 0.0f, kMostRate) && in_range(t.asked_error, 0.0f, kMostError) &&
         in_range(t.reached_error, 0.0f, kMostError) && in_range(t.asked_cost, 0.0f, kMostCost) &&
         in_range(t.cost, 0.0f, kMostCost) && in_range(t.slowest_rate, 1.0f, kMostRate) &&
         in_range(t.fastest_rate, t.slowest_rate, kMostRate) && t.met <= 1;
}

bool fits(const QualityRecord& q) {
  return in_range(q.frame_rate, 1.0f, kMostRate) && q.substeps >= 1 && q.substeps <= kMostSubsteps &&
         in_range(q.rms_error, 0.0f, kMostError) && in_range(q.max_error, 0.0f, kMostError) &&
         in_range(q.stretch, 0.0f, kMostError) && in_range(q.penetration, 0.0f, kMostError) &&
         in_range(q.cost, 0.0f, kMostCost) && q.worst_motion < kMotions;
}

}  // namespace

LoadStatus check_tuning(const Asset& asset) {
  if (asset.tuning() != nullptr && !fits(*asset.tuning())) return {LoadCode::kNotFinite, chunk::kTuning};
  for (std::size_t i = 0; i < asset.quality().size(); ++i) {
    if (!fits(asset.quality()[i])) return {LoadCode::kNotFinite, chunk::kQuality, i};
  }
  return {};
}

}  // namespace coif
