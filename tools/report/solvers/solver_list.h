#pragma once

#include "report/chain_solver.h"
#include "report/rig.h"

#include <string_view>

namespace coif {

/// A way to move hair that a report can measure.
struct ListedSolver {
  std::string_view name;         ///< As the command line and reports have it.
  std::string_view description;  ///< One line.
  std::string_view source;       ///< Paper, and section of the thesis.
  std::string_view effort_unit;  ///< What the number `effort` counts.
  std::span<const int> efforts;  ///< Worth measuring, ascending.
  /// `effort` > 0. The solver has to be reset() before its first step.
  std::unique_ptr<ChainSolver> (*create)(const Rig& rig, const SolverScene& scene, int effort);
};

/// What came before and what others do, in the order of the thesis and then of the years. None of them knows torsion or
/// angle limits, and their colliders push particles, not segments. `tridiagonal` takes RigBone::resistance as a weight
/// per step and the thesis's own attempts as a constant pull; all others the model's stiffness and damping.
[[nodiscard]] std::span<const ListedSolver> historical_solvers();

}  // namespace coif
