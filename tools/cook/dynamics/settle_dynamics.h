#pragma once

#include "base/tool_error.h"
#include "cook/dynamics/choose_model.h"
#include "cook/recipe/findings.h"
#include "platform/stop.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <span>
#include <vector>

namespace coif::cook {

struct RigRecipe;

// The passes below run a rig through the motions of the suite as a game would. `contents` holds skeleton, dynamics and
// colliders, and opens as an asset; results do not depend on `threads`.

/// False for a rig without chains, and for one with numbers that no asset may hold.
[[nodiscard]] bool can_be_run(const AssetContents& contents);

/// Makes the model (runtime/docs/MODEL.md, "Well-posed or not") one for chains that have no one motion: damping and
/// friction are raised and `parent_share` lowered. Of the first few of the candidates that help, ordered by how much
/// they do, it is the one whose motion is nearest to what was asked for; which is that of Algorithm 1 where that has
/// none. A note names the chain and the difference. A chain that nothing helps keeps the last candidate and is warned
/// of. Returns the dynamics, one per bone.
///
/// Of chains alike the softest and the longest are computed, and the others treated as they are.
[[nodiscard]] std::vector<DynamicsRecord> condition_chains(const AssetContents& contents,
                                                           std::span<const IllPosedChains> ill_posed,
                                                           const platform::Threads& threads, Findings& findings);

/// What conditioning may change, of bones as they were before it: for AssetContents::asked.
[[nodiscard]] std::vector<AskedRecord> asked_of(std::span<const DynamicsRecord> dynamics);

/// A frame that is the shortest arc from the parent's needs no memory, but it flips where a bone folds back over its
/// parent (runtime/docs/MODEL.md, "Frames and twist"). Looks how far the bones of each chain bend from their default
/// direction by the parent: chains that stay below 120 degrees do without a twist, which is left out. What cannot bend
/// so far, for its angle limit, is not run. Returns the dynamics: torsions are as they were, or kShortestArc. Notes
/// which chains keep theirs.
[[nodiscard]] std::vector<DynamicsRecord> choose_twist(const AssetContents& contents, const platform::Threads& threads,
                                                       Findings& findings);

/// How to simulate an asset, and what that was chosen from. Empty where nothing moves.
struct TunedSolver {
  std::vector<TuningRecord> tuning;       ///< None or one.
  std::vector<QualityRecord> quality;     ///< One for each frame rate and number of sub-steps that was measured.
  std::vector<MotionNameRecord> motions;  ///< What their worst_motion is an index into.
};

/// Finds the fewest sub-steps with which the runtime keeps the recipe's "budget" at all its frame rates, by running it
/// through the motions of the suite beside the converged reference. Of many chains the telling ones are run
/// (chain_groups.h). Costs are nominal, so the result repeats. kOverBudget, with what is missing, where nothing meets
/// it. A recipe that asks for nothing gets 0.7 % if that can be had, else the best; one that asks for a cost alone gets
/// what of that it buys.
[[nodiscard]] tl::expected<TunedSolver, ToolError> tune_solver(const AssetContents& contents, const RigRecipe& recipe,
                                                               const platform::Threads& threads, Findings& findings);

}  // namespace coif::cook
