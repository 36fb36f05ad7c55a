#include "cook/dynamics/tuning_bench.h"

#include "base/parallel_for.h"
#include "base/text.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/chain_trial.h"
#include "cook/dynamics/settle_dynamics.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::cook {
namespace {

constexpr double kSeconds = 2;
constexpr double kMostError = 1000;    ///< The largest error that an asset may hold.
constexpr std::size_t kFewBones = 24;  ///< Up to here every chain is run.
/// Limits in steps times bones: of the reference over all motions, and of the runtime over all motions, frame rates and
/// sub-steps.
constexpr double kMostReferenceWork = 8e6;
constexpr std::uint64_t kMostRuntimeWork = 8'000'000;
/// First runs that a reference may take: with fewer hardly a motion would be known. Two runs take three times a first,
/// and hair that whips round some more.
constexpr double kLeastRuns = 4;

lab::ReferenceSettings reference_settings(std::span<const std::uint32_t> rates) {
  lab::ReferenceSettings settings;
  settings.sample_times = lab::frame_times(rates, kSeconds);
  settings.steps_per_second = kCoarsestSteps;
  settings.most_steps_per_second = 23040;
  settings.wanted_self_difference_pct = 0.1;  // A seventh of the smallest usual target.
  return settings;
}

double first_work_of(const AssetContents& contents, std::span<const std::uint32_t> chains,
                     const lab::ReferenceSettings& settings) {
  const lab::OpenedAsset opened(chains_alone(contents, chains));
  return double(std::size(kCookSuite)) * lab::first_run_work(lab::rig_of(opened.asset()), {}, settings);
}

std::size_t bones_of(const AssetContents& contents, std::span<const std::uint32_t> chains) {
  std::size_t count = 0;
  for (const std::uint32_t chain : chains) count += contents.chains[chain].bone_count;
  return count;
}

/// Chains that represent the others, groups with most bones first, up to the limit of work for their references.
ChainsToRun telling_chains(const AssetContents& contents, const lab::ReferenceSettings& settings) {
  std::vector<ChainGroup> groups = group_chains(contents);
  std::ranges::stable_sort(groups, std::greater<>{},
                           [&](const ChainGroup& group) { return bones_of(contents, group.chains); });
  ChainsToRun run;
  double left = kMostReferenceWork / kLeastRuns;
  for (const ChainGroup& group : groups) {
    const double work = first_work_of(contents, group.telling, settings);
    if (work > left) {
      run.left_out += group.chains.size();
      continue;
    }
    left -= work;
    run.chains.insert(run.chains.end(), group.telling.begin(), group.telling.end());
  }
  std::ranges::sort(run.chains);
  return run;
}

ChainsToRun chains_to_run(const AssetContents& contents, std::span<const std::uint32_t> rates) {
  const lab::ReferenceSettings settings = reference_settings(rates);
  ChainsToRun all;
  all.chains.resize(contents.chains.size());
  std::iota(all.chains.begin(), all.chains.end(), 0u);
  const bool are_few = bones_of(contents, all.chains) <= kFewBones;
  if (are_few && first_work_of(contents, all.chains, settings) <= kMostReferenceWork / kLeastRuns) return all;
  return telling_chains(contents, settings);
}

std::size_t twisting_bones(const AssetContents& contents, const ChainRecord& chain) {
  const auto bones = std::span(contents.dynamics).subspan(chain.first_bone, chain.bone_count);
  return std::size_t(
      std::ranges::count_if(bones, [](const DynamicsRecord& bone) { return bone.torsion < kShortestArc; }));
}

}  // namespace

TuningBench::TuningBench(const AssetContents& contents, std::span<const std::uint32_t> rates,
                         const platform::Threads& threads)
    : TuningBench(contents, chains_to_run(contents, rates), rates, threads) {}

TuningBench::TuningBench(const AssetContents& contents, const ChainsToRun& run, std::span<const std::uint32_t> rates,
                         const platform::Threads& threads)
    : opened_(chains_alone(contents, run.chains)), rig_(lab::rig_of(opened_.asset())), threads_(threads) {
  for (const ChainRecord& chain : contents.chains) {
    bones_ += chain.bone_count;
    if (chain.model == ChainModel::kPassive) passive_ += chain.bone_count;
    if (chain.model == ChainModel::kCascade) twisting_ += twisting_bones(contents, chain);
  }
  if (run.left_out > 0) {
    left_out_.push_back(fmt::format("tuning: {} not run, since {} more work than a cook may take",
                                    counted(run.left_out, "chain was", "chains were"),
                                    run.left_out == 1 ? "it needs" : "they need"));
  }
  if (rig_.bones.empty()) return;
  solve(rates);
  say_what_is_left_out();
}

void TuningBench::solve(std::span<const std::uint32_t> rates) {
  lab::ReferenceSettings settings = reference_settings(rates);
  settings.most_work = kMostReferenceWork / (double(std::size(kCookSuite)) * lab::first_run_work(rig_, {}, settings));
  settings.threads = {1, threads_.stop};
  known_.resize(std::size(kCookSuite));
  parallel_for(known_.size(), threads_, [&](std::size_t m) {
    known_[m] = {kCookSuite[m], lab::solve_reference(rig_, {}, *motion::path_of(kCookSuite[m]), settings)};
  });
}

void TuningBench::say_what_is_left_out() {
  std::vector<const char*> unsolved, inexact;
  double worst = 0;
  for (const lab::KnownMotion& known : known_) {
    if (!known.reference.is_solved()) {
      unsolved.push_back(motion::name_of(known.motion));
    } else if (known.reference.was_cut()) {
      inexact.push_back(motion::name_of(known.motion));
      worst = std::max(worst, known.reference.self_difference_pct());
    }
  }
  if (!unsolved.empty()) {
    left_out_.push_back(fmt::format("tuning: not tried, since its reference needs more work than a cook may take: {}",
                                    fmt::join(unsolved, ", ")));
  }
  if (!inexact.empty()) {
    left_out_.push_back(
        fmt::format("tuning: known to {:.2g} % of the length only, since more needs more work than a cook may take: {}",
                    worst, fmt::join(inexact, ", ")));
  }
}

bool TuningBench::is_empty() const {
  return std::ranges::none_of(known_, [](const lab::KnownMotion& known) { return known.reference.is_solved(); });
}

std::uint64_t TuningBench::work_of(std::uint32_t rate, std::uint32_t parts) const {
  return std::uint64_t(kSeconds * rate) * parts * rig_.bones.size() * known_.size();
}

bool TuningBench::has_work_left(std::span<const std::uint32_t> rates, std::uint32_t substep_rate) const {
  std::uint64_t work = work_;
  for (const std::uint32_t rate : rates) {
    const std::uint32_t parts = (substep_rate + rate - 1) / rate;
    if (!measured_.contains({rate, parts})) work += work_of(rate, parts);
  }
  return work <= kMostRuntimeWork;
}

const MeasuredRate& TuningBench::at(std::uint32_t rate, std::uint32_t parts) {
  const auto [found, is_new] = measured_.try_emplace({rate, parts});
  if (is_new) {
    found->second = measure(rate, parts);
    work_ += work_of(rate, parts);
  }
  return found->second;
}

double TuningBench::longest() const { return *std::ranges::max_element(rig_.tip_length); }

std::vector<QualityRecord> TuningBench::table() const {
  std::vector<QualityRecord> rows;
  for (const auto& [key, measured] : measured_) rows.push_back(measured.quality);
  return rows;
}

MeasuredRate TuningBench::measure(std::uint32_t rate, std::uint32_t parts) const {
  std::vector<lab::RuntimeError> errors(known_.size());
  parallel_for(known_.size(), threads_, [&](std::size_t m) {
    if (known_[m].reference.is_solved())
      errors[m] = lab::measure_runtime(opened_.asset(), rig_, known_[m], rate, parts, threads_.stop);
  });
  MeasuredRate measured{};
  QualityRecord& row = measured.quality;
  row.frame_rate = float(rate);
  row.substeps = parts;
  const double model_cost = nominal_passive_cost(passive_, parts) + nominal_twist_cost(twisting_, parts);
  row.cost = float(nominal_cost(bones_, parts) + model_cost);
  // A run that did not stay finite counts as the largest error; NaN would compare as false.
  const auto worse = [](float a, double b) { return std::max(a, float(b <= kMostError ? b : kMostError)); };
  for (std::size_t m = 0; m < errors.size(); ++m) {
    if (!known_[m].reference.is_solved()) continue;
    if (!(errors[m].rms <= double(row.rms_error))) row.worst_motion = std::uint32_t(m);
    row.rms_error = worse(row.rms_error, errors[m].rms);
    row.max_error = worse(row.max_error, errors[m].max);
    row.stretch = worse(row.stretch, errors[m].stretch);
    row.penetration = worse(row.penetration, errors[m].penetration);
    measured.worst_second = double(worse(float(measured.worst_second), errors[m].worst_second));
  }
  return measured;
}

}  // namespace coif::cook
