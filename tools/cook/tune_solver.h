#pragma once

#include "cook/recipe.h"
#include "tool_error.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace coif {

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
