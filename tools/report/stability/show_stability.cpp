#include "report/stability/stability_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coif::report {
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

const char* look_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kOk: return "good";
    case Outcome::kRejected: return "neutral";
    case Outcome::kRestless:
    case Outcome::kDiverged: return "warning";
    case Outcome::kNan: return "bad";
  }
  return "";
}

Format outcome_format() {
  auto rules = nlohmann::ordered_json::array();
  for (const Outcome outcome : kOutcomes) rules.push_back({{"is", name_of(outcome)}, {"look", look_of(outcome)}});
  return Format().colored(rules);
}

Columns<StabilityTotal> stability_total_columns() {
  using Total = StabilityTotal;
  const Format percent = "{percent}";
  Columns<Total> columns{{"solver", &Total::solver, {"solver"}, {"solver", -14}}};
  for (const Outcome outcome : kOutcomes) {
    const Format count = Format("{}").colored({{{"least", 1}, {"look", look_of(outcome)}}});
    columns.add({name_of(outcome), [outcome](const Total& total) { return total.count[std::size_t(outcome)]; },
                 PageColumn{name_of(outcome), count}, TextColumn{name_of(outcome), 10}});
  }
  columns.append(
      {{"stretch_max_pct", &Total::stretch_max_pct, {"worst stretch", percent}, {"stretch %", 12}},
       {"penetration_max_pct", &Total::penetration_max_pct, {"worst penetration", percent}, {"penetration %", 15}},
       {"limit_max_rad", &Total::limit_max_rad, {"furthest beyond a limit, rad"}, {"limit rad", 11}},
       {"link_stretch_max_pct", &Total::link_stretch_max_pct, {"links parted most", percent}, {"links %", 9}},
       {"rest_speed", &Total::rest_speed, {"fastest at rest, m/s"}, {"at rest m/s", 13}},
       {"settle_error_pct", &Total::settle_error_pct, {"worst settle error", percent}, {"settle %", 10}}});
  return columns;
}

nlohmann::ordered_json stability_json(const ReportHeading& heading, const StabilityReport& report) {
  using Row = Outcome;
  const Columns<Row> outcome_columns{{"outcome", [](Row row) { return name_of(row); }, {"outcome", outcome_format()}},
                                     {"meaning", [](Row row) { return describe(row); }, {"the solver ..."}}};
  nlohmann::ordered_json json = heading_json(heading);
  add_list(json, "cases", stability_columns(), report.rows);
  add_list(json, "descriptions", stress_case_columns(), report.stress_cases);
  add_list(json, "totals", stability_total_columns(), stability_totals(report));
  add_list(json, "outcomes", outcome_columns, std::vector<Outcome>(kOutcomes.begin(), kOutcomes.end()));
  end_report(json, heading, "stability", "Stability under stress", stability_summary(report));
  return json;
}

std::string stability_text(const ReportHeading& heading, const StabilityReport& report) {
  return heading_text(heading) + "\n" + text_table(stability_total_columns(), stability_totals(report)) +
         "  stretch, penetration and settle error: the worst of the cases that ended well\n" +
         stability_summary(report) + "\n";
}

}  // namespace coif::report
