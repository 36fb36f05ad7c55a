#include "base/parallel_for.h"
#include "cook/dynamics/bake_dynamics.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/chain_trial.h"
#include "cook/dynamics/settle_dynamics.h"
#include "lab/rig.h"
#include "lab/runtime_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

namespace coif::cook {
namespace {

/// A candidate for a chain. Damping and friction are shares of the square root of the bone's stiffness, which includes
/// its weight's and its acceleration's; with 1 each is half of critical.
struct Conditioning {
  double damping = 0;
  double friction = 0;
  double parent_share = 1;
};

/// From little to much. Damping alone helps short chains; friction takes energy out of long ones; only a share of the
/// pull that does not follow the parent bounds the gain of very long ones.
constexpr Conditioning kCandidates[] = {{0.5, 0, 1},   {1, 0, 1},     {2, 0, 1},   {3, 0, 1},   {1, 0.5, 0.8},
                                        {1, 0.7, 0.6}, {2, 0.7, 0.8}, {2, 1, 0.6}, {2, 1, 0.4}, {2, 1.4, 0.3},
                                        {3, 2, 0.2},   {4, 3, 0.1},   {4, 4, 0}};
/// Number of good candidates after which the search ends: later ones change more. Chains of many bones take long.
std::size_t enough_good(std::uint32_t bones) { return bones <= 16 ? 3 : 1; }

/// % of the chain's length, RMS: above it two computations of the artist's motion differ by more than from Algorithm 1.
constexpr double kMostSelfDifferenceOfArtistPct = 5;
constexpr int kArtistIterations = 8;

struct Outcome {
  std::size_t candidate = 0;
  double difference = 0;  ///< Difference from the artist's motion, share of the length, RMS over the motions.
  bool is_good = true;
};

void apply(const Conditioning& rung, const BoneRecord& bone, DynamicsRecord& dynamics) {
  const double root = natural_rate(dynamics, bone.length);
  dynamics.damping = std::max(dynamics.damping, float(std::min(rung.damping * root, double(kMostDamping))));
  dynamics.friction = std::max(dynamics.friction, float(std::min(rung.friction * root, double(kMostDamping))));
  dynamics.parent_share = std::min(dynamics.parent_share, float(rung.parent_share));
}

void apply(const Conditioning& rung, AssetContents& contents, std::uint32_t chain) {
  const ChainRecord& record = contents.chains[chain];
  for (std::uint32_t b = record.first_bone; b < record.first_bone + record.bone_count; ++b) {
    apply(rung, contents.bones[b], contents.dynamics[b]);
  }
}

ChainTrial examine(const AssetContents& contents, std::uint32_t chain, const Conditioning& candidate,
                   const std::stop_token& stop) {
  AssetContents alone = chains_alone(contents, std::array{chain});
  apply(candidate, alone, 0);
  const bool is_last = &candidate == std::end(kCandidates) - 1;
  return is_last ? try_any_chain(alone, {1, stop}) : try_chain(alone, {1, stop});
}

/// The motion as Algorithm 1 has it at the rate that an artist tunes at; by numbers that it does not know, the
/// runtime's.
lab::ReferenceRun run_by_steps(const lab::OpenedAsset& opened, const lab::Rig& rig, motion::Motion motion) {
  lab::ReferenceRun run;
  run.times = trial_times();
  run.places.resize(run.times.size() * rig.tips.size());
  const auto path = motion::path_of(motion);
  const bool has_resistance =
      std::ranges::any_of(rig.bones, [](const lab::RigBone& bone) { return bone.resistance > 0; });
  lab::RuntimeSolver solver(opened.asset(), {}, has_resistance ? kThesisSolver : kCoifSolver,
                            has_resistance ? kArtistIterations : int(kTrialSubsteps));
  solver.reset(path->pose(0));
  for (std::size_t sample = 0; sample < run.times.size(); ++sample) {
    if (!solver.step(path->pose(run.times[sample]), 1.0 / kTrialRate)) break;
    for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
      run.places[tip * run.times.size() + sample] = solver.bone_ends()[rig.tips[tip]];
    }
  }
  return run;
}

/// The artist's motion: runs of a chain's tips, in the order of kTrialMotions.
struct AskedMotions {
  lab::Rig rig;
  std::vector<lab::ReferenceRun> runs;
};

/// The chain's motions with the artist's numbers, where they are well-defined.
AskedMotions artists_motions(const AssetContents& contents, std::uint32_t chain, const platform::Threads& threads) {
  const AssetContents alone = chains_alone(contents, std::array{chain});
  const lab::OpenedAsset opened(alone);
  const lab::Rig rig = lab::rig_of(opened.asset());
  const bool may_exist = !grows_beyond_hope(alone);
  std::vector<lab::ReferenceRun> runs(std::size(kTrialMotions));
  parallel_for(runs.size(), threads, [&](std::size_t m) {
    if (may_exist) runs[m] = solve_trial(rig, kTrialMotions[m], threads.stop);
    if (may_exist && runs[m].self_difference_pct() <= kMostSelfDifferenceOfArtistPct) return;
    runs[m] = run_by_steps(opened, rig, kTrialMotions[m]);
  });
  return {rig, std::move(runs)};
}

/// The result of a candidate for the telling chains of a group.
struct Examined {
  bool is_good = true;
  double difference = 0;  ///< As Outcome::difference, for the chain that it changes most.
};

/// Examines some of kCandidates, all chains of all candidates in parallel; a candidate that fails gets no further
/// chain.
std::vector<Examined> examine_group(const AssetContents& contents, const ChainGroup& group,
                                    std::span<const AskedMotions> asked, std::span<const Conditioning> candidates,
                                    const platform::Threads& threads) {
  std::vector<std::atomic<bool>> is_bad(candidates.size());
  std::vector<double> differences(candidates.size() * group.telling.size(), 0);
  parallel_for(differences.size(), threads, [&](std::size_t task) {
    const std::size_t k = task / candidates.size(), i = task % candidates.size();
    if (is_bad[i]) return;
    const ChainTrial trial = examine(contents, group.telling[k], candidates[i], threads.stop);
    if (!trial.finding.is_good) {
      is_bad[i] = true;
    } else {
      differences[task] = rms_apart(asked[k].rig, trial.runs, asked[k].runs);
    }
  });
  std::vector<Examined> examined;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    examined.push_back({!is_bad[i], 0});
    for (std::size_t task = i; task < differences.size(); task += candidates.size()) {
      examined[i].difference = std::max(examined[i].difference, differences[task]);
    }
  }
  return examined;
}

/// Finds the candidate that changes the motion least among those under which every telling chain is good. Examines as
/// many at a time as there are threads. Results count in the order of the candidates, so they do not depend on the
/// number of threads.
Outcome search(const AssetContents& contents, const ChainGroup& group, const platform::Threads& threads) {
  std::vector<AskedMotions> asked;
  for (const std::uint32_t chain : group.telling) asked.push_back(artists_motions(contents, chain, threads));
  Outcome outcome;
  std::size_t good = 0;
  const std::size_t enough = enough_good(contents.chains[group.telling[0]].bone_count);
  for (std::size_t first = 0; first < std::size(kCandidates) && good < enough; first += threads.count) {
    const std::span<const Conditioning> all(kCandidates);
    const auto tried = all.subspan(first, std::min<std::size_t>(threads.count, all.size() - first));
    const std::vector<Examined> batch = examine_group(contents, group, asked, tried, threads);
    for (std::size_t i = 0; i < batch.size() && good < enough; ++i) {
      if (!batch[i].is_good) continue;
      if (good == 0 || batch[i].difference < outcome.difference) {
        outcome.candidate = first + i;
        outcome.difference = batch[i].difference;
      }
      ++good;
    }
  }
  outcome.is_good = good > 0;
  if (!outcome.is_good) outcome.candidate = std::size(kCandidates) - 1;
  return outcome;
}

void report(const AssetContents& contents, const IllPosedChains& ill, const Outcome& outcome, Findings& findings) {
  const Conditioning& chosen = kCandidates[outcome.candidate];
  const std::string which = names_of(contents, ill.group, ill.chain);
  const std::string done = fmt::format("damping {:g}, friction {:g} (of the root of the stiffness), parent_share {:g}",
                                       chosen.damping, chosen.friction, chosen.parent_share);
  if (outcome.is_good) {
    findings.note(fmt::format("{}: {}; raised to {}, which changes its motion by {:.2g} % of its length", which,
                              what_failed(ill.finding), done, 100 * outcome.difference));
  } else {
    findings.warn(
        "C132",
        fmt::format("{}: {}, and with {} as well; its motion will depend on the frame rate; raise dynamics.resistance "
                    "or use fewer bones",
                    which, what_failed(ill.finding), done));
  }
}

}  // namespace

bool can_be_run(const AssetContents& contents) {
  return !contents.chains.empty() && lab::OpenedAsset(contents).asset().is_open();
}

std::vector<DynamicsRecord> condition_chains(const AssetContents& contents, std::span<const IllPosedChains> ill_posed,
                                             const platform::Threads& threads, Findings& findings) {
  std::vector<Outcome> outcomes(ill_posed.size());
  const platform::Threads of_group = threads.divided_by(ill_posed.size());
  parallel_for(ill_posed.size(), threads,
               [&](std::size_t g) { outcomes[g] = search(contents, ill_posed[g].group, of_group); });
  AssetContents conditioned = contents;
  for (std::size_t g = 0; g < ill_posed.size(); ++g) {
    const Conditioning& chosen = kCandidates[outcomes[g].candidate];
    for (const std::uint32_t chain : ill_posed[g].group.chains) apply(chosen, conditioned, chain);
    report(contents, ill_posed[g], outcomes[g], findings);
  }
  return std::move(conditioned.dynamics);
}

std::vector<AskedRecord> asked_of(std::span<const DynamicsRecord> dynamics) {
  std::vector<AskedRecord> asked;
  for (const DynamicsRecord& bone : dynamics) asked.push_back({bone.friction, bone.damping, bone.parent_share});
  return asked;
}

}  // namespace coif::cook
