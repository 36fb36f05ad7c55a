#include "lab/reference_solver.h"

#include "base/parallel_for.h"
#include "lab/reference_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coif::lab {
namespace {

using Eigen::Vector3d;

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();

/// Hair that whips round turns further in a usual step than the integrator can follow: its steps are cut.
constexpr double kLargestStepTurn = 0.25;  // Radians, in a step of the coarsest run.
constexpr double kMostParts = 16;
/// Factor on the steps for bones that are too stiff for a rate: an eighth too many on average.
constexpr double kFiner = 1.25;

/// A time at which a step has to end.
struct Stop {
  double seconds = 0;
  bool is_sample = false;
  bool jumps = false;  ///< Before the sample is taken, as a game sees a teleport in the frame in which it happens.
};

/// Samples and the path's breaks, merged.
std::vector<Stop> stops_of(const motion::HeadPath& path, std::span<const double> samples) {
  std::vector<Stop> stops;
  for (const double seconds : samples) stops.push_back({seconds, true, false});
  const double until = samples.empty() ? 0.0 : samples.back();
  for (const motion::PathBreak& end : path.breaks(until)) {
    const double same = end.jumps ? 0.0 : 1.0e-9;  // Seconds: a step of rounding errors does not count.
    const auto at = std::ranges::lower_bound(stops, end.seconds - same, {}, &Stop::seconds);
    if (at != stops.end() && at->seconds <= end.seconds + same) {
      at->jumps = end.jumps;
    } else {
      stops.insert(at, {end.seconds, false, end.jumps});
    }
  }
  return stops;
}

/// The tips of one tree.
struct TreeTips {
  std::vector<std::size_t> entries;  ///< Indices into Rig::tips.
  std::vector<std::size_t> members;  ///< Indices of the tree's bones.
  std::vector<double> lengths;       ///< Lengths of their chains, metres.
};

/// One path after the other, each with all samples.
using TipPaths = std::vector<Vector3d>;

/// Follows one tree through all stops.
class TreeRun {
 public:
  TreeRun(ReferenceTree& tree, const motion::HeadPath& path, std::span<const Stop> stops, const std::stop_token& stop)
      : tree_(tree), path_(path), stops_(stops), stop_(stop), ends_(tree.members().size()) {}

  /// `fineness`: how many times shorter the steps are than those of the first run, cut ones included; otherwise two
  /// runs could agree because they took the same steps. Ends where steps() would exceed `most_steps`; then is_over() is
  /// true.
  TipPaths run(const TreeTips& tips, std::size_t samples, double coarse_rate, double fineness,
               std::uint64_t most_steps) {
    fineness_ = fineness;
    most_steps_ = most_steps;
    TipPaths paths(tips.members.size() * samples);
    tree_.reset(path_.at(0));
    double now = 0;
    std::size_t sample = 0;
    for (const Stop& stop : stops_) {
      platform::throw_if_stopped(stop_);
      go(now, stop, coarse_rate);
      if (is_over()) return {};
      now = stop.seconds;
      if (!stop.is_sample) continue;
      tree_.bone_ends(path_.at(now).rotation, ends_);
      for (std::size_t i = 0; i < tips.members.size(); ++i) paths[i * samples + sample] = ends_[tips.members[i]];
      ++sample;
    }
    return paths;
  }

  [[nodiscard]] std::uint64_t steps() const { return steps_; }  ///< In all runs.
  [[nodiscard]] bool is_over() const { return steps_ > most_steps_; }

 private:
  void go(double from, const Stop& stop, double coarse_rate) {
    const double span = stop.seconds - from, inside = from + span / 2;
    const double coarse_count = span > 0 ? std::max(1.0, std::ceil(span * coarse_rate - 1.0e-6)) : 0.0;
    const double wanted = coarse_count * fineness_;
    if (double(steps_) + wanted > double(most_steps_)) {
      steps_ = most_steps_ + 1;
      return;
    }
    const long count = std::lround(wanted);
    for (long i = 0; i < count && !is_over(); ++i) {
      const double begin = from + span * double(i) / double(count), end = from + span * double(i + 1) / double(count);
      const double turn = tree_.fastest_turning() * (end - begin) * fineness_;
      const long parts =
          turn > kLargestStepTurn ? std::lround(std::ceil(std::min(turn / kLargestStepTurn, kMostParts))) : 1L;
      steps_ += std::uint64_t(parts);
      for (long part = 0; part < parts; ++part) {
        const double dt = (end - begin) / double(parts);
        const double start = begin + double(part) * dt;
        tree_.step({dt, path_.at(start, inside), path_.at(start + dt / 2, inside), path_.at(start + dt, inside)});
      }
    }
    if (stop.jumps) {
      const auto before = path_.at(stop.seconds, inside).rotation;
      tree_.jump(path_.at(stop.seconds).rotation * before.conjugate());
    }
  }

  ReferenceTree& tree_;
  const motion::HeadPath& path_;
  double fineness_ = 1;
  std::uint64_t steps_ = 0, most_steps_ = 0;
  std::span<const Stop> stops_;
  const std::stop_token& stop_;
  std::vector<Vector3d> ends_;
};

TipAgreement agreement_of(std::span<const Vector3d> fine, std::span<const Vector3d> coarse, double length) {
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double apart = (fine[i] - coarse[i]).squaredNorm();
    sum += apart;
    if (!(apart <= most)) most = apart;  // a NaN wins
  }
  const double percent = 100 / length;
  return {percent * std::sqrt(sum / double(fine.size())), percent * std::sqrt(most)};
}

double root_mean_square(std::span<const TipAgreement> tips) {
  double sum = 0;
  for (const TipAgreement& tip : tips) sum += tip.rms_pct * tip.rms_pct;
  return tips.empty() ? 0.0 : std::sqrt(sum / double(tips.size()));
}

double first_rate(const ReferenceTree& tree, const ReferenceSettings& settings) {
  double rate = settings.steps_per_second;
  while (rate < tree.least_steps_per_second()) rate *= kFiner;
  return rate;
}

double seconds_of(const ReferenceSettings& settings) {
  return settings.sample_times.empty() ? 0 : settings.sample_times.back();
}

std::uint64_t most_steps_of(const ReferenceSettings& settings, double first_rate) {
  constexpr double kNoBound = 1e18;
  const double most = settings.most_work > 0 ? settings.most_work * first_rate * seconds_of(settings) : kNoBound;
  return std::uint64_t(std::min(most, kNoBound));
}

/// Writes the tree's part of `result`. Empty `fine`: it has no solution.
void write_tree(const TreeTips& tips, std::span<const TipAgreement> agreement, const TipPaths& fine,
                ReferenceRun& result) {
  const std::size_t samples = result.times.size();
  for (std::size_t i = 0; i < agreement.size(); ++i) {
    result.agreement[tips.entries[i]] = agreement[i];
    const auto to = result.places.begin() + std::ptrdiff_t(tips.entries[i] * samples);
    if (fine.empty()) {
      std::fill_n(to, samples, Vector3d::Constant(kNever));
    } else {
      std::copy_n(fine.begin() + std::ptrdiff_t(i * samples), samples, to);
    }
  }
}

/// Solves one tree with shorter and shorter steps until two runs agree, and writes its part of `result`. Returns how
/// many steps that took.
std::uint64_t solve_tree(ReferenceTree tree, const TreeTips& tips, const motion::HeadPath& path,
                         std::span<const Stop> stops, const ReferenceSettings& settings, ReferenceRun& result) {
  const std::size_t samples = result.times.size();
  TreeRun runner(tree, path, stops, settings.threads.stop);
  const double coarse_rate = first_rate(tree, settings);
  double fineness = 1;
  const std::uint64_t most_steps = most_steps_of(settings, coarse_rate);
  TipPaths coarse, fine = runner.run(tips, samples, coarse_rate, fineness, most_steps);
  std::vector<TipAgreement> agreement(tips.entries.size(), {kNever, kNever, kNever, true, false});
  while (!runner.is_over()) {
    fineness *= 2;
    TipPaths finer = runner.run(tips, samples, coarse_rate, fineness, most_steps);
    if (runner.is_over()) {
      for (TipAgreement& tip : agreement) tip.was_cut = true;
      break;
    }
    coarse = std::exchange(fine, std::move(finer));
    for (std::size_t i = 0; i < agreement.size(); ++i) {
      const auto part = [&](const TipPaths& paths) { return std::span(paths).subspan(i * samples, samples); };
      agreement[i] = agreement_of(part(fine), part(coarse), tips.lengths[i]);
      agreement[i].steps_per_second = coarse_rate * fineness;
    }
    if (root_mean_square(agreement) <= settings.wanted_self_difference_pct) break;
    if (2 * coarse_rate * fineness > settings.most_steps_per_second) break;
  }
  const bool is_solved = std::ranges::all_of(agreement, &TipAgreement::is_solved);
  write_tree(tips, agreement, is_solved ? fine : TipPaths(), result);
  return runner.steps();
}

TreeTips tips_of(const Rig& rig, std::span<const std::uint32_t> members) {
  TreeTips tips;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const auto at = std::ranges::lower_bound(rig.tips, members[m]);
    if (at == rig.tips.end() || *at != members[m]) continue;
    const auto tip = std::size_t(at - rig.tips.begin());
    tips.entries.push_back(tip);
    tips.members.push_back(m);
    tips.lengths.push_back(rig.tip_length[tip]);
  }
  return tips;
}

}  // namespace

double ReferenceRun::self_difference_pct() const { return root_mean_square(agreement); }

double ReferenceRun::worst_difference_pct() const {
  double worst = 0;
  for (const TipAgreement& tip : agreement) {
    if (!(tip.max_pct <= worst)) worst = tip.max_pct;
  }
  return worst;
}

bool ReferenceRun::is_solved() const { return std::ranges::all_of(agreement, &TipAgreement::is_solved); }

bool ReferenceRun::was_cut() const { return std::ranges::any_of(agreement, &TipAgreement::was_cut); }

double ReferenceRun::steps_per_second() const {
  double least = agreement.empty() ? kNever : agreement.front().steps_per_second;
  for (const TipAgreement& tip : agreement) least = std::min(least, tip.steps_per_second);
  return least;
}

double first_run_work(const Rig& rig, const SolverScene& scene, const ReferenceSettings& settings) {
  double work = 0;
  for (const auto& members : trees_of(rig)) {
    const double rate = first_rate(ReferenceTree(rig, members, scene), settings);
    work += rate * seconds_of(settings) * double(members.size());
  }
  return work;
}

ReferenceRun solve_reference(const Rig& rig, const SolverScene& scene, const motion::HeadPath& path,
                             const ReferenceSettings& settings) {
  const std::vector<std::vector<std::uint32_t>> trees = trees_of(rig);
  const std::vector<Stop> stops = stops_of(path, settings.sample_times);
  ReferenceRun result;
  result.times = settings.sample_times;
  std::vector<TreeTips> tips;
  for (const auto& members : trees) tips.push_back(tips_of(rig, members));
  result.agreement.resize(rig.tips.size());
  result.places.resize(rig.tips.size() * result.times.size());

  std::vector<std::uint64_t> steps(trees.size(), 0);
  parallel_for(trees.size(), settings.threads, [&](std::size_t i) {
    steps[i] = solve_tree(ReferenceTree(rig, trees[i], scene), tips[i], path, stops, settings, result);
  });
  for (std::size_t i = 0; i < trees.size(); ++i) result.bone_steps += steps[i] * trees[i].size();
  return result;
}

}  // namespace coif::lab
