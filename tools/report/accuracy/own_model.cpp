#include "report/accuracy/measure_accuracy.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace coif::report {
namespace {

constexpr double kStepsPerSecond = 15360;  // the finest setting that reports measure, at 60 frames a second

/// Takes the solver from its last time to `until`.
bool go_on(lab::ChainSolver& solver, const motion::HeadPath& path, double rate, double from, double until) {
  const auto steps = long(std::ceil((until - from) * rate - 1e-6));
  for (long i = 1; i <= steps; ++i) {
    const double time = i < steps ? from + (until - from) * double(i) / double(steps) : until;
    if (!solver.step(path.pose(time), (until - from) / double(steps))) return false;
  }
  return true;
}

struct OwnMotion {
  const research::ListedSolver& listed;
  const lab::Rig& rig;
  const lab::SolverScene& scene;
  const motion::HeadPath& path;
  const std::vector<double>& times;
};

/// Places of the tips, one sample's after the other's. NaN after the solver has failed.
std::vector<Eigen::Vector3d> places_at(const OwnMotion& motion, double rate) {
  const auto& [listed, rig, scene, path, times] = motion;
  std::vector<Eigen::Vector3d> places(times.size() * rig.tips.size(), Eigen::Vector3d::Constant(kNoNumber));
  const auto solver = listed.create(rig, scene, 1);
  solver->reset(path.pose(0));
  double now = 0;
  for (std::size_t sample = 0; sample < times.size(); ++sample) {
    if (!go_on(*solver, path, rate, now, times[sample])) break;
    now = times[sample];
    for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
      places[tip * times.size() + sample] = solver->bone_ends()[rig.tips[tip]];
    }
  }
  return places;
}

lab::TipAgreement agreement_of(const lab::Rig& rig, std::size_t tip, std::span<const Eigen::Vector3d> fine,
                               std::span<const Eigen::Vector3d> coarse) {
  lab::TipAgreement agreement{.steps_per_second = kStepsPerSecond};
  double sum = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double pct = 100 * (fine[i] - coarse[i]).norm() / rig.tip_length[tip];
    sum += pct * pct;
    if (!(pct <= agreement.max_pct)) agreement.max_pct = pct;
  }
  agreement.rms_pct = fine.empty() ? 0 : std::sqrt(sum / double(fine.size()));
  return agreement;
}

/// Runs twice, like the reference, the second time with steps of double length.
lab::ReferenceRun run_finely(const OwnMotion& motion) {
  std::vector<Eigen::Vector3d> runs[2];
  parallel_for(2, platform::all_threads(),
               [&](std::size_t i) { runs[i] = places_at(motion, kStepsPerSecond / (i == 0 ? 1 : 2)); });
  lab::ReferenceRun run{.times = motion.times, .agreement = {}, .places = std::move(runs[0])};
  for (std::size_t tip = 0; tip < motion.rig.tips.size(); ++tip) {
    const auto coarse = std::span(runs[1]).subspan(tip * run.times.size(), run.times.size());
    run.agreement.push_back(agreement_of(motion.rig, tip, run.path_of_tip(tip), coarse));
  }
  return run;
}

}  // namespace

std::optional<lab::ReferenceRun> own_model_run(const MeasuredSolver& solver, const lab::Rig& rig,
                                               const lab::SolverScene& scene, const motion::HeadPath& path,
                                               const lab::ReferenceRun& reference) {
  if (!solver.has_model) return std::nullopt;
  if (solver.model) {
    return lab::solve_reference(lab::in_model(rig, *solver.model), scene, path,
                                {.sample_times = reference.times, .threads = platform::all_threads()});
  }
  if (solver.is_runtime()) return reference;
  const auto listed = std::ranges::find(research::historical_solvers(), solver.name, &research::ListedSolver::name);
  return run_finely({*listed, rig, scene, path, reference.times});
}

}  // namespace coif::report
