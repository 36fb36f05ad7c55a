// Links from an accuracy report to the page of `coif view`, which shows the motions behind the figures.

#include "motion/head_path.h"
#include "report/accuracy/accuracy_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace coif::report {
namespace {

// The solvers of the reports that the page has too.
constexpr std::array<std::string_view, 4> kViewSolvers{"coif", "thesis", "cascade", "passive"};
constexpr double kSlowestView = 15, kFastestView = 240;  // steps a second

/// Chooses the first two of the measured ones.
void choose_solvers(const AccuracyReport& report, ViewLink& link) {
  const auto measured = names_of(report.rows, &AccuracyRow::solver);
  for (const std::string_view solver : kViewSolvers) {
    if (std::ranges::find(measured, solver) == measured.end()) continue;
    if (!link.solver.empty()) {
      link.beside = solver;
      return;
    }
    link.solver = solver;
  }
}

ViewLink link_at(const AccuracyReport& report, const std::string& motion, double fps) {
  ViewLink link;
  if (motion::find_motion(motion)) link.motion = motion;
  if (fps >= kSlowestView && fps <= kFastestView) link.rate = fps;
  choose_solvers(report, link);
  return link;
}

}  // namespace

ViewLink accuracy_link(const AccuracyReport& report) {
  for (const std::string& motion : names_of(report.rows, &AccuracyRow::motion)) {
    if (motion != "still" && motion::find_motion(motion)) return link_at(report, motion, main_frame_rate(report));
  }
  return link_at(report, "", main_frame_rate(report));
}

nlohmann::ordered_json motion_links(const ReportHeading& heading, const AccuracyReport& report) {
  auto links = nlohmann::ordered_json::array();
  if (heading.view.empty()) return links;
  std::set<std::pair<std::string, double>> shown;
  for (const AccuracyRow& row : report.rows) {
    if (motion::find_motion(row.motion) && row.fps >= kSlowestView && row.fps <= kFastestView) {
      shown.insert({row.motion, row.fps});
    }
  }
  for (const auto& [motion, fps] : shown) {
    const std::string url = view_url(heading.view, link_at(report, motion, fps));
    links.push_back({{"motion", motion}, {"text", fmt::format("{:g}", fps)}, {"url", url}});
  }
  return links;
}

}  // namespace coif::report
