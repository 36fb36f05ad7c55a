#include "report/page/stability_page.h"

#include "report/page/html_page.h"
#include "report/page/number_text.h"
#include "report/page/report_frame.h"
#include "report/page/stability_totals.h"

#include <cmath>

namespace coif {
namespace {

constexpr auto kNumbers = Column::Kind::kNumbers;

CellLook look_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kOk: return CellLook::kGood;
    case Outcome::kRejected: return CellLook::kNeutral;
    case Outcome::kDiverged: return CellLook::kWarning;
    case Outcome::kNan: return CellLook::kBad;
  }
  return CellLook::kPlain;
}

Table totals_table(const StabilityReport& report) {
  Table table;
  table.columns = {{"solver"}};
  for (const Outcome outcome : kOutcomes) table.columns.push_back({name_of(outcome), kNumbers});
  for (const char* title : {"worst stretch", "worst penetration", "worst settle error"}) {
    table.columns.push_back({title, kNumbers});
  }
  for (const StabilityTotal& total : stability_totals(report)) {
    std::vector<Cell> cells{{total.solver}};
    for (std::size_t i = 0; i < kOutcomes.size(); ++i) {
      const bool counts = total.count[i] > 0;
      cells.push_back({std::to_string(total.count[i]), counts ? look_of(kOutcomes[i]) : CellLook::kPlain});
    }
    for (const double worst : {total.stretch_max_pct, total.penetration_max_pct, total.settle_error_pct}) {
      cells.push_back({percent_text(worst)});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table legend_table() {
  Table table{{{"outcome"}, {"the solver ..."}}, {}};
  for (const Outcome outcome : kOutcomes) {
    table.rows.push_back({{name_of(outcome), look_of(outcome)}, {describe(outcome)}});
  }
  return table;
}

Cell outcome_cell(const StabilityRow& row) {
  std::string text = name_of(row.outcome);
  if (std::isfinite(row.stretch_max_pct)) text += "\nstretch " + percent_text(row.stretch_max_pct);
  if (std::isfinite(row.penetration_max_pct)) text += "\ninside " + percent_text(row.penetration_max_pct);
  return {text, look_of(row.outcome)};
}

const StabilityRow* find(const StabilityReport& report, const std::string& stress_case, const std::string& solver) {
  for (const StabilityRow& row : report.rows) {
    if (row.stress_case == stress_case && row.solver == solver) return &row;
  }
  return nullptr;
}

Table cases_table(const StabilityReport& report) {
  const std::vector<StabilityTotal> totals = stability_totals(report);
  Table table;
  table.columns = {{"case"}, {"what happens", Column::Kind::kProse}};
  for (const StabilityTotal& total : totals) table.columns.push_back({total.solver});
  for (const StressCase& stress : report.stress_cases) {
    std::vector<Cell> cells{{stress.name}, {stress.description}};
    for (const StabilityTotal& total : totals) {
      const StabilityRow* const row = find(report, stress.name, total.solver);
      cells.push_back(row != nullptr ? outcome_cell(*row) : Cell{"-"});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table rows_table(const StabilityReport& report) {
  Table table;
  table.columns = {{"case"},
                   {"solver"},
                   {"outcome"},
                   {"stretch %", kNumbers},
                   {"penetration %", kNumbers},
                   {"fastest m/s", kNumbers},
                   {"settle error %", kNumbers}};
  for (const StabilityRow& row : report.rows) {
    table.rows.push_back({{row.stress_case},
                          {row.solver},
                          {name_of(row.outcome), look_of(row.outcome)},
                          {number_text(row.stretch_max_pct)},
                          {number_text(row.penetration_max_pct)},
                          {number_text(row.max_speed)},
                          {number_text(row.settle_error_pct)}});
  }
  return table;
}

}  // namespace

std::string stability_page(const ReportHeading& heading, const StabilityReport& report) {
  HtmlPage page("Stability under stress: " + heading.asset);
  page.paragraph(heading_text(heading));
  page.summary(stability_summary(report));
  page.table(totals_table(report));
  page.table(legend_table());
  page.heading("Case by case");
  page.paragraph(
      "Stretch is the worst of a bone, in % of its length; inside is the worst depth of a bone's end in a collider, in "
      "% of the collider's radius.");
  page.table(cases_table(report));
  page.heading("Every measurement");
  page.paragraph(
      "Settle error: RMS distance of the tips to the settled hair after the stress has ended, in % of the chain's "
      "length. A solver that does not find back stays deformed in the game, too.");
  page.table(rows_table(report));
  return page.text();
}

}  // namespace coif
