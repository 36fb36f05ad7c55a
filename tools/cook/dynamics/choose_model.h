#pragma once

#include "cook/dynamics/bake_dynamics.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/chain_trial.h"
#include "cook/recipe/findings.h"
#include "platform/stop.h"
#include "write/asset_writer.h"

#include <cstdint>
#include <vector>

namespace coif::cook {

struct RigRecipe;

/// Chains that have no one motion as a cascade, and stay one.
struct IllPosedChains {
  ChainGroup group;
  std::uint32_t chain = 0;  ///< The first that failed.
  ChainFinding finding;     ///< How.
};

struct ModelChoice {
  std::vector<ChainModel> models;  ///< One for each chain.
  std::vector<IllPosedChains> ill_posed;
};

/// The cascades of `contents` that have no one motion (chain_trial.h); of chains alike, the telling ones are run.
[[nodiscard]] std::vector<IllPosedChains> find_ill_posed(const AssetContents& contents,
                                                         const platform::Threads& threads);

/// By which model each chain moves where nothing is run: as "dynamics.model" says; if that leaves it open, a chain with
/// a bone that a preset moves by the passive one, others as a cascade.
[[nodiscard]] std::vector<ChainModel> models_by_rule(const RigRecipe& recipe, const SaidMotion& said,
                                                     const AssetContents& contents);

/// By which model each chain moves, after running the telling ones in both:
/// - One with numbers of its own is a cascade, the cheaper model, if that has one motion. If not, it would have to be
/// damped, and
///   would not swing as it was asked to: then it is passive, unless that has no one motion either or is so stiff that
///   nothing could check it.
/// - One of a preset is passive, unless a cascade moves it within two percent of its length like that, or it is too
/// stiff
///   to swing.
/// Notes say why. `contents` as settle_model() wants it.
[[nodiscard]] ModelChoice choose_models(const RigRecipe& recipe, const SaidMotion& said, const AssetContents& contents,
                                        const platform::Threads& threads, Findings& findings);

}  // namespace coif::cook
