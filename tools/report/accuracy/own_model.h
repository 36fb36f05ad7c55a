#pragma once

#include "lab/reference_solver.h"
#include "motion/head_path.h"
#include "report/solvers/measured_solvers.h"

#include <optional>

namespace coif::report {

/// Where a solver would come to with ever finer steps: the motion of its own model, which need not be the asset's. Of
/// the runtime's it is the reference of that model; of research::historical_solvers() the solver itself, with 15360
/// steps a second, on the head's own way, and again with half as many: how far the two are apart is the run's
/// agreement. Samples as in `reference`, which is the asset's and what a solver without a model of its own choosing
/// comes to. Empty where finer steps come to nothing (research::ListedSolver::has_model).
[[nodiscard]] std::optional<lab::ReferenceRun> own_model_run(const MeasuredSolver& solver, const lab::Rig& rig,
                                                             const lab::SolverScene& scene,
                                                             const motion::HeadPath& path,
                                                             const lab::ReferenceRun& reference);

}  // namespace coif::report
