#include "base/json.h"
#include "report/page/plot.h"
#include "report/page/report_heading.h"
#include "report/shadow/show_shadows.h"

#include <fmt/format.h>

namespace coif {
namespace {

constexpr auto kNumbers = Column::Kind::kNumbers;

std::string family_text(const std::string& technique, std::uint32_t layers) {
  return technique_text(technique, layers, 0);
}

/// One line per technique and number of layers, over the sizes of its map.
Figure sizes_figure(const ShadowReport& report) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "Error over the size of the map";
  plot.x_label = "texels each way";
  plot.y_label = "RMS error of the light that reaches hair";
  plot.log_x = true;
  for (const ShadowTotal& total : report.totals) {
    if (total.size == 0) {
      plot.markers.push_back({false, total.hair.rmse, "without shadows"});
      continue;
    }
    const std::string name = family_text(total.technique, total.layers);
    PlotSeries* series = nullptr;
    for (PlotSeries& one : plot.series) {
      if (one.name == name) series = &one;
    }
    if (series == nullptr) {
      plot.series.push_back({name, {}, PlotSeries::Style::kLinePoints, {}, unsigned(plot.series.size())});
      series = &plot.series.back();
    }
    series->points.push_back({double(total.size), total.hair.rmse});
    if (plot.series.size() == 1) plot.x_ticks.push_back(double(total.size));
  }
  figure.caption = "Lower is better. Of 1, which is all of the light; mean over lights and poses.";
  return figure;
}

Figure cost_figure(const ShadowReport& report) {
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = "Error against cost";
  plot.x_label = "milliseconds to draw the map";
  plot.y_label = "RMS error of the light that reaches hair";
  for (const ShadowTotal& total : report.totals) {
    if (total.size == 0) continue;
    plot.series.push_back({technique_text(total.technique, total.layers, total.size),
                           {{total.ms, total.hair.rmse}},
                           PlotSeries::Style::kPoints,
                           {},
                           unsigned(plot.series.size())});
  }
  figure.caption = "Lower is better, further left is cheaper. Drawn by " + report.device + ".";
  return figure;
}

Table totals_table(const ShadowReport& report) {
  Table table;
  table.columns = {{"technique"},           {"RMS, hair", kNumbers},  {"bias, hair", kNumbers},
                   {"RMS, head", kNumbers}, {"bias, head", kNumbers}, {"worst light"},
                   {"its RMS", kNumbers},   {"ms", kNumbers},         {"KiB", kNumbers}};
  for (const ShadowTotal& total : report.totals) {
    const bool is_map = total.size > 0;
    table.rows.push_back({{technique_text(total.technique, total.layers, total.size)},
                          {number_text(total.hair.rmse)},
                          {number_text(total.hair.bias)},
                          {number_text(total.head.rmse)},
                          {number_text(total.head.bias)},
                          {total.worst_light + ", " + total.worst_pose},
                          {number_text(total.worst_rmse)},
                          {is_map ? number_text(total.ms) : "-"},
                          {is_map ? std::to_string(total.bytes / 1024) : "-"}});
  }
  return table;
}

Table rows_table(const ShadowReport& report) {
  Table table;
  table.columns = {{"technique"},
                   {"light"},
                   {"pose"},
                   {"RMS, hair", kNumbers},
                   {"bias, hair", kNumbers},
                   {"RMS, head", kNumbers},
                   {"bias, head", kNumbers},
                   {"ms", kNumbers}};
  for (const ShadowRow& row : report.rows) {
    table.rows.push_back({{technique_text(row.technique, row.layers, row.size)},
                          {row.light},
                          {row.pose},
                          {number_text(row.hair.rmse)},
                          {number_text(row.hair.bias)},
                          {number_text(row.head.rmse)},
                          {number_text(row.head.bias)},
                          {row.size > 0 ? number_text(row.ms) : "-"}});
  }
  return table;
}

Table lights_table(const ShadowReport& report) {
  Table table;
  table.columns = {{"light"}, {"yaw, degrees", kNumbers}, {"pitch, degrees", kNumbers}};
  for (const ShadowLight& light : report.lights) {
    table.rows.push_back(
        {{light.name}, {fmt::format("{:.0f}", light.yaw_degrees)}, {fmt::format("{:.0f}", light.pitch_degrees)}});
  }
  return table;
}

}  // namespace

tl::expected<std::string, ToolError> shadow_page(const ReportHeading& heading, const ShadowReport& report,
                                                 const Plotter& plotter) {
  PlottedPage page("What shadows get wrong: " + heading.asset, plotter);
  page.paragraph(heading_text(heading));
  page.summary(shadow_summary(report));
  page.paragraph(shadow_method(report));
  page.table(totals_table(report));
  page.paragraph(
      "plain: a depth map, in which hair is solid or not there. deep: deep opacity maps, which count how much hair "
      "lies in "
      "each of their layers. A positive bias is light that leaks through, a negative one is light that is lost. Hair "
      "counts by its alpha, as far as the head leaves it in the light; of the head, the side that is turned to the "
      "light.");
  page.plot(sizes_figure(report));
  page.plot(cost_figure(report));
  page.heading("The lights");
  page.table(lights_table(report));
  page.heading("Every measurement");
  page.table(rows_table(report));
  return page.finish();
}

}  // namespace coif
