#include "report/shadow/shadow_report.h"

#include <fmt/format.h>

#include <algorithm>
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

/// Of a plain map of as many bytes, between those that were measured; NaN beyond them. In a plot of both logarithms the
/// error is nearly a line.
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

/// For each map of deep shadows that a device draws: how much nearer to the truth it is than plain maps.
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
  json["lights"] = json_list(light_columns(), report.lights);
  json["rows"] = json_list(shadow_columns(), report.rows);
  json["totals"] = json_list(shadow_total_columns(), report.totals);
  return json;
}

std::string shadow_text(const ReportHeading& heading, const ShadowReport& report) {
  return heading_text(heading) + "\n  " + shadow_method(report) + " Drawn by " + report.device + ".\n" +
         text_heading(shadow_total_columns()) + text_lines(shadow_total_columns(), report.totals) +
         shadow_summary(report) + "\n";
}

namespace {

/// One line per technique and number of layers, over the sizes of its map.
Figure sizes_figure(const ShadowReport& report) {
  Figure figure{{.title = "Error over the size of the map",
                 .x_label = "texels each way",
                 .y_label = "RMS error of the light that reaches hair",
                 .log_x = true},
                "Lower is better. Of 1, which is all of the light; mean over lights and poses."};
  Plot& plot = figure.plot;
  for (const ShadowTotal& total : report.totals) {
    if (total.size == 0) {
      plot.markers.push_back({false, total.hair.rmse, "without shadows"});
      continue;
    }
    const std::string name = technique_text(total.technique, total.layers, 0);
    const auto found = std::ranges::find(plot.series, name, &PlotSeries::name);
    PlotSeries& series = found == plot.series.end() ? plot.add(name) : *found;
    series.points.push_back({double(total.size), total.hair.rmse});
    if (plot.series.size() == 1) plot.x_ticks.push_back(double(total.size));
  }
  return figure;
}

Figure cost_figure(const ShadowReport& report) {
  Figure figure{{.title = "Error against cost",
                 .x_label = "milliseconds to draw the map",
                 .y_label = "RMS error of the light that reaches hair"},
                "Lower is better, further left is cheaper. Drawn by " + report.device + "."};
  for (const ShadowTotal& total : report.totals) {
    if (total.size == 0) continue;
    figure.plot.add(technique_text(total.technique, total.layers, total.size), {{total.ms, total.hair.rmse}},
                    PlotSeries::Style::kPoints);
  }
  return figure;
}

}  // namespace

std::string shadow_page(const ReportHeading& heading, const ShadowReport& report) {
  HtmlPage page = report_page("What shadows get wrong", heading, shadow_summary(report));
  page.paragraph(shadow_method(report));
  page.table(page_table(shadow_total_columns(), report.totals));
  page.paragraph(
      "plain: a depth map, in which hair is solid or not there. opacity: opacity shadow maps, planes across the light "
      "with "
      "the hair before each. deep: deep opacity maps, which count how much hair lies in each of their layers. "
      "deep-shadow: deep "
      "shadow maps, a function of depth in each texel, of two steps; deep-shadow-cpu: the same of as many lines as "
      "keep "
      "within 0.02, on the processor, alone. Errors are of single points, the maximum too: at the edge of a card every "
      "map has "
      "some that are wrong altogether. A positive bias is light that leaks through, a negative one is light that is "
      "lost. "
      "Hair counts by its alpha, as far as the head leaves it in the light; of the head, the side that is turned to "
      "the "
      "light.");
  page.figure(sizes_figure(report));
  page.figure(cost_figure(report));
  page.heading("The lights");
  page.table(page_table(light_columns(), report.lights));
  page.heading("Every measurement");
  page.table(page_table(shadow_columns(), report.rows));
  return page.text();
}

}  // namespace coif
