#include "report/stability/stability_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

void take_worst(double& worst, double value) {
  if (std::isfinite(value) && !(value <= worst)) worst = value;
}

void add(StabilityTotal& total, const StabilityRow& row) {
  ++total.count[std::size_t(row.outcome)];
  if (row.outcome != Outcome::kOk) return;
  take_worst(total.stretch_max_pct, row.stretch_max_pct);
  take_worst(total.penetration_max_pct, row.penetration_max_pct);
  take_worst(total.limit_max_rad, row.limit_max_rad);
  take_worst(total.link_stretch_max_pct, row.link_stretch_max_pct);
  take_worst(total.rest_speed, row.rest_speed);
  take_worst(total.settle_error_pct, row.settle_error_pct);
}

/// Refusing an input and going on is a good answer; a broken state is not.
unsigned failures(const StabilityTotal& total) {
  unsigned sum = 0;
  for (const Outcome outcome : {Outcome::kRestless, Outcome::kDiverged, Outcome::kNan})
    sum += total.count[std::size_t(outcome)];
  return sum;
}

std::string list(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::vector<StabilityTotal> stability_totals(const StabilityReport& report) {
  std::vector<StabilityTotal> totals;
  for (const std::string& solver : names_of(report.rows, &StabilityRow::solver)) {
    StabilityTotal& total = totals.emplace_back(StabilityTotal{.solver = solver});
    for (const StabilityRow& row : report.rows) {
      if (row.solver == solver) add(total, row);
    }
  }
  return totals;
}

const char* describe(Outcome outcome) {
  switch (outcome) {
    case Outcome::kOk: return "went on with finite, plausible hair";
    case Outcome::kRejected: return "refused the input, said so and kept its state";
    case Outcome::kRestless: return "hair under a head that stands still goes on moving, at more than 2 cm/s";
    case Outcome::kDiverged: return "finite numbers that are no hair: lengths gone, or ever faster";
    case Outcome::kNan: return "a number that is not finite: the hair disappears";
  }
  return "";
}

std::string stability_summary(const StabilityReport& report) {
  std::vector<std::string> safe, broken;
  for (const StabilityTotal& total : stability_totals(report)) {
    const unsigned failed = failures(total);
    if (failed == 0) safe.push_back(total.solver);
    if (failed > 0) broken.push_back(fmt::format("{} (in {})", total.solver, failed));
  }
  return fmt::format("{} {} of stress. Always gave usable hair or refused the input: {}. Broke down: {}.",
                     report.stress_cases.size(), report.stress_cases.size() == 1 ? "case" : "cases", list(safe),
                     list(broken));
}

Cell outcome_cell(Outcome outcome) {
  constexpr CellLook kLooks[] = {CellLook::kGood, CellLook::kNeutral, CellLook::kWarning, CellLook::kWarning,
                                 CellLook::kBad};
  return {name_of(outcome), kLooks[std::size_t(outcome)]};
}

Columns<StabilityTotal> stability_total_columns() {
  using Total = StabilityTotal;
  Columns<Total> columns{{kNoKey, &Total::solver, {"solver"}, {"solver", -14}}};
  for (const Outcome outcome : kOutcomes) {
    columns.add({kNoKey, [outcome](const Total& total) { return total.count[std::size_t(outcome)]; },
                 PageColumn{name_of(outcome),
                            [outcome](double count) {
                              const CellLook look = count > 0 ? outcome_cell(outcome).look : CellLook::kPlain;
                              return Cell{fmt::format("{}", count), look};
                            }},
                 TextColumn{name_of(outcome), 10}});
  }
  columns.append({{kNoKey, &Total::stretch_max_pct, {"worst stretch", percent_text}, {"stretch %", 12}},
                  {kNoKey, &Total::penetration_max_pct, {"worst penetration", percent_text}, {"penetration %", 15}},
                  {kNoKey, &Total::limit_max_rad, {"furthest beyond a limit, rad"}, {"limit rad", 11}},
                  {kNoKey, &Total::link_stretch_max_pct, {"links parted most", percent_text}, {"links %", 9}},
                  {kNoKey, &Total::rest_speed, {"fastest at rest, m/s"}, {"at rest m/s", 13}},
                  {kNoKey, &Total::settle_error_pct, {"worst settle error", percent_text}, {"settle %", 10}}});
  return columns;
}

nlohmann::ordered_json stability_json(const ReportHeading& heading, const StabilityReport& report) {
  nlohmann::ordered_json json = heading_json(heading);
  json["cases"] = json_list(stability_columns(), report.rows);
  json["descriptions"] = json_list(stress_case_columns(), report.stress_cases);
  return json;
}

std::string stability_text(const ReportHeading& heading, const StabilityReport& report) {
  return heading_text(heading) + "\n" + text_heading(stability_total_columns()) +
         text_lines(stability_total_columns(), stability_totals(report)) +
         "  stretch, penetration and settle error: the worst of the cases that ended well\n" +
         stability_summary(report) + "\n";
}

namespace {

Table legend_table() {
  Table table{{{"outcome"}, {"the solver ..."}}, {}};
  for (const Outcome outcome : kOutcomes) table.rows.push_back({outcome_cell(outcome), {describe(outcome)}});
  return table;
}

Cell case_cell(const StabilityReport& report, const std::string& stress_case, const std::string& solver) {
  const auto row = std::ranges::find_if(
      report.rows, [&](const StabilityRow& one) { return one.stress_case == stress_case && one.solver == solver; });
  if (row == report.rows.end()) return {"-"};
  Cell cell = outcome_cell(row->outcome);
  if (std::isfinite(row->stretch_max_pct)) cell.text += "\nstretch " + percent_text(row->stretch_max_pct);
  if (std::isfinite(row->penetration_max_pct)) cell.text += "\ninside " + percent_text(row->penetration_max_pct);
  return cell;
}

/// A row for each case, a column for each solver.
Table cases_table(const StabilityReport& report) {
  const std::vector<std::string> solvers = names_of(report.rows, &StabilityRow::solver);
  Table table{{{"case"}, {"what happens", Column::Kind::kProse}}, {}};
  for (const std::string& solver : solvers) table.columns.push_back({solver});
  for (const StressCase& stress : report.stress_cases) {
    auto& cells = table.rows.emplace_back(std::vector<Cell>{{stress.name}, {stress.description}});
    for (const std::string& solver : solvers) cells.push_back(case_cell(report, stress.name, solver));
  }
  return table;
}

}  // namespace

std::string stability_page(const ReportHeading& heading, const StabilityReport& report) {
  HtmlPage page = report_page("Stability under stress", heading, stability_summary(report));
  page.table(page_table(stability_total_columns(), stability_totals(report)));
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
  page.table(page_table(stability_columns(), report.rows));
  return page.text();
}

}  // namespace coif
