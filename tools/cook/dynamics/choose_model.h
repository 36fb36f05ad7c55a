#pragma once

#include "cook/dynamics/bake_dynamics.h"
#include "cook/dynamics/chain_groups.h"
#include "cook/dynamics/chain_trial.h"
#include "cook/recipe/findings.h"
#include "platform/stop.h"
#include "write/asset_writer.h"

#include <cstdint>
#include <span>
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

/// Leans each bone's pull, of those for which `takes` is true, against the weight that it carries, so that under an
/// upright head hair rests exactly as modelled. Closed form, in the model of each chain. A bone too soft to carry that
/// is made as stiff as it takes; a note says how many.
void keep_rest_shape(const std::vector<bool>& takes, AssetContents& contents, Findings& findings);

/// Stiffness and damping of hair that nobody gave numbers to, from what hair is, for the passive model: of those bones
/// of `contents` (skeleton and dynamics) that a preset moves, says `said`.
///
/// Free hairs of a lock bend like one: the stiffness of hair against its weight is a length, that of hair which its own
/// weight just bends over, (E I / (rho g))^(1/3), whatever the lock's thickness; 5 cm for human hair (Goldstein, Warren
/// and Ball 2012, "Shape of a Ponytail and the Statistical Physics of Hair Fiber Bundles"), more where locks hold
/// together. So a joint between bones of the mean length l has the stiffness rho g b^3 / l against bending; hair
/// shorter than b stands and longer hair hangs, and swings as a pendulum. Each joint is damped at its share, one of
/// said.damping_ratios, of what would keep it from swinging past.
void bake_natural_dynamics(const SaidMotion& said, AssetContents& contents, Findings& findings);

/// Completes the dynamics of `contents`, which holds a skeleton and `said.records` with hit radii, in these models, one
/// for each chain: bones that nobody gave numbers to get those of the preset, and all but those that a spring moves
/// keep the shape that was modelled, unless "dynamics.sags".
void settle_model(const RigRecipe& recipe, const SaidMotion& said, std::span<const ChainModel> models,
                  AssetContents& contents, Findings& findings);

}  // namespace coif::cook
