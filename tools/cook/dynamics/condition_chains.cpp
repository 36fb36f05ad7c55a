#include "base/parallel_for.h"
#include "cook/dynamics/bake_dynamics.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/settle_dynamics.h"
#include "lab/measure_runtime.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif {
namespace {

constexpr double kTrialSeconds = 2;
constexpr double kMostSelfDifferencePct = 0.1;
/// Share of the chain's length. A chain that hurries about its head is off by a few percent for the contacts' sake; one that
/// amplifies is off by ten and more.
constexpr double kMostRuntimeError = 0.05;
constexpr double kMostGrowth = 1.0e4;  ///< No need to compute what amplifies a rounding error into sight.
constexpr std::uint32_t kTrialRate = 60, kTrialSubsteps = 4;

/// From what most easily parts two computations to what least does; still and nod never did so alone.
constexpr Motion kMotions[] = {Motion::kTumble, Motion::kTurn, Motion::kRun, Motion::kCharge, Motion::kJump};

/// What a chain is given. Damping and friction are shares of the square root of the bone's stiffness, its own weight's and
/// its acceleration's included; both at 1 are half of critical each.
struct Conditioning {
  double damping = 0;
  double friction = 0;
  double parent_share = 1;
};

/// Ordered by how much they change. Damping alone helps short chains; friction takes the energy out of long ones; and only
/// a share of the pull that does not follow the parent bounds the gain of very long ones.
constexpr Conditioning kLadder[] = {{0, 0, 1},   {2, 0, 1},     {3, 0, 1},   {2, 0.7, 0.8}, {2, 1, 0.6},
                                    {2, 1, 0.4}, {2, 1.4, 0.3}, {3, 2, 0.2}, {4, 3, 0.1},   {4, 4, 0}};

/// How a chain failed.
struct Finding {
  bool is_good = true;
  Motion motion = Motion::kStill;
  double self_difference_pct = 0;
  double runtime_error = 0;
  double growth = 0;  ///< Above kMostGrowth nothing was computed.
};

struct Outcome {
  std::size_t rung = 0;
  std::uint32_t worst_chain = 0;  ///< Which made the last climb necessary.
  Finding first;                  ///< On the ground.
  bool is_good = true;
};

void apply(const Conditioning& rung, const BoneRecord& bone, DynamicsRecord& dynamics) {
  const double root = natural_rate(dynamics, bone.length);
  dynamics.damping = std::max(dynamics.damping, float(std::min(rung.damping * root, kMostDamping)));
  dynamics.friction = std::max(dynamics.friction, float(std::min(rung.friction * root, kMostDamping)));
  dynamics.parent_share = std::min(dynamics.parent_share, float(rung.parent_share));
}

void apply(const Conditioning& rung, AssetContents& contents, std::uint32_t chain) {
  const ChainRecord& record = contents.chains[chain];
  for (std::uint32_t b = record.first_bone; b < record.first_bone + record.bone_count; ++b) {
    apply(rung, contents.bones[b], contents.dynamics[b]);
  }
}

Finding examine_motion(const OpenedAsset& opened, const Rig& rig, Motion motion) {
  constexpr std::uint32_t kSampled[] = {kTrialRate / 2};
  ReferenceSettings settings;
  settings.sample_times = common_times(kSampled, kTrialSeconds);
  settings.most_steps_per_second = 11520;
  settings.wanted_self_difference_pct = kMostSelfDifferencePct;
  KnownMotion known{motion, solve_reference(rig, {}, *path_of(motion), settings)};
  Finding finding{true, motion, known.reference.self_difference_pct(), 0};
  finding.is_good = finding.self_difference_pct <= kMostSelfDifferencePct;  // false for NaN
  if (!finding.is_good) return finding;
  finding.runtime_error = measure_runtime(opened.asset(), rig, known, kTrialRate, kTrialSubsteps).rms;
  finding.is_good = finding.runtime_error <= kMostRuntimeError;
  return finding;
}

Finding examine(const AssetContents& contents, std::uint32_t chain, const Conditioning& rung) {
  AssetContents alone = chains_alone(contents, std::array{chain});
  apply(rung, alone, 0);
  const double growth = chain_growth(alone, 0);
  if (growth > kMostGrowth && &rung != std::end(kLadder) - 1) return {false, Motion::kStill, 0, 0, growth};
  const OpenedAsset opened(alone);
  const Rig rig = rig_of(opened.asset());
  for (const Motion motion : kMotions) {
    const Finding finding = examine_motion(opened, rig, motion);
    if (!finding.is_good) return finding;
  }
  return {};
}

Outcome climb(const AssetContents& contents, const ChainGroup& group) {
  Outcome outcome;
  outcome.worst_chain = group.telling[0];
  for (const std::uint32_t chain : group.telling) {
    for (;;) {
      const Finding finding = examine(contents, chain, kLadder[outcome.rung]);
      if (finding.is_good) break;
      if (outcome.rung == 0) outcome.first = finding;
      outcome.worst_chain = chain;
      if (outcome.rung + 1 == std::size(kLadder)) {
        outcome.is_good = false;
        return outcome;
      }
      ++outcome.rung;
    }
  }
  return outcome;
}

const char* name_of(Motion motion) {
  for (const MotionInfo& info : all_motions()) {
    if (info.motion == motion) return info.name;
  }
  return "";
}

std::string what_failed(const Finding& finding) {
  if (finding.growth > 0) {
    return fmt::format("its bones amplify what moves the first of them {:.0g} times", finding.growth);
  }
  if (!(finding.self_difference_pct <= kMostSelfDifferencePct)) {
    return std::isfinite(finding.self_difference_pct)
               ? fmt::format("two computations of motion {} differed by {:.2g} % of its length",
                             name_of(finding.motion), finding.self_difference_pct)
               : fmt::format("two computations of motion {} had nothing in common", name_of(finding.motion));
  }
  return fmt::format("240 steps a second were off by {:.2g} % of its length in motion {}", 100 * finding.runtime_error,
                     name_of(finding.motion));
}

void report(const AssetContents& contents, const ChainGroup& group, const Outcome& outcome, Findings& findings) {
  if (outcome.rung == 0 && outcome.is_good) return;
  const Conditioning& rung = kLadder[outcome.rung];
  const std::string which =
      group.chains.size() == 1
          ? fmt::format("chain {}", chain_name(contents, outcome.worst_chain))
          : fmt::format("chain {} and {} like it", chain_name(contents, outcome.worst_chain), group.chains.size() - 1);
  const std::string done = fmt::format("damping {:g}, friction {:g} (of the root of the stiffness), parent_share {:g}",
                                       rung.damping, rung.friction, rung.parent_share);
  if (outcome.is_good) {
    findings.note(fmt::format("{}: {}; raised to {}", which, what_failed(outcome.first), done));
  } else {
    findings.warn(
        fmt::format("{}: {}, and with {} as well; its motion will depend on the frame rate; raise dynamics.resistance "
                    "or use fewer bones",
                    which, what_failed(outcome.first), done));
  }
}

}  // namespace

bool can_be_run(const AssetContents& contents) {
  return !contents.chains.empty() && OpenedAsset(contents).asset().is_open();
}

std::vector<DynamicsRecord> condition_chains(const AssetContents& contents, unsigned threads, Findings& findings) {
  const std::vector<ChainGroup> groups = group_chains(contents);
  std::vector<Outcome> outcomes(groups.size());
  parallel_for(groups.size(), threads, [&](std::size_t g) { outcomes[g] = climb(contents, groups[g]); });
  AssetContents conditioned = contents;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const std::uint32_t chain : groups[g].chains) apply(kLadder[outcomes[g].rung], conditioned, chain);
    report(contents, groups[g], outcomes[g], findings);
  }
  return std::move(conditioned.dynamics);
}

}  // namespace coif
