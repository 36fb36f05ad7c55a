#pragma once

#include "base/tool_error.h"
#include "lab/rig.h"
#include "lab/runtime_solver.h"
#include "research/solvers/historical_solvers.h"

#include <coif/asset.h>

#include <tl/expected.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coif::report {

/// A solver that reports measure: one of the runtime's, or one of research::historical_solvers().
struct MeasuredSolver {
  std::string_view name;
  std::span<const int> efforts;  ///< Worth measuring: sub-steps or iterations of a frame, ascending.
  /// Ships in games: single precision, bone matrices included in its time. Null: one of research::historical_solvers().
  const Solver* runtime = nullptr;
  std::optional<ChainModel> model{};  ///< Moves all chains by this, whatever they are meant for.
  bool has_model = true;              ///< As in ListedSolver; false for Algorithm 1.

  [[nodiscard]] bool is_runtime() const { return runtime != nullptr; }
};

/// The runtime's first.
[[nodiscard]] std::span<const MeasuredSolver> measured_solvers();

/// `coif` for cases with moving colliders: kCharacterSolver, which without them gives the same bits.
[[nodiscard]] const MeasuredSolver& solver_on_a_character();

/// Names that AccuracySettings::solvers and StabilitySettings::solvers take, in the order of the report.
[[nodiscard]] std::vector<std::string> report_solvers();

/// Null for an unknown name.
[[nodiscard]] const MeasuredSolver* find_measured_solver(std::string_view name);

/// An empty `names` chooses all that move chains by their own model. Error (kUsage): an unknown name.
[[nodiscard]] tl::expected<std::vector<const MeasuredSolver*>, ToolError> chosen_solvers(
    const std::vector<std::string>& names);

/// A solver at work. Its bone_ends() are in the order of the sample's rig.
struct SolverAtWork {
  std::unique_ptr<lab::ChainSolver> solver;
  std::size_t bones = 0;  ///< Bones that a step moves: the runtime's solvers always move the whole asset.
};

/// `asset`, of which `sample` is a part, must outlive the result.
[[nodiscard]] SolverAtWork make_solver(const MeasuredSolver& measured, const Asset& asset, const lab::RigSample& sample,
                                       const lab::SolverScene& scene, int effort);

}  // namespace coif::report
