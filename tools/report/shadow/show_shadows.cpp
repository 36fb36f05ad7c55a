#include "report/shadow/show_shadows.h"

#include "base/json.h"
#include "report/page/report_heading.h"

#include <fmt/format.h>

#include <cmath>

namespace coif {
namespace {

constexpr double kNearly = 1.5;  // of the least error

bool is_map(const ShadowTotal& total) { return total.size > 0 && std::isfinite(total.hair.rmse); }

const ShadowTotal* find_best(const ShadowReport& report) {
  const ShadowTotal* best = nullptr;
  for (const ShadowTotal& total : report.totals) {
    if (is_map(total) && (best == nullptr || total.hair.rmse < best->hair.rmse)) best = &total;
  }
  return best;
}

/// By bytes, which are the same everywhere; times are not.
const ShadowTotal* find_small(const ShadowReport& report, double most) {
  const ShadowTotal* small = nullptr;
  for (const ShadowTotal& total : report.totals) {
    if (!is_map(total) || total.hair.rmse > most) continue;
    if (small == nullptr || total.bytes < small->bytes) small = &total;
  }
  return small;
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
  return text;
}

std::string shadow_method(const ShadowReport& report) {
  return fmt::format(
      "The share of a light that reaches a point, 0 to 1, at {} points of hair and {} of the head, under {} lights, "
      "against "
      "the product of 1 - alpha of all that lies between, along lines {:.1f} mm apart.",
      report.hair_points, report.head_points, report.lights.size(), 1000 * report.spacing);
}

namespace {

using nlohmann::ordered_json;

void add_errors(const ShadowError& hair, const ShadowError& head, ordered_json& json) {
  json["rmse"] = number_json(hair.rmse);
  json["bias"] = number_json(hair.bias);
  json["head_rmse"] = number_json(head.rmse);
  json["head_bias"] = number_json(head.bias);
}

ordered_json to_json(const ShadowLight& light) {
  return {{"light", light.name}, {"yaw", number_json(light.yaw_degrees)}, {"pitch", number_json(light.pitch_degrees)}};
}

ordered_json to_json(const ShadowRow& row) {
  ordered_json json = {{"technique", row.technique},
                       {"layers", row.layers},
                       {"size", row.size},
                       {"light", row.light},
                       {"pose", row.pose}};
  add_errors(row.hair, row.head, json);
  json["ms"] = number_json(row.ms);
  return json;
}

ordered_json to_json(const ShadowTotal& total) {
  ordered_json json = {{"technique", total.technique}, {"layers", total.layers}, {"size", total.size}};
  add_errors(total.hair, total.head, json);
  json["worst_light"] = total.worst_light;
  json["worst_pose"] = total.worst_pose;
  json["worst_rmse"] = number_json(total.worst_rmse);
  json["ms"] = number_json(total.ms);
  json["bytes"] = total.bytes;
  return json;
}

template <typename Row>
ordered_json list(const std::vector<Row>& rows) {
  ordered_json array = ordered_json::array();
  for (const Row& row : rows) array.push_back(to_json(row));
  return array;
}

}  // namespace

ordered_json shadow_json(const ReportHeading& heading, const ShadowReport& report) {
  ordered_json json = heading_json(heading);
  json["device"] = report.device;
  json["spacing"] = number_json(report.spacing);
  json["hair_points"] = report.hair_points;
  json["head_points"] = report.head_points;
  json["lights"] = list(report.lights);
  json["rows"] = list(report.rows);
  json["totals"] = list(report.totals);
  return json;
}

namespace {

std::string worst_text(const ShadowTotal& total) {
  return fmt::format("{} ({}, {})", number_text(total.worst_rmse), total.worst_light, total.worst_pose);
}

std::string total_line(const ShadowTotal& total) {
  const bool is_map = total.size > 0;
  return fmt::format("  {:<22}{:>9}{:>9}{:>11}{:>11}   {:<24}{:>8}{:>8}\n",
                     technique_text(total.technique, total.layers, total.size), number_text(total.hair.rmse),
                     number_text(total.hair.bias), number_text(total.head.rmse), number_text(total.head.bias),
                     worst_text(total), is_map ? number_text(total.ms) : "-",
                     is_map ? std::to_string(total.bytes / 1024) : "-");
}

}  // namespace

std::string shadow_text(const ReportHeading& heading, const ShadowReport& report) {
  std::string text = heading_text(heading) + "\n  " + shadow_method(report) + " Drawn by " + report.device + ".\n";
  text += fmt::format("  {:<22}{:>9}{:>9}{:>11}{:>11}   {:<24}{:>8}{:>8}\n", "technique", "hair rms", "bias",
                      "head rms", "bias", "worst light of hair", "ms", "KiB");
  for (const ShadowTotal& total : report.totals) text += total_line(total);
  return text + shadow_summary(report) + "\n";
}

}  // namespace coif
