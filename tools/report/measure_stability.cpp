#include "report/measure_stability.h"

#include "report/stress_run.h"

#include <fmt/format.h>

namespace coif {
namespace {

constexpr std::size_t kMostBones = 64;  ///< Of the asset: what breaks, breaks on any of its chains.

void measure(const Stress& stress, const Asset& asset, std::size_t most_bones,
             std::span<const MeasuredSolver* const> solvers, const ReportProgress& progress, StabilityReport& report) {
  const StressSubject subject(stress, asset, sample_of(rig_of(asset), most_bones));
  for (const MeasuredSolver* solver : solvers) {
    if (progress) progress(fmt::format("{}, {}", stress.about.name, solver->name));
    report.rows.push_back(subject.run(*solver));
  }
}

/// A rig that the format refuses never reaches a solver.
void refuse(const Stress& stress, std::span<const MeasuredSolver* const> solvers, StabilityReport& report) {
  for (const MeasuredSolver* solver : solvers) {
    StabilityRow row{.stress_case = stress.about.name, .solver = std::string(solver->name)};
    row.outcome = Outcome::kRejected;
    report.rows.push_back(std::move(row));
  }
}

}  // namespace

tl::expected<StabilityReport, ToolError> measure_stability(const Asset& asset, const StabilitySettings& settings,
                                                           const ReportProgress& progress) {
  const auto solvers = chosen_solvers(settings.solvers);
  if (!solvers) return tl::unexpected(solvers.error());
  if (asset.skeleton().simulated_count == 0 || asset.dynamics().empty()) {
    return tl::unexpected(ToolError{ToolError::Kind::kBadInput, "no simulated bones: there is nothing to measure"});
  }
  StabilityReport report;
  for (const Stress& stress : stress_cases()) {
    report.stress_cases.push_back(stress.about);
    if (!stress.rig) {
      measure(stress, asset, kMostBones, *solvers, progress, report);
      continue;
    }
    const StressAsset made(*stress.rig);
    if (made.is_open()) {
      measure(stress, made.asset(), kMaxBones, *solvers, progress, report);
    } else {
      refuse(stress, *solvers, report);
    }
  }
  return report;
}

}  // namespace coif
