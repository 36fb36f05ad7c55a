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

/// Chains whose motion is not well-posed as a cascade but that remain cascades.
struct IllPosedChains {
  ChainGroup group;
  std::uint32_t chain = 0;  ///< The first that failed.
  ChainFinding finding;     ///< How they failed.
};

struct ModelChoice {
  std::vector<ChainModel> models;  ///< One per chain.
  std::vector<IllPosedChains> ill_posed;
};

/// The cascades of `contents` without a well-defined motion (chain_trial.h); among similar chains the telling ones are
/// run.
[[nodiscard]] std::vector<IllPosedChains> find_ill_posed(const AssetContents& contents,
                                                         const platform::Threads& threads);

/// The model of each chain without any run: as "dynamics.model" says; if that leaves it open, the passive one for a
/// chain with a bone that a preset moves, else the cascade.
[[nodiscard]] std::vector<ChainModel> models_by_rule(const RigRecipe& recipe, const SaidMotion& said,
                                                     const AssetContents& contents);

/// The model of each chain, after the telling ones were run in both:
/// - A chain with numbers of its own becomes a cascade, the cheaper model, if its motion is well-defined there. If not,
///   it would have to be damped, and would not swing as requested: then it becomes passive, unless that is not
///   well-defined either or is so stiff that nothing could check it.
/// - A chain of a preset becomes passive, unless a cascade moves it within two percent of its length like that, or it
///   is too stiff to swing.
///
/// Notes give the reasons. `contents` as for settle_model().
[[nodiscard]] ModelChoice choose_models(const RigRecipe& recipe, const SaidMotion& said, const AssetContents& contents,
                                        const platform::Threads& threads, Findings& findings);

/// Leans the pull of each bone for which `takes` is true against the weight that it carries, so that under an upright
/// head hair rests exactly as modelled. Closed form, in the model of each chain. A bone that is too soft to carry the
/// weight is made stiff enough; a note says how many.
void keep_rest_shape(const std::vector<bool>& takes, AssetContents& contents, Findings& findings);

/// Stiffness and damping of hair for which nobody gave numbers, from the physics of hair, for the passive model.
/// Applies to the bones of `contents` (skeleton and dynamics) that a preset moves, as `said` tells.
///
/// Free hairs of a lock bend like a single hair. The stiffness of hair relative to its weight is a length, b = (E I /
/// (rho g))^(1/3): hair of this length just bends over under its own weight. It does not depend on the lock's
/// thickness; it is 5 cm for human hair (Goldstein, Warren and Ball 2012, "Shape of a Ponytail and the Statistical
/// Physics of Hair Fiber Bundles"), more where locks hold together. So a joint between bones of mean length l has the
/// stiffness rho g b^3 / l against bending; hair shorter than b stands, and longer hair hangs and swings as a pendulum.
/// Each joint is damped at its share, one of said.damping_ratios, of the damping that keeps it from swinging past.
void bake_natural_dynamics(const SaidMotion& said, AssetContents& contents, Findings& findings);

/// Completes the dynamics of `contents`, which holds a skeleton and `said.records` with hit radii, in these models, one
/// per chain. Bones without numbers get those of the preset; all except those that a spring moves keep the modelled
/// shape, unless "dynamics.sags" is set.
void settle_model(const RigRecipe& recipe, const SaidMotion& said, std::span<const ChainModel> models,
                  AssetContents& contents, Findings& findings);

}  // namespace coif::cook
