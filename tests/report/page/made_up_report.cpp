#include "report/page/made_up_report.h"

namespace coif {
namespace {

struct MadeUpSolver {
  const char* name;
  double error_pct, ns, stretch_pct;
};

constexpr MadeUpSolver kSolvers[] = {{"coif", 1, 30, 0}, {"thesis", 30, 25, 60}, {"slow", 2, 300, 0.2}};
constexpr const char* kMotions[] = {"nod", "turn"};

AccuracyRow made_up_row(const char* motion, const MadeUpSolver& solver, double fps, std::uint32_t substeps) {
  AccuracyRow row;
  row.motion = motion;
  row.solver = solver.name;
  row.fps = fps;
  row.substeps = substeps;
  row.ns_per_bone_frame = solver.ns * substeps;
  row.rms_error_pct = solver.error_pct / substeps * 60 / fps;
  row.max_error_pct = 4 * row.rms_error_pct;
  row.stretch_max_pct = solver.stretch_pct * 60 / fps;
  row.penetration_max_pct = 0.5;
  row.segment_penetration_max_pct = 0.75;
  return row;
}

}  // namespace

ReportHeading made_up_heading() {
  ReportHeading heading;
  heading.asset = "bob <b>.coif";
  heading.bones = 12;
  heading.simulated_bones = 10;
  heading.chains = 2;
  heading.shortest_chain = 0.125;
  heading.median_chain = 0.25;
  heading.longest_chain = 0.5;
  heading.machine = "processor, 2 cores";
  heading.seconds_taken = 3.25;
  return heading;
}

AccuracyReport made_up_accuracy() {
  AccuracyReport report;
  for (const char* motion : kMotions) {
    for (const MadeUpSolver& solver : kSolvers) {
      for (const double fps : {30.0, 60.0, 120.0}) {
        for (const std::uint32_t substeps : {1u, 4u}) {
          report.rows.push_back(made_up_row(motion, solver, fps, substeps));
        }
      }
      report.spread.push_back({motion, solver.name, 1, 2 * solver.error_pct});
    }
    report.reference.push_back({motion, 0.25, 48000});
  }
  for (const MadeUpSolver& solver : kSolvers) report.settle.push_back({solver.name, solver.error_pct / 10});
  report.chosen = ChosenSolver{"coif", 1, 1, 30};
  report.budget_rms_pct = 2;
  return report;
}

StabilityReport made_up_stability() {
  StabilityReport report;
  report.stress_cases = {{"turn_10fps", "head shaken at 10 frames per second"}, {"nan_pose", "a pose of NaN"}};
  report.rows = {{"turn_10fps", "coif", Outcome::kOk, 0, 0, 12, 0.5},
                 {"turn_10fps", "thesis", Outcome::kOk, 132, 7, 40, 3},
                 {"turn_10fps", "slow", Outcome::kDiverged, 4.0e9, 100, 1.0e12, kNoNumber},
                 {"nan_pose", "coif", Outcome::kOk, 0.25, 0, 1, 0.75},
                 {"nan_pose", "thesis", Outcome::kRejected, kNoNumber, kNoNumber, kNoNumber, kNoNumber},
                 {"nan_pose", "slow", Outcome::kNan, kNoNumber, kNoNumber, kNoNumber, kNoNumber}};
  return report;
}

}  // namespace coif
