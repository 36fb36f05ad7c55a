#include "base/parallel_for.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/chain_trial.h"
#include "cook/dynamics/cook_suite.h"
#include "cook/dynamics/settle_dynamics.h"
#include "lab/measure_runtime.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string_view>
#include <utility>

namespace coif {
namespace {

constexpr double kSeconds = 2;
constexpr double kMostError = 1000;    ///< That an asset may hold.
constexpr double kUsualError = 0.007;  ///< Where the recipe asks for nothing, this is wanted and nothing less refused.
/// In slower frames nobody knows what the head does: there the error grows with their square, and up to this much is let be.
constexpr double kUsualRate = 60, kMostUsualError = 0.02;
constexpr double kWorthwhile = 0.9;    ///< Of an error that is too large: dearer settings leave no more of it.
constexpr std::size_t kFewBones = 24;  ///< Up to here every chain is run.
constexpr std::uint32_t kParts[] = {1, 2, 3, 4, 6, 8, 12, 16};

std::vector<std::uint32_t> frame_rates(const Recipe& recipe) {
  const auto slowest = std::uint32_t(std::lround(std::min(recipe.slowest_rate, recipe.fastest_rate)));
  const auto fastest = std::uint32_t(std::lround(std::max(recipe.slowest_rate, recipe.fastest_rate)));
  std::vector<std::uint32_t> rates{slowest};
  if (slowest < 60 && fastest > 60) rates.push_back(60);
  if (fastest > slowest) rates.push_back(fastest);
  return rates;
}

std::vector<std::uint32_t> chains_to_run(const AssetContents& contents) {
  std::size_t bones = 0;
  for (const ChainRecord& chain : contents.chains) bones += chain.bone_count;
  std::vector<std::uint32_t> chains;
  if (bones <= kFewBones) {
    chains.resize(contents.chains.size());
    std::iota(chains.begin(), chains.end(), 0u);
    return chains;
  }
  for (const ChainGroup& group : group_chains(contents)) {
    chains.insert(chains.end(), group.telling.begin(), group.telling.end());
  }
  return chains;
}

std::size_t twisting_bones(const AssetContents& contents, const ChainRecord& chain) {
  const auto bones = std::span(contents.dynamics).subspan(chain.first_bone, chain.bone_count);
  return std::size_t(
      std::ranges::count_if(bones, [](const DynamicsRecord& bone) { return bone.torsion < kShortestArc; }));
}

/// What the runtime does at one frame rate, over all motions.
struct MeasuredRate {
  QualityRecord quality;
  double worst_second = 0;
};

/// The runtime beside the reference, for any frame rate of the recipe's and number of parts; each is measured once.
class Bench {
 public:
  Bench(const AssetContents& contents, std::span<const std::uint32_t> rates, unsigned threads)
      : opened_(chains_alone(contents, chains_to_run(contents))), rig_(rig_of(opened_.asset())), threads_(threads) {
    for (const ChainRecord& chain : contents.chains) {
      bones_ += chain.bone_count;
      if (chain.model == ChainModel::kPassive) passive_ += chain.bone_count;
      if (chain.model == ChainModel::kCascade) twisting_ += twisting_bones(contents, chain);
    }
    ReferenceSettings settings;
    settings.sample_times = frame_times(rates, kSeconds);
    settings.steps_per_second = kCoarsestSteps;
    settings.most_steps_per_second = 5760;
    settings.wanted_self_difference_pct = 0.1;  // a seventh of the smallest error that is usually asked for
    known_.resize(std::size(kCookSuite));
    parallel_for(known_.size(), threads_, [&](std::size_t m) {
      const Motion motion = kCookSuite[m];
      known_[m] = {motion, solve_reference(rig_, {}, *path_of(motion), settings)};
    });
  }

  const MeasuredRate& at(std::uint32_t rate, std::uint32_t parts) {
    const auto [found, is_new] = measured_.try_emplace({rate, parts});
    if (is_new) found->second = measure(rate, parts);
    return found->second;
  }

  [[nodiscard]] double longest() const { return *std::ranges::max_element(rig_.tip_length); }
  [[nodiscard]] std::vector<QualityRecord> table() const {
    std::vector<QualityRecord> rows;
    for (const auto& [key, measured] : measured_) rows.push_back(measured.quality);
    return rows;
  }

 private:
  MeasuredRate measure(std::uint32_t rate, std::uint32_t parts) const {
    std::vector<RuntimeError> errors(known_.size());
    parallel_for(known_.size(), threads_,
                 [&](std::size_t m) { errors[m] = measure_runtime(opened_.asset(), rig_, known_[m], rate, parts); });
    MeasuredRate measured{};
    QualityRecord& row = measured.quality;
    row.frame_rate = float(rate);
    row.substeps = parts;
    const double model_cost = nominal_passive_cost(passive_, parts) + nominal_twist_cost(twisting_, parts);
    row.cost = float(nominal_cost(bones_, parts) + model_cost);
    // What did not stay finite is as wrong as can be written down, and not right for comparing false.
    const auto worse = [](float a, double b) { return std::max(a, float(b <= kMostError ? b : kMostError)); };
    for (std::size_t m = 0; m < errors.size(); ++m) {
      if (!(errors[m].rms <= double(row.rms_error))) row.worst_motion = std::uint32_t(m);
      row.rms_error = worse(row.rms_error, errors[m].rms);
      row.max_error = worse(row.max_error, errors[m].max);
      row.stretch = worse(row.stretch, errors[m].stretch);
      row.penetration = worse(row.penetration, errors[m].penetration);
      measured.worst_second = double(worse(float(measured.worst_second), errors[m].worst_second));
    }
    return measured;
  }

  OpenedAsset opened_;
  Rig rig_;
  unsigned threads_;
  std::size_t bones_ = 0, passive_ = 0, twisting_ = 0;
  std::vector<KnownMotion> known_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, MeasuredRate> measured_;
};

/// What the recipe asks for, as shares and nanoseconds; 0: nothing.
struct Budget {
  bool is_usual = false;  ///< Nobody asked.
  double error = 0;
  double max_error = 0;
  double worst_second = 0;
  double cost = 0;

  /// The RMS error that may be had at this rate.
  [[nodiscard]] double error_at(std::uint32_t rate) const {
    const double longer = std::max(1.0, kUsualRate / rate);
    return is_usual ? std::min(error * longer * longer, kMostUsualError) : error;
  }
  /// How many times what it may be the worst of the errors is.
  [[nodiscard]] double excess(const MeasuredRate& measured, std::uint32_t rate) const {
    const auto share = [](double reached, double asked) { return asked > 0 ? reached / asked : 0.0; };
    return std::max({share(double(measured.quality.rms_error), error_at(rate)),
                     share(double(measured.quality.max_error), max_error), share(measured.worst_second, worst_second)});
  }
};

Budget budget_of(const Recipe& recipe, double longest) {
  Budget budget{.error = recipe.budget_error / 100,
                .max_error = recipe.budget_max_error / 100,
                .worst_second = recipe.budget_worst_second / 100,
                .cost = recipe.budget_cost};
  if (recipe.budget_error_mm > 0) {
    const double share = recipe.budget_error_mm / 1000 / longest;
    budget.error = budget.error > 0 ? std::min(budget.error, share) : share;
  }
  const bool asks = budget.error > 0 || budget.max_error > 0 || budget.worst_second > 0;
  if (asks) return budget;
  budget.is_usual = true;  // a cost alone may be spent on as much
  budget.error = kUsualError;
  return budget;
}

/// All frame rates with sub-steps of the same rate: the dearest of the parts, the worst of the errors.
struct TriedRate {
  TuningRecord tuning{};
  double max_error = 0;
  double worst_second = 0;
  double excess = 0;  ///< Budget::excess() of the worst rate.
  double mean_excess =
      0;  ///< Of all rates, 1 where it is less: finer steps may help some where one is as good as it gets.
  std::uint32_t worst_motion = 0;
};

TriedRate try_rate(Bench& bench, std::span<const std::uint32_t> rates, std::uint32_t substep_rate,
                   const Budget& budget) {
  TriedRate trial;
  trial.tuning.substep_rate = float(substep_rate);
  trial.tuning.slowest_rate = float(rates.front());
  trial.tuning.fastest_rate = float(rates.back());
  trial.tuning.asked_error = float(budget.is_usual && budget.cost > 0 ? 0 : budget.error_at(rates.front()));
  trial.tuning.asked_cost = float(budget.cost);
  for (const std::uint32_t rate : rates) {
    const MeasuredRate& row = bench.at(rate, (substep_rate + rate - 1) / rate);
    trial.tuning.reached_error = std::max(trial.tuning.reached_error, row.quality.rms_error);
    trial.tuning.cost = std::max(trial.tuning.cost, row.quality.cost);
    trial.max_error = std::max(trial.max_error, double(row.quality.max_error));
    trial.worst_second = std::max(trial.worst_second, row.worst_second);
    const double excess = budget.excess(row, rate);
    if (excess >= trial.excess) trial.worst_motion = row.quality.worst_motion;
    trial.excess = std::max(trial.excess, excess);
    trial.mean_excess += std::max(excess, 1.0) / double(rates.size());
  }
  return trial;
}

ToolError over_budget(const Budget& budget, const TriedRate& best) {
  std::string text;
  const auto tell = [&](const char* what, double asked, double reached) {
    if (asked <= 0) return;
    text += fmt::format("{}{} of {:.3g} % of the chain's length was asked for and {:.3g} % reached",
                        text.empty() ? "" : "; ", what, 100 * asked, 100 * reached);
  };
  if (!budget.is_usual) {
    tell("an error", budget.error, double(best.tuning.reached_error));
    tell("a largest error", budget.max_error, best.max_error);
    tell("a worst second", budget.worst_second, best.worst_second);
  }
  if (budget.cost > 0) {
    text += fmt::format("{}{:.0f} ns per frame {} with {:.0f} ns", text.empty() ? "" : ", where ", budget.cost,
                        text.empty() ? "were allowed; the least is" : "were allowed,", best.tuning.cost);
  } else {
    text += fmt::format(" with {:g} sub-steps a second", best.tuning.substep_rate);
  }
  return {ToolError::Kind::kOverBudget,
          "\"budget\": " + text + "; ask for less, or damp the hair (dynamics.damping_ratio)"};
}

std::string describe(const TriedRate& trial) {
  const TuningRecord& tuning = trial.tuning;
  return fmt::format(
      "tuned: {} at {:g} to {:g} frames per second, error {:.2g} % of the chain's length (RMS; {:.2g} % in the worst "
      "second, "
      "{:.2g} % at most, worst in {}){}, {:.2g} us per head",
      tuning.substep_rate > tuning.slowest_rate ? fmt::format("sub-steps of {:g} Hz", tuning.substep_rate)
                                                : std::string("one step a frame"),
      tuning.slowest_rate, tuning.fastest_rate, 100 * tuning.reached_error, 100 * trial.worst_second,
      100 * trial.max_error, name_of(kCookSuite[trial.worst_motion]), tuning.met == 1 ? "" : ", the least to be had",
      tuning.cost / 1000);
}

std::vector<MotionNameRecord> suite_names() {
  std::vector<MotionNameRecord> names;
  for (const Motion motion : kCookSuite) {
    const std::string_view name = name_of(motion);
    MotionNameRecord& record = names.emplace_back();
    std::copy_n(name.begin(), std::min(name.size(), sizeof record.name - 1), record.name);
  }
  return names;
}

}  // namespace

tl::expected<TunedSolver, ToolError> tune_solver(const AssetContents& contents, const Recipe& recipe, unsigned threads,
                                                 Findings& findings) {
  if (contents.chains.empty()) return TunedSolver{};
  const std::vector<std::uint32_t> rates = frame_rates(recipe);
  Bench bench(contents, rates, threads);
  const Budget budget = budget_of(recipe, bench.longest());

  TriedRate best, least;
  for (const std::uint32_t parts : kParts) {
    const TriedRate tried = try_rate(bench, rates, parts * rates.front(), budget);
    const bool affordable = budget.cost <= 0 || double(tried.tuning.cost) <= budget.cost;
    const bool is_first = parts == kParts[0];
    if (!affordable && !is_first) break;
    if (is_first || tried.excess < least.excess) least = tried;
    // Where nothing is good enough, more sub-steps have to gain something.
    if (is_first || tried.excess <= 1 || tried.mean_excess < kWorthwhile * best.mean_excess) best = tried;
    best.tuning.met = affordable && ((budget.is_usual && budget.cost > 0) || best.excess <= 1);
    if (best.excess <= 1 || !affordable) break;
  }
  if (best.tuning.met == 0 && (!budget.is_usual || budget.cost > 0)) return tl::unexpected(over_budget(budget, least));
  findings.note(describe(best));
  return TunedSolver{{best.tuning}, bench.table(), suite_names()};
}

}  // namespace coif
