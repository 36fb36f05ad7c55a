#include "base/parallel_for.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/settle_dynamics.h"
#include "lab/measure_runtime.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace coif {
namespace {

constexpr double kSeconds = 2;
constexpr double kMostError = 1000;    ///< That an asset may hold.
constexpr double kUsualError = 0.007;  ///< Where the recipe asks for nothing, this is wanted and nothing less refused.
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

/// The runtime beside the reference, for any frame rate of the recipe's and number of parts; each is measured once.
class Bench {
 public:
  Bench(const AssetContents& contents, std::span<const std::uint32_t> rates, unsigned threads)
      : opened_(chains_alone(contents, chains_to_run(contents))), rig_(rig_of(opened_.asset())), threads_(threads) {
    for (const ChainRecord& chain : contents.chains) bones_ += chain.bone_count;
    for (const ChainRecord& chain : contents.chains) twisting_ += twisting_bones(contents, chain);
    ReferenceSettings settings;
    settings.sample_times = common_times(rates, kSeconds);
    settings.most_steps_per_second = 5760;
    settings.wanted_self_difference_pct = 0.1;  // a seventh of the smallest error that is usually asked for
    known_.resize(all_motions().size());
    parallel_for(known_.size(), threads_, [&](std::size_t m) {
      const Motion motion = all_motions()[m].motion;
      known_[m] = {motion, solve_reference(rig_, {}, *path_of(motion), settings)};
    });
  }

  const QualityRecord& at(std::uint32_t rate, std::uint32_t parts) {
    const auto [found, is_new] = measured_.try_emplace({rate, parts});
    if (is_new) found->second = measure(rate, parts);
    return found->second;
  }

  [[nodiscard]] double longest() const { return *std::ranges::max_element(rig_.tip_length); }
  [[nodiscard]] std::vector<QualityRecord> table() const {
    std::vector<QualityRecord> rows;
    for (const auto& [key, row] : measured_) rows.push_back(row);
    return rows;
  }

 private:
  QualityRecord measure(std::uint32_t rate, std::uint32_t parts) const {
    std::vector<RuntimeError> errors(known_.size());
    parallel_for(known_.size(), threads_,
                 [&](std::size_t m) { errors[m] = measure_runtime(opened_.asset(), rig_, known_[m], rate, parts); });
    QualityRecord row{};
    row.frame_rate = float(rate);
    row.substeps = parts;
    const bool is_passive = rig_.model == ChainModel::kPassive;
    const double model_cost = is_passive ? nominal_passive_cost(bones_, parts) : nominal_twist_cost(twisting_, parts);
    row.cost = float(nominal_cost(bones_, parts) + model_cost);
    // What did not stay finite is as wrong as can be written down, and not right for comparing false.
    const auto worse = [](float a, double b) { return std::max(a, float(b <= kMostError ? b : kMostError)); };
    for (std::size_t m = 0; m < errors.size(); ++m) {
      if (!(errors[m].rms <= double(row.rms_error))) row.worst_motion = std::uint32_t(m);
      row.rms_error = worse(row.rms_error, errors[m].rms);
      row.max_error = worse(row.max_error, errors[m].max);
      row.stretch = worse(row.stretch, errors[m].stretch);
      row.penetration = worse(row.penetration, errors[m].penetration);
    }
    return row;
  }

  OpenedAsset opened_;
  Rig rig_;
  unsigned threads_;
  std::size_t bones_ = 0, twisting_ = 0;
  std::vector<KnownMotion> known_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, QualityRecord> measured_;
};

/// What the recipe asks for, as shares and nanoseconds; 0: nothing.
struct Budget {
  double error = 0;
  double cost = 0;
};

Budget budget_of(const Recipe& recipe, double longest) {
  Budget budget{recipe.budget_error / 100, recipe.budget_cost};
  if (recipe.budget_error_mm > 0) {
    const double share = recipe.budget_error_mm / 1000 / longest;
    budget.error = budget.error > 0 ? std::min(budget.error, share) : share;
  }
  return budget;
}

/// All frame rates, with sub-steps of the same rate. The dearest of the parts and the worst of the errors.
TuningRecord try_rate(Bench& bench, std::span<const std::uint32_t> rates, std::uint32_t substep_rate) {
  TuningRecord tuning{};
  tuning.substep_rate = float(substep_rate);
  tuning.slowest_rate = float(rates.front());
  tuning.fastest_rate = float(rates.back());
  for (const std::uint32_t rate : rates) {
    const QualityRecord& row = bench.at(rate, (substep_rate + rate - 1) / rate);
    tuning.reached_error = std::max(tuning.reached_error, row.rms_error);
    tuning.cost = std::max(tuning.cost, row.cost);
  }
  return tuning;
}

ToolError over_budget(const Budget& budget, const TuningRecord& best) {
  std::string text = "\"budget\": ";
  if (budget.error > 0) {
    text += fmt::format("an error of {:.3g} % of the chain's length was asked for and {:.3g} % reached",
                        100 * budget.error, 100 * best.reached_error);
  }
  if (budget.cost > 0) {
    text += fmt::format("{}{:.0f} ns per frame {} with {:.0f} ns", budget.error > 0 ? ", where " : "", budget.cost,
                        budget.error > 0 ? "were allowed," : "were allowed; the least is", best.cost);
  } else {
    text += fmt::format(" with {:g} sub-steps a second", best.substep_rate);
  }
  return {ToolError::Kind::kOverBudget, text + "; ask for less, or damp the hair (dynamics.damping_ratio)"};
}

std::string describe(const TuningRecord& tuning) {
  return fmt::format(
      "tuned: {} at {:g} to {:g} frames per second, error {:.2g} % of the chain's length{}, {:.2g} us per head",
      tuning.substep_rate > tuning.slowest_rate ? fmt::format("sub-steps of {:g} Hz", tuning.substep_rate)
                                                : std::string("one step a frame"),
      tuning.slowest_rate, tuning.fastest_rate, 100 * tuning.reached_error,
      tuning.met == 1 ? "" : ", the least to be had", tuning.cost / 1000);
}

}  // namespace

tl::expected<TunedSolver, ToolError> tune_solver(const AssetContents& contents, const Recipe& recipe, unsigned threads,
                                                 Findings& findings) {
  if (contents.chains.empty()) return TunedSolver{};
  const bool asked = recipe.budget_error > 0 || recipe.budget_error_mm > 0 || recipe.budget_cost > 0;
  const std::vector<std::uint32_t> rates = frame_rates(recipe);
  Bench bench(contents, rates, threads);
  const Budget budget = asked ? budget_of(recipe, bench.longest()) : Budget{kUsualError, 0};
  const double wanted = budget.error > 0 ? budget.error : kUsualError;  // a cost alone may be spent on as much

  TuningRecord best{};
  for (const std::uint32_t parts : kParts) {
    TuningRecord tried = try_rate(bench, rates, parts * rates.front());
    tried.asked_error = float(budget.error);
    tried.asked_cost = float(budget.cost);
    const bool affordable = budget.cost <= 0 || tried.cost <= budget.cost;
    const bool is_first = parts == kParts[0];
    if (!affordable && !is_first) break;
    if (is_first || tried.reached_error < best.reached_error) best = tried;
    best.met = affordable && (budget.error <= 0 || best.reached_error <= budget.error);
    if (best.reached_error <= wanted || !affordable) break;
  }
  if (best.met == 0 && asked) return tl::unexpected(over_budget(budget, best));
  findings.note(describe(best));
  return TunedSolver{{best}, bench.table()};
}

}  // namespace coif
