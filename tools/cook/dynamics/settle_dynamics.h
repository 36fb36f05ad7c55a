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

/// Makes the motion well-defined (runtime/docs/MODEL.md, "Well-posed or not") for chains for which it is not: raises
/// damping and friction and lowers `parent_share`. Among the first few good candidates, which are ordered by their
/// strength, it takes the one whose motion is nearest to the artist's, or to Algorithm 1's where that is not
/// well-defined. A note names the chain and the difference. A chain that no candidate helps gets the last one and a
/// warning. Returns the dynamics, one per bone.
///
/// Among similar chains the softest and the longest are computed, and the others get the same treatment.
[[nodiscard]] std::vector<DynamicsRecord> condition_chains(const AssetContents& contents,
                                                           std::span<const IllPosedChains> ill_posed,
                                                           const platform::Threads& threads, Findings& findings);

/// The values that conditioning may change, from the bones before it: for AssetContents::asked.
[[nodiscard]] std::vector<AskedRecord> asked_of(std::span<const DynamicsRecord> dynamics);

/// Decides which chains need a twist. A frame that is the shortest arc from the parent's needs no memory, but it flips
/// where a bone folds back over its parent (runtime/docs/MODEL.md, "Frames and twist"). Measures how far the bones of
/// each chain bend from their parent's default direction: chains that stay below 120 degrees need no twist. Chains
/// whose angle limit keeps them below are not run. Returns the dynamics, with torsions as before or kShortestArc. Notes
/// which chains keep theirs.
[[nodiscard]] std::vector<DynamicsRecord> choose_twist(const AssetContents& contents, const platform::Threads& threads,
                                                       Findings& findings);

/// How to simulate an asset, and the measurements behind it. Empty where nothing moves.
struct TunedSolver {
  std::vector<TuningRecord> tuning;       ///< None or one.
  std::vector<QualityRecord> quality;     ///< One for each measured frame rate and number of sub-steps.
  std::vector<MotionNameRecord> motions;  ///< The list that their worst_motion is an index into.
};

/// Finds the fewest sub-steps with which the runtime keeps the recipe's "budget" at all its frame rates: runs it
/// through the motions of the suite beside the converged reference. Of many chains the telling ones are run
/// (chain_groups.h). Costs are nominal, so the result repeats. kOverBudget, with the missing amount, where nothing
/// meets the budget. A recipe without a budget gets 0.7 % if possible, else the best; one with only a cost gets the
/// smallest error for that cost.
[[nodiscard]] tl::expected<TunedSolver, ToolError> tune_solver(const AssetContents& contents, const RigRecipe& recipe,
                                                               const platform::Threads& threads, Findings& findings);

}  // namespace coif::cook
