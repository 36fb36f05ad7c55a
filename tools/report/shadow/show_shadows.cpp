#include "report/shadow/shadow_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coif::report {
namespace {

constexpr double kNearly = 1.5;  // Multiple of the least error.

bool is_map(const ShadowTotal& total) { return total.size > 0 && std::isfinite(total.hair.rmse); }

const ShadowTotal* find_best(const ShadowReport& report) {
  const ShadowTotal* best = nullptr;
  for (const ShadowTotal& total : report.totals) {
    if (is_map(total) && (best == nullptr || total.hair.rmse < best->hair.rmse)) best = &total;
  }
  return best;
}

/// By bytes, which are the same everywhere, unlike times.
const ShadowTotal* find_small(const ShadowReport& report, double most) {
  const ShadowTotal* small = nullptr;
  for (const ShadowTotal& total : report.totals) {
    if (!is_map(total) || total.hair.rmse > most) continue;
    if (small == nullptr || total.bytes < small->bytes) small = &total;
  }
  return small;
}

/// The error of a plain map with as many bytes, interpolated between the measured ones; NaN outside their range. In a
/// plot with both axes logarithmic the error is nearly a line.
double plain_error_at(const ShadowReport& report, double bytes) {
  const ShadowTotal *below = nullptr, *above = nullptr;
  for (const ShadowTotal& total : report.totals) {
    if (total.technique != "plain" || !is_map(total)) continue;
    const bool is_below = double(total.bytes) <= bytes;
    const ShadowTotal*& nearest = is_below ? below : above;
    if (nearest == nullptr || (total.bytes > nearest->bytes) == is_below) nearest = &total;
  }
  if (below == nullptr) return kNoNumber;
  if (double(below->bytes) == bytes) return below->hair.rmse;
  if (above == nullptr) return kNoNumber;
  const double share = std::log(bytes / double(below->bytes)) / std::log(double(above->bytes) / double(below->bytes));
  return below->hair.rmse * std::pow(above->hair.rmse / below->hair.rmse, share);
}

/// For each deep shadow map that a device draws: how much nearer to the truth it is than plain maps.
std::string gain_text(const ShadowReport& report) {
  std::string text;
  for (const ShadowTotal& total : report.totals) {
    if (total.technique != "deep-shadow" || !is_map(total)) continue;
    const double plain = plain_error_at(report, double(total.bytes));
    if (!std::isfinite(plain)) continue;
    text += fmt::format("{} {:.2f} x ({})", text.empty() ? " Nearer than a plain map of as many bytes:" : ",",
                        plain / total.hair.rmse, technique_text(total.technique, total.layers, total.size));
  }
  return text.empty() ? text : text + ".";
}

std::string total_text(const ShadowTotal& total) {
  return fmt::format("{} (RMS {}, {} KiB, {} ms)", technique_text(total.technique, total.layers, total.size),
                     number_text(total.hair.rmse), total.bytes / 1024, number_text(total.ms));
}

}  // namespace

std::string technique_text(const std::string& technique, std::uint32_t layers, std::uint32_t size) {
  std::string text = technique;
  if (layers > 0) text += fmt::format(", {} layers", layers);
  if (size > 0) text += fmt::format(", {}", size);
  return text;
}

std::string shadow_summary(const ShadowReport& report) {
  const ShadowTotal* best = find_best(report);
  if (best == nullptr) return "There is no hair in the light: nothing was compared.";
  const ShadowTotal* small = find_small(report, kNearly * best->hair.rmse);
  std::string text = fmt::format("Nearest to the truth: {}.", total_text(*best));
  if (small != best) text += fmt::format(" The smallest that is nearly as good: {}.", total_text(*small));
  return text + gain_text(report);
}

std::string shadow_method(const ShadowReport& report) {
  return fmt::format(
      "The share of a light that reaches a point, 0 to 1, at {} points of hair and {} of the head, under {} lights, "
      "against the product of 1 - alpha of all that lies between, along lines {:.1f} mm apart. The truth {:.2f} mm "
      "aside on the "
      "same surface, over the {:.0f} % of the hair that goes on so far, differs from itself by RMS {}: no map of wider "
      "texels "
      "comes nearer.",
      report.hair_points, report.head_points, report.lights.size(), 1000 * report.spacing, 1000 * report.aside,
      100 * report.truth_compared, number_text(report.truth_rmse));
}

nlohmann::ordered_json shadow_json(const ReportHeading& heading, const ShadowReport& report) {
  nlohmann::ordered_json json = heading_json(heading);
  json["device"] = report.device;
  json["spacing"] = number_json(report.spacing);
  json["hair_points"] = report.hair_points;
  json["head_points"] = report.head_points;
  json["truth_aside"] = number_json(report.aside);
  json["truth_rmse"] = number_json(report.truth_rmse);
  json["truth_compared"] = number_json(report.truth_compared);
  add_list(json, "lights", light_columns(), report.lights);
  add_list(json, "rows", shadow_columns(), report.rows);
  add_list(json, "totals", shadow_total_columns(), report.totals);
  json["notes"] = {{"method", shadow_method(report)}};
  end_report(json, heading, "shadows", "What shadows get wrong", shadow_summary(report));
  return json;
}

std::string shadow_text(const ReportHeading& heading, const ShadowReport& report) {
  return heading_text(heading) + "\n  " + shadow_method(report) + " Drawn by " + report.device + ".\n" +
         text_table(shadow_total_columns(), report.totals) + shadow_summary(report) + "\n";
}

}  // namespace coif::report
