#include "lab/measure_runtime.h"

#include "lab/hair_segment.h"
#include "lab/runtime_solver.h"
#include "platform/stop.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::lab {
namespace {

constexpr double kSameTime = 1e-9;  ///< Seconds: the same moment as two fractions differs by rounding.

/// Adds the distances of all tips from their right places at sample `sample`; returns the sum of their squares.
double add_distances(const Rig& rig, const ReferenceRun& reference, std::size_t sample,
                     std::span<const Eigen::Vector3d> ends, RuntimeError& error) {
  double sum = 0;
  for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
    const double off = (ends[rig.tips[tip]] - reference.path_of_tip(tip)[sample]).norm() / rig.tip_length[tip];
    sum += off * off;
    error.max = off <= error.max ? error.max : off;  // a NaN stays
  }
  return sum;
}

/// Largest mean of `width` neighbours, or of all if there are fewer.
double largest_mean(std::span<const double> values, std::size_t width) {
  width = std::min(width, values.size());
  double largest = 0;
  for (std::size_t first = 0; width > 0 && first + width <= values.size(); ++first) {
    const auto window = values.subspan(first, width);
    largest = std::max(largest, std::accumulate(window.begin(), window.end(), 0.0) / double(width));
  }
  return largest;
}

}  // namespace

std::vector<double> frame_times(std::span<const std::uint32_t> rates, double seconds) {
  std::vector<double> times;
  for (const std::uint32_t rate : rates) {
    for (std::uint32_t k = 1; k <= seconds * rate; ++k) times.push_back(double(k) / rate);
  }
  std::ranges::sort(times);
  const auto same = [](double a, double b) { return b - a < kSameTime; };
  times.erase(std::unique(times.begin(), times.end(), same), times.end());
  return times;
}

double worst_second(std::span<const double> mean_squares, double frames_per_second) {
  const auto frames = std::max<std::size_t>(std::size_t(std::lround(frames_per_second)), 1);
  return std::sqrt(largest_mean(mean_squares, frames));
}

RuntimeError measure_runtime(const Asset& asset, const Rig& rig, const KnownMotion& motion, std::uint32_t rate,
                             std::uint32_t substeps, const std::stop_token& stop) {
  const ReferenceRun& reference = motion.reference;
  const auto path = motion::path_of(motion.motion);
  RuntimeSolver solver(asset, {}, kCoifSolver, int(substeps));
  solver.reset(path->pose(0));
  ConstraintMeter meter(rig);
  RuntimeError error;
  std::vector<double> squares;  // Per frame, mean over the tips.
  std::size_t sample = 0;
  for (std::uint32_t frame = 1;; ++frame) {
    platform::throw_if_stopped(stop);
    const double time = double(frame) / rate;
    while (sample < reference.times.size() && reference.times[sample] < time - kSameTime) ++sample;
    if (sample == reference.times.size()) break;
    if (!solver.step(path->pose(time), 1.0 / rate)) return {NAN, NAN, NAN, NAN, NAN};
    meter.look(solver.bone_ends());
    if (reference.times[sample] > time + kSameTime) continue;
    const double sum = add_distances(rig, reference, sample, solver.bone_ends(), error);
    squares.push_back(sum / double(std::max<std::size_t>(rig.tips.size(), 1)));
  }
  error.rms = std::sqrt(largest_mean(squares, squares.size()));
  error.worst_second = worst_second(squares, rate);
  error.stretch = meter.worst().stretch;
  error.penetration = meter.sees_colliders() ? std::max(meter.worst().point_depth, meter.worst().segment_depth) : 0;
  return error;
}

}  // namespace coif::lab
