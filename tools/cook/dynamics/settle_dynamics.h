#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/recipe.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <vector>

namespace coif {

// The passes below run a rig through the motions of the suite as a game would. `contents` holds skeleton, dynamics and
// colliders, and opens as an asset; results do not depend on `threads`.

/// False for a rig without chains, and for one with numbers that no asset may hold.
[[nodiscard]] bool can_be_run(const AssetContents& contents);

/// Whether hair that was meant for the cascade (`cascade`) swings as it was asked to only in the passive model (`passive`: the same
/// hair there): some chain has no motion that could be computed twice as a cascade, so that it would have to be damped, and each
/// such chain has one in the passive model, without. Not where that would be so stiff that nothing could check it. A note says
/// why. Both as condition_chains() has its contents.
[[nodiscard]] bool needs_passive_model(const AssetContents& cascade, const AssetContents& passive, unsigned threads,
                                       Findings& findings);

/// Checks that the model (runtime/docs/MODEL.md, "Well-posed or not") is one for every chain: over motions of the suite two
/// computations of the reference, one with half the other's step, differ by at most 0.1 % of the chain's length (RMS), and
/// 240 steps a second of the runtime follow it within 5 %. Where they do not, damping and friction are raised and
/// `parent_share` lowered: of the first few of the candidates that help, ordered by how much they do, the one whose motion is
/// nearest to what was asked for; which is that of Algorithm 1 where that has none. A note names the chain and the difference. A
/// chain that nothing helps keeps the last candidate and is warned of. Returns the dynamics, one per bone.
///
/// Of chains with equally many bones the softest and the longest are computed, and the others treated as they are.
[[nodiscard]] std::vector<DynamicsRecord> condition_chains(const AssetContents& contents, unsigned threads,
                                                           Findings& findings);

/// A frame that is the shortest arc from the parent's needs no memory, but it flips where a bone folds back over its parent
/// (runtime/docs/MODEL.md, "Frames and twist"). Looks how far the bones of each chain bend from their default direction by
/// the parent: chains that stay below 120 degrees do without a twist, which is left out. What cannot bend so far, for its
/// angle limit, is not run. Returns the dynamics: torsions are as they were, or kShortestArc. Notes which chains keep theirs.
[[nodiscard]] std::vector<DynamicsRecord> choose_twist(const AssetContents& contents, unsigned threads,
                                                       Findings& findings);

/// How to simulate an asset, and what that was chosen from. Empty where nothing moves.
struct TunedSolver {
  std::vector<TuningRecord> tuning;    ///< None or one.
  std::vector<QualityRecord> quality;  ///< One for each frame rate and number of sub-steps that was measured.
};

/// Finds the fewest sub-steps with which the runtime keeps the recipe's "budget" at all its frame rates, by running it
/// through the motions of the suite beside the converged reference. Of many chains the telling ones are run
/// (chain_groups.h). Costs are nominal, so the result repeats. kOverBudget, with what is missing, where nothing meets it. A
/// recipe that asks for nothing gets 0.7 % if that can be had, else the best; one that asks for a cost alone gets what of
/// that it buys.
[[nodiscard]] tl::expected<TunedSolver, ToolError> tune_solver(const AssetContents& contents, const Recipe& recipe,
                                                               unsigned threads, Findings& findings);

}  // namespace coif
