#include "report/page/cost_text.h"

#include "report/page/cost_rows.h"
#include "report/page/cost_summary.h"
#include "report/page/drawing_text.h"
#include "report/page/number_text.h"
#include "report/page/report_frame.h"

#include <fmt/format.h>

namespace coif {
namespace {

std::string simulation_text(const CostReport& report) {
  if (report.simulation.empty()) return "";
  std::string text = fmt::format("  {:<8}{:>6}{:>8}{:>14}{:>12}{:>12}{:>9}\n", "solver", "steps", "heads", "us/frame",
                                 "us/head", "ns/bone", "spread");
  for (const SimulationCostRow& row : report.simulation) {
    text += fmt::format("  {:<8}{:>6}{:>8}{:>14}{:>12}{:>12}{:>7} %\n", row.solver, row.substeps, row.heads,
                        number_text(row.us_per_frame), number_text(row.us_per_frame / row.heads),
                        number_text(row.ns_per_bone_frame), number_text(row.spread_pct));
  }
  text += fmt::format("  features, {} heads\n", report.features.front().heads);
  for (const FeatureCostRow& row : report.features) {
    text += fmt::format("  {:<22}{:>14}{:>12}{:>+11.0f} %{:>7} %\n", row.feature, number_text(row.us_per_frame),
                        number_text(row.us_per_frame / row.heads), row.change_pct, number_text(row.spread_pct));
  }
  return text;
}

}  // namespace

std::string cost_text(const ReportHeading& heading, const CostReport& report) {
  std::string text = heading_text(heading) + "\n" + simulation_text(report) + drawing_text(report.rendering);
  std::vector<std::string> subjects = solvers_of(report);
  subjects.insert(subjects.end(), {kDrawnCrowd, kDistances, kThesisTable});
  for (const std::string& subject : subjects) {
    const std::string left_out = left_out_text(report, subject);
    if (!left_out.empty()) text += "  " + left_out + "\n";
  }
  return text + cost_summary(report) + "\n";
}

}  // namespace coif
