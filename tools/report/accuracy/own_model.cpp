#include "report/accuracy/own_model.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

constexpr double kStepsPerSecond = 15360;  // the finest setting that reports measure, at 60 frames a second

/// Takes the solver from its last time to `until`.
bool go_on(ChainSolver& solver, const HeadPath& path, double from, double until) {
  const auto steps = long(std::ceil((until - from) * kStepsPerSecond - 1e-6));
  for (long i = 1; i <= steps; ++i) {
    const double time = i < steps ? from + (until - from) * double(i) / double(steps) : until;
    if (!solver.step(path.pose(time), (until - from) / double(steps))) return false;
  }
  return true;
}

ReferenceRun run_finely(const ListedSolver& listed, const Rig& rig, const SolverScene& scene, const HeadPath& path,
                        const std::vector<double>& times) {
  ReferenceRun run;
  run.times = times;
  run.places.assign(times.size() * rig.tips.size(), Eigen::Vector3d::Constant(kNoNumber));
  const auto solver = listed.create(rig, scene, 1);
  solver->reset(path.pose(0));
  double now = 0;
  for (std::size_t sample = 0; sample < times.size(); ++sample) {
    if (!go_on(*solver, path, now, times[sample])) break;
    now = times[sample];
    for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
      run.places[tip * times.size() + sample] = solver->bone_ends()[rig.tips[tip]];
    }
  }
  return run;
}

}  // namespace

std::optional<ReferenceRun> own_model_run(const MeasuredSolver& solver, const Rig& rig, const SolverScene& scene,
                                          const HeadPath& path, const ReferenceRun& reference) {
  if (!solver.has_model) return std::nullopt;
  if (solver.model) {
    return solve_reference(in_model(rig, *solver.model), scene, path,
                           {.sample_times = reference.times, .threads = all_threads()});
  }
  if (solver.is_runtime()) return reference;
  const auto listed = std::ranges::find(historical_solvers(), solver.name, &ListedSolver::name);
  return run_finely(*listed, rig, scene, path, reference.times);
}

}  // namespace coif
