#include "report/accuracy/accuracy_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace coif::report {
namespace {

// Unlike std::max, keeps a NaN: a setting that failed once must not look good.
double worse(double a, double b) { return std::isnan(a) || a > b ? a : b; }

bool moves(const AccuracyRow& row) { return row.motion != "still" && row.motion != "teleport"; }

AccuracyRow& find_or_add(std::vector<AccuracyRow>& means, const AccuracyRow& row) {
  const auto found = std::ranges::find_if(
      means, [&row](const AccuracyRow& m) { return m.solver == row.solver && m.substeps == row.substeps; });
  if (found != means.end()) return *found;
  AccuracyRow& mean = means.emplace_back();
  mean.solver = row.solver;
  mean.fps = row.fps;
  mean.substeps = row.substeps;
  mean.code = row.code;
  mean.fewest_steps = row.fewest_steps;
  mean.shown_first = row.shown_first;
  for (double AccuracyRow::*figure :
       {&AccuracyRow::ns_per_bone_frame, &AccuracyRow::rms_error_pct, &AccuracyRow::own_error_pct,
        &AccuracyRow::model_distance_pct, &AccuracyRow::max_error_pct, &AccuracyRow::worst_second_pct,
        &AccuracyRow::of_motion_pct, &AccuracyRow::stretch_max_pct, &AccuracyRow::penetration_max_pct,
        &AccuracyRow::segment_penetration_max_pct}) {
    mean.*figure = 0;
  }
  return mean;
}

bool beats(const AccuracyRow& a, const AccuracyRow& b) {
  return a.fps == b.fps && a.rms_error_pct <= b.rms_error_pct && a.ns_per_bone_frame <= b.ns_per_bone_frame &&
         (a.rms_error_pct < b.rms_error_pct || a.ns_per_bone_frame < b.ns_per_bone_frame);
}

bool took_longer_with_less(const AccuracyRow& a, const AccuracyRow& b) {
  constexpr double kNoise = 1.05;
  return a.fps == b.fps && a.motion == b.motion && a.solver == b.solver && a.substeps < b.substeps &&
         a.ns_per_bone_frame > kNoise * b.ns_per_bone_frame;
}

}  // namespace

void mark_fronts(std::span<AccuracyRow> rows) {
  for (AccuracyRow& row : rows) {
    row.pareto = std::isfinite(row.rms_error_pct) && std::isfinite(row.ns_per_bone_frame) &&
                 std::ranges::none_of(rows, [&row](const AccuracyRow& other) { return beats(other, row); });
    row.cost_falls =
        std::ranges::any_of(rows, [&row](const AccuracyRow& other) { return took_longer_with_less(other, row); });
  }
}

double main_frame_rate(const AccuracyReport& report) {
  double best = kNoNumber;
  for (const AccuracyRow& row : report.rows) {
    if (!(std::abs(best - 60) <= std::abs(row.fps - 60))) best = row.fps;
  }
  return best;
}

std::vector<AccuracyRow> means_over_motions(const AccuracyReport& report, double fps) {
  std::vector<AccuracyRow> means;
  std::vector<double> counts;
  const bool all_count = std::ranges::none_of(report.rows, moves);
  for (const AccuracyRow& row : report.rows) {
    if (row.fps != fps || !(all_count || moves(row))) continue;
    AccuracyRow& mean = find_or_add(means, row);
    counts.resize(means.size());
    counts[std::size_t(&mean - means.data())] += 1;
    mean.ns_per_bone_frame += row.ns_per_bone_frame;
    mean.rms_error_pct += row.rms_error_pct * row.rms_error_pct;
    mean.own_error_pct += row.own_error_pct * row.own_error_pct;
    mean.model_distance_pct += row.model_distance_pct * row.model_distance_pct;
    mean.max_error_pct = worse(mean.max_error_pct, row.max_error_pct);
    mean.worst_second_pct = worse(mean.worst_second_pct, row.worst_second_pct);
    // Until all are added, the mean square of the motion itself.
    const double moved = row.rms_error_pct / row.of_motion_pct;
    mean.of_motion_pct += moved * moved;
    mean.stretch_max_pct = worse(mean.stretch_max_pct, row.stretch_max_pct);
    mean.penetration_max_pct = worse(mean.penetration_max_pct, row.penetration_max_pct);
    mean.segment_penetration_max_pct = worse(mean.segment_penetration_max_pct, row.segment_penetration_max_pct);
  }
  for (std::size_t i = 0; i < means.size(); ++i) {
    means[i].ns_per_bone_frame /= counts[i];
    means[i].of_motion_pct = std::sqrt(means[i].rms_error_pct / means[i].of_motion_pct);
    for (double AccuracyRow::*square :
         {&AccuracyRow::rms_error_pct, &AccuracyRow::own_error_pct, &AccuracyRow::model_distance_pct}) {
      means[i].*square = std::sqrt(means[i].*square / counts[i]);
    }
  }
  mark_fronts(means);
  return means;
}

std::vector<std::string> averaged_motions(const AccuracyReport& report) {
  std::vector<AccuracyRow> rows;
  std::ranges::copy_if(report.rows, std::back_inserter(rows), moves);
  return names_of(rows.empty() ? report.rows : rows, &AccuracyRow::motion);
}

std::string setting_text(const std::string& solver, std::uint32_t substeps) {
  return substeps == 1 ? solver : fmt::format("{} x{}", solver, substeps);
}

Format against_budget(double budget_pct) {
  // Ten times the budget is not a matter of taste any more.
  constexpr double kFarOver = 10;
  const Format plain("{number}");
  if (!std::isfinite(budget_pct)) return plain;
  return plain.colored({{{"most", budget_pct}, {"look", "good"}},
                        {{"most", kFarOver * budget_pct}, {"look", "warning"}},
                        {{"look", "bad"}}});
}

namespace {

constexpr const char* kRuntimeSolvers[] = {"coif", "thesis"};
constexpr std::size_t kOthersShown = 2;

bool is_runtime(const std::string& solver) {
  return std::ranges::find(kRuntimeSolvers, solver) != std::end(kRuntimeSolvers);
}

/// The runtime's solvers, and those others that are least wrong at the main frame rate with their fewest sub-steps.
std::vector<std::string> solvers_shown(std::vector<AccuracyRow> means) {
  std::erase_if(means, [](const AccuracyRow& mean) { return !mean.fewest_steps || is_runtime(mean.solver); });
  std::ranges::stable_sort(means, {}, [](const AccuracyRow& mean) {
    return std::isfinite(mean.rms_error_pct) ? mean.rms_error_pct : HUGE_VAL;
  });
  means.resize(std::min(means.size(), kOthersShown));
  std::vector<std::string> shown(std::begin(kRuntimeSolvers), std::end(kRuntimeSolvers));
  for (const AccuracyRow& mean : means) shown.push_back(mean.solver);
  return shown;
}

}  // namespace

void choose_shown(AccuracyReport& report) {
  std::map<std::string, std::uint32_t> fewest;
  for (const AccuracyRow& row : report.rows) {
    std::uint32_t& least = fewest.emplace(row.solver, row.substeps).first->second;
    least = std::min(least, row.substeps);
  }
  for (AccuracyRow& row : report.rows) row.fewest_steps = row.substeps == fewest[row.solver];
  const auto shown = solvers_shown(means_over_motions(report, main_frame_rate(report)));
  for (AccuracyRow& row : report.rows) row.shown_first = std::ranges::find(shown, row.solver) != shown.end();
}

}  // namespace coif::report
