#include "report/page/accuracy_tables.h"

#include "report/page/accuracy_means.h"
#include "report/page/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif {
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
