#include "report/cards/cards_report.h"

#include <fmt/format.h>

#include <functional>

namespace coif {
namespace {

constexpr const char* kWhatBaselinesAre =
    "coif: as a cook makes them. kmeans: each cluster of strands, by the k-means of their whole shape, on one flat "
    "card of two "
    "triangles, the rectangle of the plane that fits it best. even: coif's locks of hair, each on a strip cut into "
    "equal segments, as "
    "many as come nearest to the strands with that many triangles. All have the same texels and textures drawn alike. "
    "Fragments "
    "are pixels of all triangles, whatever is on them, in a picture; layers, how many of them lie over each other "
    "where any does.";

using FigureOf = std::function<double(const CardsFigures&)>;

/// A curve for each way to make cards; the asset is a point.
Figure curves(const CardsReport& report, CardsAxis over, Plot plot, std::string caption, const FigureOf& figure_of) {
  const bool by_triangles = over == CardsAxis::kTriangles;
  plot.x_label = by_triangles ? "triangles" : "seconds to make";
  plot.log_x = true;
  for (const std::string& baseline : names_of(report.summary, &CardsSummary::baseline)) {
    PlotSeries& series = plot.add(cards_name(baseline));
    for (const CardsSummary& summary : report.summary) {
      if (summary.baseline != baseline) continue;
      const double x = by_triangles ? double(summary.made_triangles) : summary.seconds;
      series.points.push_back({x, figure_of(summary.figures)});
    }
  }
  if (by_triangles) {
    PlotSeries& asset = plot.add("the asset's levels", {}, PlotSeries::Style::kPoints);
    for (const CardsAssetLevel& level : report.asset) {
      asset.points.push_back({double(level.triangles), figure_of(level.figures)});
    }
  }
  return {std::move(plot), std::move(caption)};
}

std::string title_of(const char* what, CardsAxis over) {
  return fmt::format("{} over {}", what, over == CardsAxis::kTriangles ? "triangles" : "seconds");
}

}  // namespace

Figure cards_iou_figure(const CardsReport& report, CardsAxis over) {
  return curves(report, over, {.title = title_of("Coverage", over), .y_label = "coverage IoU, mean over directions"},
                "Higher is better: 1 covers what the strands cover and nothing else.",
                [](const CardsFigures& figures) { return figures.mean_iou; });
}

Figure cards_error_figure(const CardsReport& report, CardsAxis over) {
  return curves(report, over,
                {.title = title_of("Error of the picture", over), .y_label = "RMS error, mean over directions"},
                "Lower is better: of what a light at the eye shows, 1 is white.",
                [](const CardsFigures& figures) { return figures.mean_error; });
}

std::string cards_page(const ReportHeading& heading, const CardsReport& report) {
  HtmlPage page = report_page("How far cards are from strands", heading, cards_summary(report));
  page.paragraph(cards_method(report));
  page.table(page_table(cards_summary_columns(), report.summary));
  page.paragraph(kWhatBaselinesAre);
  for (const CardsLeftOut& left_out : report.left_out) {
    page.paragraph(fmt::format("Left out: {} with {} triangles; {}.", cards_name(left_out.baseline), left_out.triangles,
                               left_out.why));
  }
  for (const CardsAxis over : {CardsAxis::kTriangles, CardsAxis::kSeconds}) {
    page.figure(cards_iou_figure(report, over));
    page.figure(cards_error_figure(report, over));
  }
  page.heading("What did the cook keep?");
  page.paragraph(
      "The asset's own triangles at rest, with the alpha of its largest mip and its tangents, level by level.");
  page.table(page_table(cards_asset_columns(), report.asset));
  if (!report.sheets.empty()) page.heading("How do they look?");
  for (const CardsSheet& sheet : report.sheets) page.picture(sheet.png, sheet.caption);
  page.heading("Every direction");
  page.table(page_table(cards_columns(), report.rows));
  return page.text();
}

}  // namespace coif
