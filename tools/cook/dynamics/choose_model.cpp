#include "cook/dynamics/choose_model.h"

#include "base/parallel_for.h"
#include "cook/dynamics/settle_dynamics.h"
#include "cook/recipe/rig_recipe.h"
#include "lab/passive_model.h"
#include "lab/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>

namespace coif::cook {
namespace {

/// 1/s. The reference of a stiffer joint would take minutes, and a stiff joint hardly swings.
constexpr double kMostRate = 60000;

/// Share of the chain's length, RMS over a motion, that nobody sees. Chains of one bone differ by the unit of their
/// damping.
constexpr double kAlike = 0.02;
/// A cascade that amplifies more moves visibly differently.
constexpr double kMostGrowthAlike = 30;

/// The same hair in either model.
struct BothModels {
  AssetContents cascade, passive;
};

AssetContents alone(const AssetContents& contents, std::uint32_t chain) {
  return chains_alone(contents, std::array{chain});
}

bool is_too_stiff(const AssetContents& passive, const ChainGroup& group) {
  return std::ranges::any_of(group.telling, [&](std::uint32_t chain) {
    const lab::OpenedAsset opened(alone(passive, chain));
    return lab::fastest_rate(lab::rig_of(opened.asset()).bones) > kMostRate;
  });
}

/// The findings about the first telling chain whose motion is not well-defined; empty if all are.
std::optional<IllPosedChains> try_group(const AssetContents& contents, const ChainGroup& group,
                                        const platform::Threads& threads) {
  for (const std::uint32_t chain : group.telling) {
    const ChainFinding finding = try_chain(alone(contents, chain), threads).finding;
    if (!finding.is_good) return IllPosedChains{group, chain, finding};
  }
  return std::nullopt;
}

/// The largest difference of a chain between the models over all motions; infinite as soon as it is too large.
double distance_of_models(const BothModels& both, std::uint32_t chain, const platform::Threads& threads) {
  const AssetContents cascade = alone(both.cascade, chain), passive = alone(both.passive, chain);
  if (chain_growth(cascade, 0) > kMostGrowthAlike) return INFINITY;
  const lab::OpenedAsset opened_cascade(cascade), opened_passive(passive);
  const lab::Rig rig = lab::rig_of(opened_cascade.asset()), other = lab::rig_of(opened_passive.asset());
  double worst = 0;
  for (const motion::Motion motion : kTrialMotions) {
    std::array<lab::ReferenceRun, 1> runs[2];
    parallel_for(2, threads,
                 [&](std::size_t i) { runs[i][0] = solve_trial(i == 0 ? rig : other, motion, threads.stop); });
    const double apart = rms_apart(rig, runs[0], runs[1]);
    if (!(apart <= kAlike)) return INFINITY;
    worst = std::max(worst, apart);
  }
  return worst;
}

/// The decision for a group; `why` is empty where the rule's model stays.
struct Verdict {
  ChainModel model = ChainModel::kCascade;
  std::string why;
  std::optional<IllPosedChains> ill_posed;
};

Verdict judge_given(const BothModels& both, const ChainGroup& group, bool may_be_passive,
                    const platform::Threads& threads) {
  Verdict verdict;
  verdict.ill_posed = try_group(both.cascade, group, threads);
  if (!verdict.ill_posed || !may_be_passive || is_too_stiff(both.passive, group)) return verdict;
  if (try_group(both.passive, group, threads)) return verdict;
  verdict.model = ChainModel::kPassive;
  verdict.why = fmt::format(
      "{}: moved by the passive model; as a cascade it would have to be damped ({}), and then not swing as it was "
      "asked to",
      names_of(both.cascade, group, verdict.ill_posed->chain), what_failed(verdict.ill_posed->finding));
  verdict.ill_posed.reset();
  return verdict;
}

Verdict judge_preset(const BothModels& both, const ChainGroup& group, const platform::Threads& threads) {
  Verdict verdict{.model = ChainModel::kPassive, .why = {}, .ill_posed = {}};
  const std::string names = names_of(both.cascade, group, group.telling[0]);
  if (is_too_stiff(both.passive, group)) {
    if (try_group(both.cascade, group, threads)) return verdict;
    verdict.model = ChainModel::kCascade;
    verdict.why = fmt::format("{}: moved as a cascade: it is too stiff to swing", names);
    return verdict;
  }
  double apart = 0;
  for (const std::uint32_t chain : group.telling) apart = std::max(apart, distance_of_models(both, chain, threads));
  if (!(apart <= kAlike) || try_group(both.cascade, group, threads)) return verdict;
  verdict.model = ChainModel::kCascade;
  verdict.why =
      fmt::format("{}: moved as a cascade, which is within {:.2g} % of its length of the passive model and costs less",
                  names, 100 * apart);
  return verdict;
}

AssetContents settled(const RigRecipe& recipe, const SaidMotion& said, std::span<const ChainModel> models,
                      AssetContents contents) {
  Findings unheard;
  settle_model(recipe, said, models, contents, unheard);
  return contents;
}

}  // namespace

std::vector<IllPosedChains> find_ill_posed(const AssetContents& contents, const platform::Threads& threads) {
  const std::vector<ChainGroup> groups = group_chains(contents);
  const platform::Threads of_group = threads.divided_by(groups.size());
  std::vector<std::optional<IllPosedChains>> tried(groups.size());
  parallel_for(groups.size(), threads, [&](std::size_t g) {
    const bool is_cascade = contents.chains[groups[g].chains[0]].model == ChainModel::kCascade;
    if (is_cascade) tried[g] = try_group(contents, groups[g], of_group);
  });
  std::vector<IllPosedChains> found;
  for (const auto& each : tried) {
    if (each) found.push_back(*each);
  }
  return found;
}

std::vector<ChainModel> models_by_rule(const RigRecipe& recipe, const SaidMotion& said, const AssetContents& contents) {
  std::vector<ChainModel> models;
  for (const ChainRecord& chain : contents.chains) {
    const auto sources = std::span(said.sources).subspan(chain.first_bone, chain.bone_count);
    const bool by_preset = std::ranges::find(sources, MotionSource::kPreset) != sources.end();
    const bool passive = recipe.dynamics_model == DynamicsModel::kPassive ||
                         (recipe.dynamics_model == DynamicsModel::kAuto && by_preset);
    models.push_back(passive ? ChainModel::kPassive : ChainModel::kCascade);
  }
  return models;
}

ModelChoice choose_models(const RigRecipe& recipe, const SaidMotion& said, const AssetContents& contents,
                          const platform::Threads& threads, Findings& findings) {
  ModelChoice choice{models_by_rule(recipe, said, contents), {}};
  if (recipe.dynamics_model == DynamicsModel::kPassive) return choice;
  const std::size_t count = contents.chains.size();
  const AssetContents by_rule = settled(recipe, said, choice.models, contents);
  const BothModels both{settled(recipe, said, std::vector(count, ChainModel::kCascade), contents),
                        settled(recipe, said, std::vector(count, ChainModel::kPassive), contents)};
  if (!can_be_run(by_rule) || !can_be_run(both.cascade) || !can_be_run(both.passive)) return choice;

  const std::vector<ChainGroup> groups = group_chains(by_rule);
  const platform::Threads of_group = threads.divided_by(groups.size());
  std::vector<Verdict> verdicts(groups.size());
  parallel_for(groups.size(), threads, [&](std::size_t g) {
    const bool by_preset = by_rule.chains[groups[g].chains[0]].model == ChainModel::kPassive;
    verdicts[g] = by_preset ? judge_preset(both, groups[g], of_group)
                            : judge_given(both, groups[g], recipe.dynamics_model == DynamicsModel::kAuto, of_group);
  });
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const std::uint32_t chain : groups[g].chains) choice.models[chain] = verdicts[g].model;
    if (!verdicts[g].why.empty()) findings.note(verdicts[g].why);
    if (verdicts[g].ill_posed) choice.ill_posed.push_back(*verdicts[g].ill_posed);
  }
  return choice;
}

}  // namespace coif::cook
