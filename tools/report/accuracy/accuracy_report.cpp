#include "report/accuracy/accuracy_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace coif {
namespace {

// Unlike std::max, keeps a NaN: what failed once must not look good.
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

CellFormat against_budget(double budget_pct) {
  return [budget_pct](double error_pct) {
    // Ten times the budget is not a matter of taste any more.
    constexpr double kFarOver = 10;
    CellLook look = CellLook::kPlain;
    if (std::isfinite(budget_pct)) {
      look = error_pct <= budget_pct              ? CellLook::kGood
             : error_pct <= kFarOver * budget_pct ? CellLook::kWarning
                                                  : CellLook::kBad;
    }
    return Cell{number_text(error_pct), look};
  };
}

}  // namespace coif
