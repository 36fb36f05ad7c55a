#include "report/page/order_page.h"

#include "report/page/order_plots.h"
#include "report/page/order_summary.h"
#include "report/page/order_tables.h"
#include "report/page/plotted_page.h"
#include "report/page/report_frame.h"

#include <fmt/format.h>

namespace coif {
namespace {

constexpr const char* kWhatOrdersAre =
    "file: as the source file has the patches. head: by distance from the head, the thesis's. best: the best single "
    "order "
    "that the cooker found. view: as cooked, an order for each group of directions. bones: bones sorted while drawing. "
    "triangles: each triangle sorted for each picture, what no cooked order needs.";

void add_orders(const OrderReport& report, PlottedPage& page) {
  page.heading("How wrong is each order?");
  for (const std::string& pose : poses_of(report)) page.plot(order_views_figure(report, pose));
  page.table(orders_table(report));
  page.paragraph(kWhatOrdersAre);
  for (const OrderLeftOut& left_out : report.left_out) {
    page.paragraph(fmt::format("Left out: {}; {}.", left_out.what, left_out.why));
  }
}

void add_modes(const OrderReport& report, PlottedPage& page) {
  if (report.modes.empty()) return;
  page.heading("What does each way to draw cost, and get right?");
  page.plot(order_cost_figure(report));
  page.table(order_modes_table(report));
  page.paragraph(
      "With the asset's own orders, of which only blend takes notice. Modes of several samples smooth the borders of "
      "cards, which "
      "the exact picture does not: that is part of their difference. Modes that show some pixels and leave out others "
      "are "
      "wrong in most pixels and right on average over several.");
}

void add_thresholds(const OrderReport& report, PlottedPage& page) {
  if (report.thresholds.empty()) return;
  page.heading("Which alpha should count as solid?");
  page.plot(thresholds_figure(report));
  page.table(thresholds_table(report));
  page.paragraph("Orders and the textures' smaller mips are those made for the asset's own threshold.");
}

void add_distances(const OrderReport& report, PlottedPage& page) {
  if (report.distance.empty()) return;
  page.heading("Does hair get thin far away?");
  page.plot(order_distances_figure(report));
  page.table(order_distances_table(report));
}

void add_worst(const OrderReport& report, PlottedPage& page) {
  page.heading("Where is each at its worst?");
  page.paragraph(
      "Exact order on the left, the way that is named in the middle, four times their difference on the right.");
  for (const WorstPicture& picture : report.worst) {
    page.picture(picture.png, fmt::format("{}, {}: {:.1f} dB from yaw {:.0f}, pitch {:.0f} degrees", picture.name,
                                          picture.pose, picture.psnr_db, picture.yaw_degrees, picture.pitch_degrees));
  }
}

}  // namespace

tl::expected<std::string, ToolError> order_page(const ReportHeading& heading, const OrderReport& report,
                                                const Plotter& plotter) {
  PlottedPage page("The picture's error: " + heading.asset, plotter);
  page.paragraph(heading_text(heading));
  page.summary(order_summary(report));
  page.paragraph(order_method(report));
  add_orders(report, page);
  add_modes(report, page);
  add_thresholds(report, page);
  add_distances(report, page);
  page.heading("How exact is the reference?");
  page.table(order_reference_table(report));
  add_worst(report, page);
  return page.finish();
}

}  // namespace coif
