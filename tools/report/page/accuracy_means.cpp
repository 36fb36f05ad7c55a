#include "report/page/accuracy_means.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

// Unlike std::max, keeps a NaN: what failed once must not look good.
double worse(double a, double b) { return std::isnan(a) || a > b ? a : b; }

std::vector<std::string> distinct(const std::vector<AccuracyRow>& rows, std::string AccuracyRow::*name) {
  std::vector<std::string> names;
  for (const AccuracyRow& row : rows) {
    if (std::ranges::find(names, row.*name) == names.end()) names.push_back(row.*name);
  }
  return names;
}

SettingMean& find_or_add(std::vector<SettingMean>& means, const AccuracyRow& row) {
  const auto found = std::ranges::find_if(
      means, [&row](const SettingMean& m) { return m.solver == row.solver && m.substeps == row.substeps; });
  if (found != means.end()) return *found;
  means.emplace_back();
  means.back().solver = row.solver;
  means.back().substeps = row.substeps;
  return means.back();
}

bool is_better(const SettingMean& a, const SettingMean& b) {
  return a.rms_error_pct <= b.rms_error_pct && a.ns_per_bone_frame <= b.ns_per_bone_frame &&
         (a.rms_error_pct < b.rms_error_pct || a.ns_per_bone_frame < b.ns_per_bone_frame);
}

void mark_front(std::vector<SettingMean>& means) {
  for (SettingMean& mean : means) {
    mean.pareto = std::isfinite(mean.rms_error_pct) && std::isfinite(mean.ns_per_bone_frame) &&
                  std::ranges::none_of(means, [&mean](const SettingMean& other) { return is_better(other, mean); });
  }
}

}  // namespace

double main_frame_rate(const AccuracyReport& report) {
  double best = kNoNumber;
  for (const AccuracyRow& row : report.rows) {
    if (!(std::abs(best - 60) <= std::abs(row.fps - 60))) best = row.fps;
  }
  return best;
}

std::vector<SettingMean> means_over_motions(const AccuracyReport& report, double fps) {
  std::vector<SettingMean> means;
  std::vector<double> counts;
  for (const AccuracyRow& row : report.rows) {
    if (row.fps != fps) continue;
    SettingMean& mean = find_or_add(means, row);
    counts.resize(means.size());
    counts[std::size_t(&mean - means.data())] += 1;
    mean.ns_per_bone_frame += row.ns_per_bone_frame;
    mean.rms_error_pct += row.rms_error_pct * row.rms_error_pct;
    mean.max_error_pct = worse(mean.max_error_pct, row.max_error_pct);
    mean.stretch_max_pct = worse(mean.stretch_max_pct, row.stretch_max_pct);
    mean.penetration_max_pct = worse(mean.penetration_max_pct, row.penetration_max_pct);
    mean.segment_penetration_max_pct = worse(mean.segment_penetration_max_pct, row.segment_penetration_max_pct);
  }
  for (std::size_t i = 0; i < means.size(); ++i) {
    means[i].ns_per_bone_frame /= counts[i];
    means[i].rms_error_pct = std::sqrt(means[i].rms_error_pct / counts[i]);
  }
  mark_front(means);
  return means;
}

std::vector<std::string> solvers_of(const AccuracyReport& report) {
  return distinct(report.rows, &AccuracyRow::solver);
}

std::vector<std::string> motions_of(const AccuracyReport& report) {
  return distinct(report.rows, &AccuracyRow::motion);
}

std::string setting_text(const std::string& solver, std::uint32_t substeps) {
  return substeps == 1 ? solver : fmt::format("{} x{}", solver, substeps);
}

}  // namespace coif
