#include "base/json.h"
#include "report/accuracy/show_accuracy.h"
#include "report/page/report_heading.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const AccuracyRow& row) {
  return {{"motion", row.motion},
          {"solver", row.solver},
          {"fps", row.fps},
          {"substeps", row.substeps},
          {"ns_per_bone_frame", number_json(row.ns_per_bone_frame)},
          {"rms_error_pct", number_json(row.rms_error_pct)},
          {"max_error_pct", number_json(row.max_error_pct)},
          {"stretch_max_pct", number_json(row.stretch_max_pct)},
          {"penetration_max_pct", number_json(row.penetration_max_pct)},
          {"segment_penetration_max_pct", number_json(row.segment_penetration_max_pct)},
          {"pareto", row.pareto}};
}

ordered_json to_json(const SpreadRow& row) {
  return {{"motion", row.motion},
          {"solver", row.solver},
          {"substeps", row.substeps},
          {"frame_rate_spread_pct", number_json(row.frame_rate_spread_pct)}};
}

ordered_json to_json(const ReferenceRow& row) {
  return {{"motion", row.motion},
          {"self_difference_pct", number_json(row.self_difference_pct)},
          {"steps_per_second", number_json(row.steps_per_second)}};
}

ordered_json to_json(const SettleRow& row) {
  return {{"solver", row.solver}, {"settle_error_pct", number_json(row.settle_error_pct)}};
}

ordered_json to_json(const std::optional<ChosenSolver>& chosen) {
  if (!chosen) return nullptr;
  return {{"solver", chosen->solver},
          {"substeps", chosen->substeps},
          {"rms_error_pct", number_json(chosen->rms_error_pct)},
          {"ns_per_bone_frame", number_json(chosen->ns_per_bone_frame)}};
}

template <typename Row>
ordered_json list(const std::vector<Row>& rows) {
  ordered_json array = ordered_json::array();
  for (const Row& row : rows) array.push_back(to_json(row));
  return array;
}

}  // namespace

ordered_json accuracy_json(const ReportHeading& heading, const AccuracyReport& report) {
  ordered_json json = heading_json(heading);
  json["rows"] = list(report.rows);
  json["spread"] = list(report.spread);
  json["reference"] = list(report.reference);
  json["settle"] = list(report.settle);
  json["budget_rms_pct"] = number_json(report.budget_rms_pct);
  json["chosen"] = to_json(report.chosen);
  return json;
}

namespace {

constexpr const char* kPublished = "thesis";

const SettingMean* least_wrong(const std::vector<SettingMean>& means) {
  const SettingMean* best = nullptr;
  for (const SettingMean& mean : means) {
    if (!std::isfinite(mean.rms_error_pct)) continue;
    if (best == nullptr || mean.rms_error_pct < best->rms_error_pct) best = &mean;
  }
  return best;
}

// As the user wrote it: "2 %", not "2.00 %".
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

std::string nothing_chosen_sentence(const AccuracyReport& report, const SettingMean* best, double fps) {
  const std::string nothing =
      std::isfinite(report.budget_rms_pct)
          ? fmt::format("No setting stays within {} of the exact motion.", budget_text(report.budget_rms_pct))
          : std::string("No setting was chosen.");
  if (best == nullptr) return nothing;
  return fmt::format("{} The least wrong at {} frames per second is {} with {}: {} (RMS over the motions).", nothing,
                     fps, best->solver, steps_text(best->substeps), percent_text(best->rms_error_pct));
}

std::string published_sentence(const std::vector<SettingMean>& means, double fps) {
  const auto published = std::ranges::find_if(
      means, [](const SettingMean& mean) { return mean.solver == kPublished && mean.substeps == 1; });
  if (published == means.end()) return "";
  if (!std::isfinite(published->rms_error_pct)) return " The method as published in 2011 breaks down.";
  return fmt::format(" The method as published in 2011 is {} away at {} frames per second, for {} ns.",
                     percent_text(published->rms_error_pct), fps, number_text(published->ns_per_bone_frame));
}

}  // namespace

std::string accuracy_summary(const AccuracyReport& report) {
  const double fps = main_frame_rate(report);
  const std::vector<SettingMean> means = means_over_motions(report, fps);
  const SettingMean* const best = least_wrong(means);
  const std::string first = report.chosen ? chosen_sentence(report) : nothing_chosen_sentence(report, best, fps);
  const bool is_published = report.chosen && report.chosen->solver == kPublished;
  return is_published ? first : first + published_sentence(means, fps);
}

std::string reference_summary(const AccuracyReport& report) {
  // Where no budget says what matters, a percent of the hair's length is about what an eye notices.
  const double limit = std::isfinite(report.budget_rms_pct) ? report.budget_rms_pct : 1.0;
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
        "it agrees with itself to {} in every motion; errors above that are the solvers'. In that model bones do not "
        "pull "
        "on their parents; the methods whose bones do (all but coif and projective) solve another equation, and a part "
        "of "
        "their distance is that difference, whatever their steps.",
        percent_text(worst));
  }
  return fmt::format(
      "Errors are distances to a converged solution of the same model, but in {} it does not agree with itself to {}: "
      "hair that is damped this little amplifies every rounding, and there errors below the self-difference say "
      "nothing. More damping in the recipe makes the motion repeatable.",
      fmt::join(unsure, ", "), budget_text(limit));
}

namespace {

bool is_least_wrong(const SettingMean& mean, const std::vector<SettingMean>& means) {
  return std::ranges::none_of(means, [&mean](const SettingMean& other) {
    return other.solver == mean.solver && other.rms_error_pct < mean.rms_error_pct;
  });
}

std::string line(const SettingMean& mean) {
  return fmt::format("  {:<14}{:>10}{:>10}{:>9}{:>9}{:>11}{:>15}{}\n", mean.solver, mean.substeps,
                     number_text(mean.ns_per_bone_frame), number_text(mean.rms_error_pct),
                     number_text(mean.max_error_pct), number_text(mean.stretch_max_pct),
                     number_text(mean.penetration_max_pct), mean.pareto ? "  *" : "");
}

}  // namespace

std::string accuracy_text(const ReportHeading& heading, const AccuracyReport& report) {
  const double fps = main_frame_rate(report);
  const std::vector<SettingMean> means = means_over_motions(report, fps);
  std::string text = heading_text(heading) + "\n";
  text += fmt::format("  {:<14}{:>10}{:>10}{:>9}{:>9}{:>11}{:>15}\n", "solver", "steps", "ns/bone", "rms %", "max %",
                      "stretch %", "penetration %");
  for (const SettingMean& mean : means) {
    if (mean.pareto || is_least_wrong(mean, means)) text += line(mean);
  }
  text += fmt::format("  at {} per second, over {} motion{}; *: nothing is both cheaper and more exact\n", fps,
                      motions_of(report).size(), motions_of(report).size() == 1 ? "" : "s");
  return text + accuracy_summary(report) + "\n" + reference_summary(report) + "\n";
}

}  // namespace coif
