#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/recipe.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <functional>
#include <string>
#include <vector>

namespace coif {

/// What was done so that every chain's equation has a solution to converge to.
struct ConditionedChains {
  std::vector<DynamicsRecord> dynamics;  ///< One per bone.
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// Checks that the model (runtime/docs/MODEL.md, "Well-posed or not") is one for every chain: over motions of the suite two
/// computations of the reference, one with half the other's step, differ by at most 0.1 % of the chain's length (RMS), and
/// 240 steps a second of the runtime follow it within 5 %. Where they do not, damping and friction are raised and
/// `parent_share` lowered, as little as it takes; the note names the chain. A chain that nothing helps keeps the last try
/// and is warned of.
///
/// Of chains with equally many bones the softest and the longest are computed, and the others treated as they are.
/// `contents` holds skeleton, dynamics and colliders. The result does not depend on `threads`.
[[nodiscard]] ConditionedChains condition_chains(const AssetContents& contents, unsigned threads);

/// Which bones carry a twist from step to step, and what the others save.
struct ChosenTwist {
  std::vector<DynamicsRecord> dynamics;  ///< One per bone: the torsion is as it was, or kShortestArc.
  std::vector<std::string> notes;        ///< Which chains keep it, and why.
  std::vector<LeftOut> left_out;         ///< None or one.
};

/// A frame that is the shortest arc from the parent's needs no memory, but it flips where a bone folds back over its parent
/// (runtime/docs/MODEL.md, "Frames and twist"). Runs the motions of the suite and looks how far the bones of each chain
/// bend from their default direction by the parent: chains that stay below 120 degrees do without a twist. What cannot bend
/// so far, for its angle limit, is not run. `contents` holds skeleton, dynamics and colliders; the result does not depend on
/// `threads`.
[[nodiscard]] ChosenTwist choose_twist(const AssetContents& contents, unsigned threads);

/// How to simulate an asset, and what that was chosen from. Empty where nothing moves.
struct TunedSolver {
  std::vector<TuningRecord> tuning;    ///< None or one.
  std::vector<QualityRecord> quality;  ///< One for each frame rate and number of sub-steps that was measured.
  std::vector<std::string> notes;
};

/// Nominal nanoseconds per head and frame of so many simulated bones without twist, with a step in so many parts: a fixed figure, so that
/// cooking again gives the same bytes.
[[nodiscard]] double nominal_cost(std::size_t bones, std::uint32_t parts);
/// What a twist adds to that for each bone that carries one.
[[nodiscard]] double nominal_twist_cost(std::size_t bones, std::uint32_t parts);

/// Finds the fewest sub-steps with which the runtime keeps the recipe's "budget" at all its frame rates, by running it
/// through the motions of the suite beside the converged reference. Of many chains the telling ones are run
/// (chain_groups.h). Costs are nominal, so the result repeats; it does not depend on `threads`. kOverBudget, with what is
/// missing, where nothing meets it. A recipe that asks for nothing gets 0.7 % if that can be had, else the best; one that
/// asks for a cost alone gets what of that it buys. `contents` holds skeleton, dynamics and colliders.
[[nodiscard]] tl::expected<TunedSolver, ToolError> tune_solver(const AssetContents& contents, const Recipe& recipe,
                                                               unsigned threads);

}  // namespace coif
