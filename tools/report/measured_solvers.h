#pragma once

#include "report/chain_solver.h"
#include "report/rig_sample.h"
#include "tool_error.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

/// A solver that reports measure: one of the runtime's, or one of historical_solvers().
struct MeasuredSolver {
  std::string_view name;
  std::span<const int> efforts;  ///< Worth measuring: sub-steps or iterations of a frame, ascending.
  bool is_runtime = false;       ///< Ships in games: single precision, bone matrices included in its time.
};

/// The runtime's first.
[[nodiscard]] std::span<const MeasuredSolver> measured_solvers();

/// Null for an unknown name.
[[nodiscard]] const MeasuredSolver* find_measured_solver(std::string_view name);

/// All of them where `names` is empty. Error (kUsage): an unknown name.
[[nodiscard]] tl::expected<std::vector<const MeasuredSolver*>, ToolError> chosen_solvers(
    const std::vector<std::string>& names);

/// A solver at work. Its bone_ends() are in the order of the sample's rig.
struct SolverAtWork {
  std::unique_ptr<ChainSolver> solver;
  std::size_t bones = 0;  ///< That a step moves: the runtime's solvers always move the whole asset.
};

/// `asset`, whose part `sample` is, must outlive the result.
[[nodiscard]] SolverAtWork make_solver(const MeasuredSolver& measured, const Asset& asset, const RigSample& sample,
                                       const SolverScene& scene, int effort);

}  // namespace coif
