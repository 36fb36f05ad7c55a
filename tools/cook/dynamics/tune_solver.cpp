#include "cook/dynamics/chain_trial.h"
#include "cook/dynamics/settle_dynamics.h"
#include "cook/dynamics/tuning_bench.h"
#include "cook/recipe/rig_recipe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

namespace coif::cook {
namespace {

constexpr double kUsualError = 0.007;  ///< The target where the recipe has none; a larger error is not refused then.
/// In slower frames the head's motion is unknown, so the error may grow with their square, up to this.
constexpr double kUsualRate = 60, kMostUsualError = 0.02;
/// At most four steps per frame of the usual rate are spent on that target.
constexpr double kDearSteps = 4 * kUsualRate;
/// Factor on an error that is too large: a costlier setting must reduce it at least to this share.
constexpr double kWorthwhile = 0.9;
constexpr std::uint32_t kParts[] = {1, 2, 3, 4, 6, 8, 12, 16};

std::vector<std::uint32_t> frame_rates(const RigRecipe& recipe) {
  const auto slowest = std::uint32_t(std::lround(std::min(recipe.slowest_rate, recipe.fastest_rate)));
  const auto fastest = std::uint32_t(std::lround(std::max(recipe.slowest_rate, recipe.fastest_rate)));
  std::vector<std::uint32_t> rates{slowest};
  if (slowest < 60 && fastest > 60) rates.push_back(60);
  if (fastest > slowest) rates.push_back(fastest);
  return rates;
}

/// The recipe's budget, as shares and nanoseconds; 0: none.
struct Budget {
  bool is_usual = false;  ///< The recipe has no budget.
  double error = 0;
  double max_error = 0;
  double worst_second = 0;
  double cost = 0;

  /// The RMS error that may be had at this rate of frames.
  [[nodiscard]] double error_at(std::uint32_t rate, std::uint32_t substep_rate) const {
    if (is_usual && substep_rate >= kDearSteps) return kMostUsualError;
    const double longer = std::max(1.0, kUsualRate / rate);
    return is_usual ? std::min(error * longer * longer, kMostUsualError) : error;
  }
  /// The worst error divided by its allowed value.
  [[nodiscard]] double excess(const MeasuredRate& measured, std::uint32_t rate, std::uint32_t substep_rate) const {
    const auto share = [](double reached, double asked) { return asked > 0 ? reached / asked : 0.0; };
    return std::max({share(double(measured.quality.rms_error), error_at(rate, substep_rate)),
                     share(double(measured.quality.max_error), max_error), share(measured.worst_second, worst_second)});
  }
};

Budget budget_of(const RigRecipe& recipe, double longest) {
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

/// All frame rates with sub-steps of the same rate: the highest cost and the worst error.
struct TriedRate {
  TuningRecord tuning{};
  double max_error = 0;
  double worst_second = 0;
  double excess = 0;  ///< Budget::excess() of the worst rate.
  /// Mean over all rates, where a smaller excess counts as 1: finer steps may help some rates where another is as good
  /// as possible.
  double mean_excess = 0;
  std::uint32_t worst_motion = 0;
};

TriedRate try_rate(TuningBench& bench, std::span<const std::uint32_t> rates, std::uint32_t substep_rate,
                   const Budget& budget) {
  TriedRate trial;
  trial.tuning.substep_rate = float(substep_rate);
  trial.tuning.slowest_rate = float(rates.front());
  trial.tuning.fastest_rate = float(rates.back());
  trial.tuning.asked_error =
      float(budget.is_usual && budget.cost > 0 ? 0 : budget.error_at(rates.front(), substep_rate));
  trial.tuning.asked_cost = float(budget.cost);
  for (const std::uint32_t rate : rates) {
    const MeasuredRate& row = bench.at(rate, (substep_rate + rate - 1) / rate);
    trial.tuning.reached_error = std::max(trial.tuning.reached_error, row.quality.rms_error);
    trial.tuning.cost = std::max(trial.tuning.cost, row.quality.cost);
    trial.max_error = std::max(trial.max_error, double(row.quality.max_error));
    trial.worst_second = std::max(trial.worst_second, row.worst_second);
    const double excess = budget.excess(row, rate, substep_rate);
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
      100 * trial.max_error, motion::name_of(kCookSuite[trial.worst_motion]),
      tuning.met == 1 ? "" : ", the least to be had", tuning.cost / 1000);
}

std::vector<MotionNameRecord> suite_names() {
  std::vector<MotionNameRecord> names;
  for (const motion::Motion motion : kCookSuite) {
    const std::string_view name = motion::name_of(motion);
    MotionNameRecord& record = names.emplace_back();
    std::copy_n(name.begin(), std::min(name.size(), sizeof record.name - 1), record.name);
  }
  return names;
}

}  // namespace

tl::expected<TunedSolver, ToolError> tune_solver(const AssetContents& contents, const RigRecipe& recipe,
                                                 const platform::Threads& threads, Findings& findings) {
  if (contents.chains.empty()) return TunedSolver{};
  const std::vector<std::uint32_t> rates = frame_rates(recipe);
  TuningBench bench(contents, rates, threads);
  for (const std::string& note : bench.left_out()) findings.note(note);
  if (bench.is_empty()) {
    findings.warn(
        "C131",
        "not tuned: no motion of this hair could be computed within the work that a cook may take; it is simulated "
        "with one step "
        "a frame; make it softer (dynamics.preset), or its bones fewer (chains.max_bones)");
    return TunedSolver{};
  }
  const Budget budget = budget_of(recipe, bench.longest());

  TriedRate best, least;
  for (const std::uint32_t parts : kParts) {
    if (parts != kParts[0] && !bench.has_work_left(rates, parts * rates.front())) {
      findings.note(
          fmt::format("tuning: sub-steps of {} Hz and more were not tried: they need more work than a cook may take",
                      parts * rates.front()));
      break;
    }
    const TriedRate tried = try_rate(bench, rates, parts * rates.front(), budget);
    const bool affordable = budget.cost <= 0 || double(tried.tuning.cost) <= budget.cost;
    const bool is_first = parts == kParts[0];
    if (!affordable && !is_first) break;
    if (is_first || tried.excess < least.excess) least = tried;
    // Where nothing is good enough, more sub-steps must gain something.
    if (is_first || tried.excess <= 1 || tried.mean_excess < kWorthwhile * best.mean_excess) best = tried;
    best.tuning.met = affordable && ((budget.is_usual && budget.cost > 0) || best.excess <= 1);
    if (best.excess <= 1 || !affordable) break;
  }
  if (best.tuning.met == 0 && (!budget.is_usual || budget.cost > 0)) return tl::unexpected(over_budget(budget, least));
  findings.note(describe(best));
  return TunedSolver{{best.tuning}, bench.table(), suite_names()};
}

}  // namespace coif::cook
