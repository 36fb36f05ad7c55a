#include "report/picture/picture_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace coif::report {
namespace {

constexpr const char* kAll = "all";

/// Over the rows with the names and the size of `total`.
std::optional<PictureRow> total_of(const std::vector<PictureRow>& rows, PictureRow total) {
  LightFigures& sum = total.figures;
  std::array<double, 6> grains{};
  double count = 0, tones = 0;
  const auto fits = [](const std::string& wanted, const std::string& name) { return wanted == kAll || wanted == name; };
  for (const PictureRow& row : rows) {
    const bool is_meant = fits(total.light, row.light) && fits(total.color, row.color);
    if (row.is_full_size != total.is_full_size || !is_meant) continue;
    total.size = row.size;
    if (std::isfinite(row.figures.tone)) {
      ++tones;
      sum.tone += row.figures.tone * row.figures.tone;
      sum.bias += row.figures.bias;
    }
    for (std::size_t i = 0; i < grains.size(); ++i) {
      if (!std::isfinite(row.figures.grain[i])) continue;
      ++grains[i];
      sum.grain[i] += std::log(std::max(row.figures.grain[i], 1e-3));
    }
    sum.outline += row.figures.outline;
    sum.coverage += row.figures.coverage;
    ++count;
  }
  if (count == 0) return std::nullopt;
  sum.tone = std::sqrt(sum.tone / tones);
  sum.bias /= tones;
  for (std::size_t i = 0; i < grains.size(); ++i) sum.grain[i] = std::exp(sum.grain[i] / grains[i]);
  sum.outline /= count;
  sum.coverage /= count;
  total.view = fmt::format("{} pictures", count);
  return total;
}

std::vector<std::string> sorted_names(const std::vector<PictureRow>& rows, std::string PictureRow::*name) {
  std::vector<std::string> names = names_of(rows, name);
  std::ranges::sort(names);
  return names;
}

std::string finding(const PictureReport& report) {
  if (report.totals.empty()) return "No picture was compared.";
  const LightFigures& figures = report.totals.front().figures;
  const auto [least, most] = std::ranges::minmax(figures.grain);
  double worst = 0;
  for (const PictureRow& row : report.rows) worst = std::max(worst, row.figures.tone);
  return fmt::format(
      "Over {} of {} pixels, tone is off by {:.1f} % RMS ({:.1f} in the worst), grain is {:.2f} to {:.2f} times the "
      "true one by the size of details, and outlines agree by {:.3f}.",
      report.totals.front().view, report.totals.front().size, 100 * figures.tone, 100 * worst, least, most,
      figures.outline);
}

constexpr const char* kMethod =
    "Truth: the strands, path-traced with the same camera, lights and base colour; bodies are cut out. Tone: root mean "
    "square difference of the linear mean colours of blocks of 8 x 8 pixels inside both outlines, over the root mean "
    "square of the true ones. Grain: contrast of brightness in bands of details, over the true one, whose noise is "
    "left out by the covariance of two pictures. Outline: intersection over union of the pixels that hair covers by "
    "half; cover: of coverage itself. In totals tone is a root mean square, grain a geometric mean, the others a mean.";

}  // namespace

Columns<PictureRow> picture_columns() {
  using Row = PictureRow;
  Columns<Row> columns{{"view", &Row::view, {"view"}, {"view", -14}},
                       {"color", &Row::color, {"colour"}, {"colour", -8}},
                       {"light", &Row::light, {"light"}, {"light", -8}},
                       {"size", &Row::size, {"pixels"}, {"pixels", 7}},
                       {"tone",
                        [](const Row& row) { return row.figures.tone; },
                        {"tone, RMS", {"{:.1f} %", "-", 100}},
                        {"tone %", 8, {"{:.1f}", "-", 100}}},
                       {"bias",
                        [](const Row& row) { return row.figures.bias; },
                        {"bias", {"{:+.1f} %", "-", 100}},
                        {"bias %", 8, {"{:+.1f}", "-", 100}}}};
  static constexpr std::array<std::array<const char*, 3>, 6> kBands{{{"grain_1", "grain, 1 px", "g1"},
                                                                     {"grain_2", "2 px", "g2"},
                                                                     {"grain_4", "4 px", "g4"},
                                                                     {"grain_8", "8 px", "g8"},
                                                                     {"grain_16", "16 px", "g16"},
                                                                     {"grain_32", "32 px", "g32"}}};
  for (std::size_t i = 0; i < kBands.size(); ++i) {
    columns.add({kBands[i][0],
                 [i](const Row& row) { return row.figures.grain[i]; },
                 {kBands[i][1], "{:.2f}"},
                 {kBands[i][2], 6, "{:.2f}"}});
  }
  columns.add({"outline",
               [](const Row& row) { return row.figures.outline; },
               {"outline IoU", "{:.3f}"},
               {"outline", 9, "{:.3f}"}});
  columns.add({"coverage",
               [](const Row& row) { return row.figures.coverage; },
               {"coverage IoU", "{:.3f}"},
               {"cover", 7, "{:.3f}"}});
  return columns;
}

std::vector<PictureRow> picture_totals(const std::vector<PictureRow>& rows) {
  std::vector<PictureRow> totals;
  for (const bool at_full_size : {true, false}) {
    const auto add = [&](const std::string& color, const std::string& light) {
      if (auto total = total_of(rows, {"", color, light, 0, at_full_size, {}})) {
        totals.push_back(std::move(*total));
      }
    };
    add(kAll, kAll);
    for (const std::string& light : sorted_names(rows, &PictureRow::light)) add(kAll, light);
    for (const std::string& color : sorted_names(rows, &PictureRow::color)) add(color, kAll);
  }
  return totals;
}

nlohmann::ordered_json picture_json(const ReportHeading& heading, const PictureReport& report) {
  nlohmann::ordered_json json = heading_json(heading);
  json["truth"] = report.truth;
  json["device"] = report.device;
  json["shading"] = report.shading;
  add_list(json, "totals", picture_columns(), report.totals);
  add_list(json, "rows", picture_columns(), report.rows);
  add_sheets(json, report.sheets);
  json["notes"] = {{"method", kMethod}};
  end_report(json, heading, "picture", "How far pictures are from path-traced strands", finding(report));
  return json;
}

std::string picture_text(const ReportHeading& heading, const PictureReport& report) {
  return fmt::format("{}\n  {} Shading: {}. Drawn by {}.\n{}{}{}\n", heading_text(heading), kMethod, report.shading,
                     report.device, text_table(picture_columns(), report.totals),
                     text_lines(picture_columns(), report.rows), finding(report));
}

}  // namespace coif::report
