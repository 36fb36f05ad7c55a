#include "report/accuracy/accuracy_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace coif::report {

using nlohmann::ordered_json;

namespace {

/// The longest chain's tip over time, when the head charges.
ordered_json swing_path_json(const SwingPath& path) {
  constexpr double kShown = 2.5;  // seconds
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < path.behind_m.size() && double(i) * path.seconds_per_frame < kShown; ++i) {
    list.push_back({{"seconds", double(i + 1) * path.seconds_per_frame},
                    {"behind_mm", number_json(1000 * path.behind_m[i])},
                    {"artist_behind_mm", number_json(1000 * path.artist_behind_m[i])}});
  }
  return list;
}

}  // namespace

ordered_json accuracy_json(const ReportHeading& heading, const AccuracyReport& measured) {
  AccuracyReport report = measured;
  choose_shown(report);
  const double budget = report.budget_rms_pct, fps = main_frame_rate(report);
  ordered_json json = heading_json(heading);
  add_list(json, "rows", accuracy_columns(budget), report.rows);
  add_list(json, "spread", spread_columns(budget), report.spread);
  add_list(json, "reference", reference_columns(budget), report.reference);
  add_list(json, "own_reference", own_reference_columns(budget), report.own_reference);
  add_list(json, "settle", settle_columns(budget), report.settle);
  add_list(json, "swings", swing_columns(), report.swings.rows);
  add_list(json, "stroke", stroke_columns(), report.stroke);
  json["conditioned_share"] = report.conditioned_share;
  json["tells_velocities"] = report.tells_velocities;
  json["budget_rms_pct"] = number_json(budget);
  json["chosen"] = report.chosen ? json_of(chosen_columns(), *report.chosen) : ordered_json(nullptr);
  json["main_fps"] = number_json(fps);
  add_list(json, "means", accuracy_columns(budget).without({"motion", "fps"}), means_over_motions(report, fps));
  json["swing_chain"] = report.swings.longest.chain;
  json["swing_path"] = swing_path_json(report.swings.longest);
  json["view_motions"] = motion_links(heading, report);
  json["notes"] = {{"reference", reference_summary(report)},
                   {"own_reference", own_reference_summary(report)},
                   {"numbers_read", numbers_read(report)},
                   {"velocities", velocities_told(report)}};
  end_report(json, heading, "accuracy", "Error against run time", accuracy_summary(report), accuracy_link(report));
  return json;
}

namespace {

constexpr const char* kPublished = "thesis";

const AccuracyRow* least_wrong(const std::vector<AccuracyRow>& means) {
  const AccuracyRow* best = nullptr;
  for (const AccuracyRow& mean : means) {
    if (!std::isfinite(mean.rms_error_pct)) continue;
    if (best == nullptr || mean.rms_error_pct < best->rms_error_pct) best = &mean;
  }
  return best;
}

// In the user's notation: "2 %", not "2.00 %".
std::string budget_text(double percent) { return fmt::format("{} %", percent); }

std::string steps_text(std::uint32_t substeps) {
  return substeps == 1 ? "one step a frame" : fmt::format("{} sub-steps a frame", substeps);
}

std::string chosen_sentence(const AccuracyReport& report) {
  const ChosenSolver& chosen = *report.chosen;
  const std::string budget =
      std::isfinite(report.budget_rms_pct) ? fmt::format("within {}", budget_text(report.budget_rms_pct)) : "chosen";
  return fmt::format(
      "The cheapest setting {} of the exact motion is {} with {}: the tips of the hair are {} of their chain's length "
      "away from it (RMS over the motions), for {} ns a bone and frame.",
      budget, chosen.solver, steps_text(chosen.substeps), percent_text(chosen.rms_error_pct),
      number_text(chosen.ns_per_bone_frame));
}

std::string nothing_chosen_sentence(const AccuracyReport& report, const AccuracyRow* best, double fps) {
  const std::string nothing =
      std::isfinite(report.budget_rms_pct)
          ? fmt::format("No setting stays within {} of the exact motion.", budget_text(report.budget_rms_pct))
          : std::string("No setting was chosen.");
  if (best == nullptr) return nothing;
  return fmt::format("{} The least wrong at {} frames per second is {} with {}: {} (RMS over the motions).", nothing,
                     fps, best->solver, steps_text(best->substeps), percent_text(best->rms_error_pct));
}

std::string published_sentence(const std::vector<AccuracyRow>& means, double fps) {
  const auto published = std::ranges::find_if(
      means, [](const AccuracyRow& mean) { return mean.solver == kPublished && mean.substeps == 1; });
  if (published == means.end()) return "";
  if (!std::isfinite(published->rms_error_pct)) return " The method as published in 2011 breaks down.";
  return fmt::format(" The method as published in 2011 is {} away at {} frames per second, for {} ns.",
                     percent_text(published->rms_error_pct), fps, number_text(published->ns_per_bone_frame));
}

}  // namespace

std::string accuracy_summary(const AccuracyReport& report) {
  const double fps = main_frame_rate(report);
  const std::vector<AccuracyRow> means = means_over_motions(report, fps);
  const AccuracyRow* const best = least_wrong(means);
  const std::string first = report.chosen ? chosen_sentence(report) : nothing_chosen_sentence(report, best, fps);
  const bool is_published = report.chosen && report.chosen->solver == kPublished;
  return is_published ? first : first + published_sentence(means, fps);
}

/// The model of the solvers that do not ship.
std::string model_text(double passive_share) {
  constexpr const char* kCascade =
      "bones do not pull on their parents; the methods whose bones do (all but coif and projective) solve another "
      "equation, "
      "and a part of their distance is that difference, whatever their steps.";
  constexpr const char* kPassive =
      "bones hold back their parents, by a potential of their bending; the other methods solve other equations, and a "
      "part "
      "of their distance is that difference, whatever their steps.";
  if (passive_share == 0) return fmt::format("In that model {}", kCascade);
  if (passive_share == 1) return fmt::format("In that model {}", kPassive);
  return fmt::format("In {:.0f} % of the bones, {} In the others {}", 100 * passive_share, kPassive, kCascade);
}

std::string reference_summary(const AccuracyReport& report) {
  const double limit = largest_self_difference(report.budget_rms_pct);
  std::vector<std::string> unsure;
  double worst = 0;
  for (const ReferenceRow& row : report.reference) {
    if (!(row.self_difference_pct <= limit)) unsure.push_back(row.motion);
    worst = std::isnan(row.self_difference_pct) ? worst : std::max(worst, row.self_difference_pct);
  }
  if (report.reference.empty()) return "There is no reference: errors were not measured.";
  if (unsure.empty()) {
    return fmt::format(
        "Errors are distances to a converged solution of the same model. Computed twice, with steps of double length, "
        "it agrees with itself to {} in every motion; errors above that are the solvers'. {}",
        percent_text(worst), model_text(report.passive_share));
  }
  return fmt::format(
      "Errors are distances to a converged solution of the same model, but in {} it does not agree with itself to {}: "
      "hair that is damped this little amplifies every rounding, and there errors below the self-difference say "
      "nothing. More damping in the recipe makes the motion repeatable.",
      fmt::join(unsure, ", "), budget_text(limit));
}

std::string own_reference_summary(const AccuracyReport& report) {
  const double limit = largest_self_difference(report.budget_rms_pct);
  std::vector<std::string> named;
  for (const std::string& solver : names_of(report.own_reference, &OwnReferenceRow::solver)) {
    std::vector<std::string> motions;
    for (const OwnReferenceRow& row : report.own_reference) {
      if (row.solver == solver && !(row.self_difference_pct <= limit)) motions.push_back(row.motion);
    }
    if (!motions.empty()) named.push_back(fmt::format("{} in {}", solver, fmt::join(motions, ", ")));
  }
  if (named.empty()) return "";
  return fmt::format(
      "Ever finer steps do not come to one motion (within {}) of {}: no error against their own model is told there.",
      budget_text(limit), fmt::join(named, "; "));
}

std::string numbers_read(const AccuracyReport& report) {
  if (report.conditioned_share == 0) return "";
  return fmt::format(
      "In {:.2g} % of the bones the cook changed friction, damping or parent_share so that they have one motion. The "
      "reference, "
      "coif, cascade and passive read these numbers; thesis and the other methods read the artist's, so that a part of "
      "their "
      "distance is that difference.",
      100 * report.conditioned_share);
}

std::string velocities_told(const AccuracyReport& report) {
  if (!report.tells_velocities) return "";
  return "The runtime's solvers are told how fast the head arrives, the others have its poses alone.";
}

namespace {

std::string line_of(const std::string& sentence) { return sentence.empty() ? "" : sentence + "\n"; }

/// The swings of the longest chains.
std::string swings_text(const AccuracyReport& report) {
  constexpr std::size_t kMostLines = 12;
  if (report.swings.rows.empty()) return "";
  std::vector<SwingRow> shown = report.swings.rows;
  shown.resize(std::min(shown.size(), kMostLines));
  std::string text = text_table(swing_columns(), shown);
  if (shown.size() < report.swings.rows.size()) {
    text += fmt::format("  and {} shorter, with --format json\n", report.swings.rows.size() - shown.size());
  }
  return text +
         "  after a charge from 0 to 8 m/s in 0.3 s, as the asset asks for at 60 per second, and by Algorithm 1 with "
         "the artist's resistance and friction\n";
}

/// The hand in the hair, at the main frame rate.
std::string stroke_text(const AccuracyReport& report) {
  std::vector<StrokeRow> shown;
  const double fps = main_frame_rate(report);
  std::ranges::copy_if(report.stroke, std::back_inserter(shown),
                       [fps](const StrokeRow& row) { return row.fps == fps; });
  if (shown.empty()) return "";
  return text_table(stroke_columns(), shown) +
         "  coif on a character, a hand stroking its hair, against the same at 3840 steps a second; reference: those "
         "against 1920\n";
}

}  // namespace

std::string accuracy_text(const ReportHeading& heading, const AccuracyReport& report) {
  const double fps = main_frame_rate(report);
  const std::vector<AccuracyRow> means = means_over_motions(report, fps);
  std::vector<AccuracyRow> shown;
  std::ranges::copy_if(means, std::back_inserter(shown), [&means](const AccuracyRow& mean) {
    return mean.pareto || std::ranges::none_of(means, [&mean](const AccuracyRow& other) {
             return other.solver == mean.solver && other.rms_error_pct < mean.rms_error_pct;
           });
  });
  const auto columns = accuracy_columns(report.budget_rms_pct);
  const std::size_t motions = averaged_motions(report).size();
  return heading_text(heading) + "\n" + text_table(columns, shown) +
         fmt::format(
             "  at {} per second, over {}; *: nothing is both cheaper and more exact\n"
             "  ns of coif, cascade, passive and thesis are of the library: float, in lanes, matrices included; of the "
             "others of double, one bone after the other\n",
             fps, counted(motions, "motion", "motions")) +
         swings_text(report) + stroke_text(report) + accuracy_summary(report) + "\n" + reference_summary(report) +
         "\n" + line_of(own_reference_summary(report)) + line_of(numbers_read(report)) +
         line_of(velocities_told(report));
}

}  // namespace coif::report
