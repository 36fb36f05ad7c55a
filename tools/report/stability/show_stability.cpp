#include "report/stability/show_stability.h"

#include "base/json.h"
#include "report/page/html_page.h"
#include "report/page/report_heading.h"

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
  take_worst(total.settle_error_pct, row.settle_error_pct);
}

/// Refusing an input and going on is a good answer; a broken state is not.
unsigned failures(const StabilityTotal& total) {
  return total.count[std::size_t(Outcome::kDiverged)] + total.count[std::size_t(Outcome::kNan)];
}

std::string list(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::vector<StabilityTotal> stability_totals(const StabilityReport& report) {
  std::vector<StabilityTotal> totals;
  for (const StabilityRow& row : report.rows) {
    auto found = std::ranges::find(totals, row.solver, &StabilityTotal::solver);
    if (found == totals.end()) {
      totals.emplace_back();
      totals.back().solver = row.solver;
      found = totals.end() - 1;
    }
    add(*found, row);
  }
  return totals;
}

const char* describe(Outcome outcome) {
  switch (outcome) {
    case Outcome::kOk: return "went on with finite, plausible hair";
    case Outcome::kRejected: return "refused the input, said so and kept its state";
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

namespace {

using nlohmann::ordered_json;

ordered_json to_json(const StabilityRow& row) {
  return {{"case", row.stress_case},
          {"solver", row.solver},
          {"outcome", name_of(row.outcome)},
          {"stretch_max_pct", number_json(row.stretch_max_pct)},
          {"penetration_max_pct", number_json(row.penetration_max_pct)},
          {"max_speed", number_json(row.max_speed)},
          {"settle_error_pct", number_json(row.settle_error_pct)}};
}

}  // namespace

ordered_json stability_json(const ReportHeading& heading, const StabilityReport& report) {
  ordered_json cases = ordered_json::array(), descriptions = ordered_json::array();
  for (const StabilityRow& row : report.rows) cases.push_back(to_json(row));
  for (const StressCase& stress : report.stress_cases) {
    descriptions.push_back({{"case", stress.name}, {"description", stress.description}});
  }
  ordered_json json = heading_json(heading);
  json["cases"] = cases;
  json["descriptions"] = descriptions;
  return json;
}

std::string stability_text(const ReportHeading& heading, const StabilityReport& report) {
  std::string text = heading_text(heading) + "\n";
  text += fmt::format("  {:<14}", "solver");
  for (const Outcome outcome : kOutcomes) text += fmt::format("{:>10}", name_of(outcome));
  text += fmt::format("{:>12}{:>15}{:>10}\n", "stretch %", "penetration %", "settle %");
  for (const StabilityTotal& total : stability_totals(report)) {
    text += fmt::format("  {:<14}", total.solver);
    for (const unsigned count : total.count) text += fmt::format("{:>10}", count);
    text += fmt::format("{:>12}{:>15}{:>10}\n", number_text(total.stretch_max_pct),
                        number_text(total.penetration_max_pct), number_text(total.settle_error_pct));
  }
  return text + "  stretch, penetration and settle error: the worst of the cases that ended well\n" +
         stability_summary(report) + "\n";
}

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
