#include "cook/dynamics/chain_trial.h"

#include "base/parallel_for.h"
#include "cook/dynamics/chain_groups.h"
#include "lab/measure_runtime.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif::cook {
namespace {

constexpr double kTrialSeconds = 2;
constexpr double kMostSelfDifferencePct = 0.1;
/// Share of the chain's length. A chain that hurries about its head is off by a few percent for the contacts' sake; one
/// that amplifies is off by ten and more.
constexpr double kMostRuntimeError = 0.05;
/// A chain that amplifies more turns a rounding error into a visible one; it need not be computed.
constexpr double kMostGrowth = 1.0e4;

lab::ReferenceSettings trial_settings(const std::stop_token& stop, double most_steps_per_second = 11520) {
  lab::ReferenceSettings settings;
  settings.threads = {1, stop};
  settings.sample_times = trial_times();
  settings.steps_per_second = kCoarsestSteps;
  settings.most_steps_per_second = most_steps_per_second;
  settings.wanted_self_difference_pct = kMostSelfDifferencePct;
  return settings;
}

ChainFinding examine_motion(const lab::OpenedAsset& opened, const lab::Rig& rig, const lab::KnownMotion& known,
                            const std::stop_token& stop) {
  ChainFinding finding{true, known.motion, known.reference.self_difference_pct(), 0};
  finding.is_good = finding.self_difference_pct <= kMostSelfDifferencePct;  // false for NaN
  if (!finding.is_good) return finding;
  finding.runtime_error = lab::measure_runtime(opened.asset(), rig, known, kTrialRate, kTrialSubsteps, stop).rms;
  finding.is_good = finding.runtime_error <= kMostRuntimeError;
  return finding;
}

}  // namespace

std::vector<double> trial_times() {
  constexpr std::uint32_t kSampled[] = {kTrialRate};
  return lab::frame_times(kSampled, kTrialSeconds);
}

lab::ReferenceRun solve_trial(const lab::Rig& rig, motion::Motion motion, const std::stop_token& stop) {
  // A chain that is far from agreement with coarse steps would not agree with fine ones either, and is given up.
  constexpr double kCoarse = 2880, kHopelessPct = 3;
  lab::ReferenceRun run = lab::solve_reference(rig, {}, *motion::path_of(motion), trial_settings(stop, kCoarse));
  const double difference = run.self_difference_pct();
  if (difference <= kMostSelfDifferencePct || !(difference <= kHopelessPct)) return run;
  return lab::solve_reference(rig, {}, *motion::path_of(motion), trial_settings(stop));
}

bool grows_beyond_hope(const AssetContents& alone) {
  return alone.chains[0].model == ChainModel::kCascade && chain_growth(alone, 0) > kMostGrowth;
}

ChainTrial try_chain(const AssetContents& alone, const platform::Threads& threads) {
  if (!grows_beyond_hope(alone)) return try_any_chain(alone, threads);
  return {{.is_good = false, .growth = chain_growth(alone, 0)}, {}};
}

ChainTrial try_any_chain(const AssetContents& alone, const platform::Threads& threads) {
  const lab::OpenedAsset opened(alone);
  const lab::Rig rig = lab::rig_of(opened.asset());
  ChainTrial trial;
  // A few motions at a time: after one that fails none is needed.
  for (std::size_t first = 0; first < std::size(kTrialMotions); first += threads.count) {
    std::vector<lab::KnownMotion> known(std::min<std::size_t>(threads.count, std::size(kTrialMotions) - first));
    std::vector<ChainFinding> findings(known.size());
    parallel_for(known.size(), threads, [&](std::size_t i) {
      const motion::Motion motion = kTrialMotions[first + i];
      known[i] = {motion, solve_trial(rig, motion, threads.stop)};
      findings[i] = examine_motion(opened, rig, known[i], threads.stop);
    });
    for (std::size_t i = 0; i < known.size(); ++i) {
      trial.finding = findings[i];
      if (!trial.finding.is_good) return trial;
      trial.runs.push_back(std::move(known[i].reference));
    }
  }
  return trial;
}

double rms_apart(const lab::Rig& rig, std::span<const lab::ReferenceRun> a, std::span<const lab::ReferenceRun> b) {
  constexpr double kFarthest = 2;  // lengths
  double sum = 0, count = 0;
  for (std::size_t m = 0; m < a.size(); ++m) {
    const std::size_t samples = a[m].times.size();
    for (std::size_t i = 0; i < a[m].places.size(); ++i) {
      const double off = (a[m].places[i] - b[m].places[i]).norm() / rig.tip_length[i / samples];
      sum += off < kFarthest ? off * off : kFarthest * kFarthest;
      ++count;
    }
  }
  return std::sqrt(sum / std::max(count, 1.0));
}

std::string what_failed(const ChainFinding& finding) {
  if (finding.growth > 0) {
    return fmt::format("its bones amplify what moves the first of them {:.0g} times", finding.growth);
  }
  if (!(finding.self_difference_pct <= kMostSelfDifferencePct)) {
    return std::isfinite(finding.self_difference_pct)
               ? fmt::format("two computations of motion {} differed by {:.2g} % of its length",
                             motion::name_of(finding.motion), finding.self_difference_pct)
               : fmt::format("two computations of motion {} had nothing in common", motion::name_of(finding.motion));
  }
  return fmt::format("240 steps a second were off by {:.2g} % of its length in motion {}", 100 * finding.runtime_error,
                     motion::name_of(finding.motion));
}

}  // namespace coif::cook
