#include "base/json.h"
#include "report/accuracy/show_accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

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

namespace {

constexpr auto kNumbers = Column::Kind::kNumbers;

// Ten times the budget is not a matter of taste any more.
constexpr double kFarOver = 10;

CellLook look_of(double error_pct, double budget_pct) {
  if (!std::isfinite(budget_pct)) return CellLook::kPlain;
  if (error_pct <= budget_pct) return CellLook::kGood;
  return error_pct <= kFarOver * budget_pct ? CellLook::kWarning : CellLook::kBad;
}

Cell error_cell(double error_pct, double budget_pct) {
  return {number_text(error_pct), look_of(error_pct, budget_pct)};
}

Cell front_cell(bool pareto) { return {pareto ? "front" : ""}; }

void add_figure_columns(Table& table) {
  for (const char* title : {"ns/bone", "RMS error %", "max error %", "stretch %", "penetration %", "between ends %"}) {
    table.columns.push_back({title, kNumbers});
  }
  table.columns.push_back({"Pareto"});
}

/// Of an AccuracyRow or a SettingMean, in the order of add_figure_columns().
template <typename Figures>
void add_figures(const Figures& figures, double budget_pct, std::vector<Cell>& cells) {
  cells.push_back({number_text(figures.ns_per_bone_frame)});
  cells.push_back(error_cell(figures.rms_error_pct, budget_pct));
  for (const double pct : {figures.max_error_pct, figures.stretch_max_pct, figures.penetration_max_pct,
                           figures.segment_penetration_max_pct}) {
    cells.push_back({number_text(pct)});
  }
  cells.push_back(front_cell(figures.pareto));
}

}  // namespace

Table settings_table(const AccuracyReport& report) {
  Table table;
  table.columns = {{"solver"}, {"steps", kNumbers}};
  add_figure_columns(table);
  for (const SettingMean& mean : means_over_motions(report, main_frame_rate(report))) {
    table.rows.push_back({{mean.solver}, {std::to_string(mean.substeps)}});
    add_figures(mean, report.budget_rms_pct, table.rows.back());
  }
  return table;
}

Table spread_table(const AccuracyReport& report) {
  Table table;
  table.columns = {{"solver"}};
  std::vector<std::string> motions, settings;
  for (const SpreadRow& row : report.spread) {
    const std::string setting = setting_text(row.solver, row.substeps);
    if (std::ranges::find(motions, row.motion) == motions.end()) {
      motions.push_back(row.motion);
      table.columns.push_back({row.motion, kNumbers});
    }
    if (std::ranges::find(settings, setting) == settings.end()) {
      settings.push_back(setting);
      table.rows.push_back({{setting}});
    }
    const auto column = std::size_t(std::ranges::find(motions, row.motion) - motions.begin()) + 1;
    auto& cells = table.rows[std::size_t(std::ranges::find(settings, setting) - settings.begin())];
    if (cells.size() <= column) cells.resize(column + 1, {"-"});
    cells[column] = error_cell(row.frame_rate_spread_pct, report.budget_rms_pct);
  }
  return table;
}

Table reference_table(const AccuracyReport& report) {
  Table table{{{"motion"}, {"self-difference %", kNumbers}, {"steps per second", kNumbers}}, {}};
  for (const ReferenceRow& row : report.reference) {
    table.rows.push_back({{row.motion},
                          error_cell(row.self_difference_pct, report.budget_rms_pct),
                          {number_text(row.steps_per_second)}});
  }
  return table;
}

Table settle_table(const AccuracyReport& report) {
  Table table{{{"solver"}, {"distance to the exact rest %", kNumbers}}, {}};
  for (const SettleRow& row : report.settle) {
    table.rows.push_back({{row.solver}, error_cell(row.settle_error_pct, report.budget_rms_pct)});
  }
  return table;
}

Table rows_table(const AccuracyReport& report) {
  Table table;
  table.columns = {{"motion"}, {"solver"}, {"fps", kNumbers}, {"steps", kNumbers}};
  add_figure_columns(table);
  for (const AccuracyRow& row : report.rows) {
    table.rows.push_back({{row.motion}, {row.solver}, {fmt::format("{}", row.fps)}, {std::to_string(row.substeps)}});
    add_figures(row, report.budget_rms_pct, table.rows.back());
  }
  return table;
}

}  // namespace coif
