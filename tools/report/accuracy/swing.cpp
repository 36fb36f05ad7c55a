#include "report/accuracy/swing.h"

#include "lab/rig.h"
#include "report/accuracy/measure_accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace coif::report {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostSwingBones = 128;
constexpr double kSeconds = 8, kRate = 60;
constexpr double kFirstSwing = 0.5;   ///< Seconds in which a tip is where it is thrown to.
constexpr double kSettled = 0.05;     ///< Share of the first swing.
constexpr int kArtistIterations = 8;  ///< Iterations of Algorithm 1; more change nothing visible.
constexpr double kInPercent = 100;

/// Tips of all frames from rest on; none where the solver failed.
std::vector<Vector3d> run(const Asset& asset, const lab::RigSample& sample, const FramePoses& frames,
                          const char* solver, int effort) {
  const SolverAtWork at_work = make_solver(*find_measured_solver(solver), asset, sample, {}, effort);
  MotionTrial trial = try_motion(*at_work.solver, sample.rig, frames);
  return trial.is_finite ? std::move(trial.tips) : std::vector<Vector3d>();
}

std::vector<Vector3d> of_tip(const std::vector<Vector3d>& all, std::size_t tip, std::size_t tips, std::size_t first) {
  std::vector<Vector3d> one;
  for (std::size_t frame = first; frame * tips < all.size(); ++frame) one.push_back(all[frame * tips + tip]);
  return one;
}

double rms_apart(std::span<const Vector3d> a, std::span<const Vector3d> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / double(std::max<std::size_t>(a.size(), 1)));
}

/// The motion `charge` goes along +Z.
std::vector<double> behind(std::span<const Vector3d> tips) {
  std::vector<double> metres;
  for (const Vector3d& tip : tips) metres.push_back(tips.front().z() - tip.z());
  return metres;
}

/// The place of rest: the mean of the last second.
Vector3d rest_of(const std::vector<Vector3d>& tips) {
  Vector3d sum = Vector3d::Zero();
  const std::size_t count = std::min(tips.size(), std::size_t(kRate));
  for (std::size_t i = tips.size() - count; i < tips.size(); ++i) sum += tips[i];
  return sum / double(std::max<std::size_t>(count, 1));
}

std::string name_of_chain(const Asset& asset, std::uint32_t chain) {
  const std::string name(asset.bone_name(asset.chains()[chain].first_bone));
  return name.empty() ? fmt::format("{}", chain) : name;
}

}  // namespace

Swing swing_of(std::span<const Vector3d> tips, const Vector3d& rest, double dt) {
  Swing swing;
  for (const Vector3d& tip : tips) swing.thrown = std::max(swing.thrown, (tip - rest).norm());
  if (!(swing.thrown > 0)) return swing;
  // Horizontal: a tip that is thrown up on one side comes up on the other.
  const auto sideways = [&](std::size_t i) { return Vector3d(tips[i].x() - rest.x(), 0, tips[i].z() - rest.z()); };
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < tips.size() && double(i) * dt < kFirstSwing; ++i) {
    if (sideways(i).norm() > sideways(farthest).norm()) farthest = i;
  }
  const Vector3d way = sideways(farthest);
  double back = 0;
  for (std::size_t i = farthest; i < tips.size(); ++i) back = std::max(back, -sideways(i).dot(way));
  swing.overshoot = way.squaredNorm() > 0 ? back / way.squaredNorm() : 0;
  std::size_t settled = tips.size();
  while (settled > 0 && (tips[settled - 1] - rest).norm() <= kSettled * swing.thrown) --settled;
  swing.settling_s = settled < tips.size() ? double(settled) * dt : kNoNumber;
  return swing;
}

Swings measure_swings(const Asset& asset) {
  const auto path = motion::path_of(motion::Motion::kCharge);
  const lab::RigSample sample = lab::sample_of(lab::rig_of(asset), kMostSwingBones);
  const FramePoses frames(*path, kRate, kSeconds);
  const std::vector<Vector3d> ours = run(asset, sample, frames, "coif", 0);
  const std::vector<Vector3d> artists = run(asset, sample, frames, "thesis", kArtistIterations);
  // Tips begin after the first frame.
  const auto steady = std::size_t(std::lround(path->breaks(kSeconds).front().seconds * kRate)) - 1;
  const std::size_t tips = sample.rig.tips.size();
  std::vector<std::size_t> order(tips);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t tip) { return sample.rig.tip_length[tip]; });
  Swings swings;
  for (const std::size_t tip : order) {
    const double length = sample.rig.tip_length[tip];
    SwingRow row{.chain = name_of_chain(asset, sample.rig.tip_chain[tip]), .length_mm = 1000 * length};
    if (!ours.empty()) {
      const std::vector<Vector3d> tip_ours = of_tip(ours, tip, tips, steady);
      const Swing swing = swing_of(tip_ours, rest_of(tip_ours), 1 / kRate);
      row.thrown_pct = kInPercent * swing.thrown / length;
      row.overshoot_pct = kInPercent * swing.overshoot;
      row.settling_s = swing.settling_s;
    }
    if (!artists.empty()) {
      const std::vector<Vector3d> tip_artists = of_tip(artists, tip, tips, steady);
      const Swing swing = swing_of(tip_artists, rest_of(tip_artists), 1 / kRate);
      row.artist_overshoot_pct = kInPercent * swing.overshoot;
      row.artist_settling_s = swing.settling_s;
      row.apart_pct = kInPercent * rms_apart(of_tip(ours, tip, tips, 0), of_tip(artists, tip, tips, 0)) / length;
    }
    swings.rows.push_back(row);
  }
  if (tips > 0) {
    swings.longest = {swings.rows.front().chain, 1 / kRate, behind(of_tip(ours, order.front(), tips, 0)),
                      behind(of_tip(artists, order.front(), tips, 0))};
  }
  return swings;
}

}  // namespace coif::report
