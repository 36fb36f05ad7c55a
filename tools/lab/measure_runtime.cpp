#include "lab/measure_runtime.h"

#include "base/work_limit.h"
#include "lab/hair_segment.h"
#include "lab/runtime_solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif {
namespace {

/// Adds the distances of all tips to where they should be at sample `sample`.
void add_distances(const Rig& rig, const ReferenceRun& reference, std::size_t sample,
                   std::span<const Eigen::Vector3d> ends, RuntimeError& sums) {
  for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
    const double off = (ends[rig.tips[tip]] - reference.path_of_tip(tip)[sample]).norm() / rig.tip_length[tip];
    sums.rms += off * off;
    sums.max = off <= sums.max ? sums.max : off;  // a NaN stays
  }
}

}  // namespace

std::vector<double> common_times(std::span<const std::uint32_t> rates, double seconds) {
  std::uint32_t common = 0;
  for (const std::uint32_t rate : rates) common = std::gcd(common, rate);
  std::vector<double> times;
  for (std::uint32_t k = 1; common != 0 && k <= seconds * common; ++k) times.push_back(double(k) / common);
  return times;
}

RuntimeError measure_runtime(const Asset& asset, const Rig& rig, const KnownMotion& motion, std::uint32_t rate,
                             std::uint32_t substeps) {
  const ReferenceRun& reference = motion.reference;
  const auto path = path_of(motion.motion);
  RuntimeSolver solver(asset, {}, kCoifSolver, int(substeps));
  solver.reset(path->pose(0));
  ConstraintMeter meter(rig);
  RuntimeError error;
  std::size_t sample = 0;
  for (std::uint32_t frame = 1; sample < reference.times.size(); ++frame) {
    WorkLimit::check();
    const double time = double(frame) / rate;
    if (!solver.step(path->pose(time), 1.0 / rate)) return {NAN, NAN, NAN, NAN};
    meter.look(solver.bone_ends());
    if (time < reference.times[sample] - 0.5 / rate) continue;
    add_distances(rig, reference, sample++, solver.bone_ends(), error);
  }
  error.rms = std::sqrt(error.rms / double(std::max<std::size_t>(sample * rig.tips.size(), 1)));
  error.stretch = meter.worst().stretch;
  error.penetration = meter.sees_colliders() ? std::max(meter.worst().point_depth, meter.worst().segment_depth) : 0;
  return error;
}

}  // namespace coif
