#include "report/page/accuracy_page.h"

#include "report/page/accuracy_means.h"
#include "report/page/accuracy_plots.h"
#include "report/page/accuracy_summary.h"
#include "report/page/accuracy_tables.h"
#include "report/page/plotted_page.h"
#include "report/page/report_frame.h"

#include <fmt/format.h>

namespace coif {
namespace {

class AccuracyPage {
 public:
  AccuracyPage(const ReportHeading& heading, const AccuracyReport& report, const Plotter& plotter)
      : report_(report), page_("Error against run time: " + heading.asset, plotter) {
    page_.paragraph(heading_text(heading));
    page_.summary(accuracy_summary(report));
  }

  void add_comparison() {
    page_.heading("What each solver costs and gets right");
    page_.plot(work_precision_figure(report_));
    page_.table(settings_table(report_));
    page_.paragraph(fmt::format(
        "All motions at {} frames per second. Steps are sub-steps of a frame, or iterations for solvers that repeat "
        "their constraints instead. Errors are distances of chain tips, seen from the head, in % of the chain's "
        "length; stretch is in % of a bone's length; penetration is how deep a bone's end is in a collider, in % of "
        "the "
        "collider's radius, and beside it the same of whole bones. Time is of one core.",
        main_frame_rate(report_)));
  }

  void add_frame_rates() {
    page_.heading("Does it look the same at every frame rate?");
    page_.paragraph(
        "A solver whose error is large and changes with the frame rate makes hair that looks different on every "
        "machine; one whose error is small everywhere looks the same everywhere.");
    for (const std::string& motion : motions_of(report_)) page_.plot(frame_rate_figure(report_, motion));
    page_.plot(stretch_figure(report_));
    page_.paragraph("Frame-rate spread: the largest RMS difference between any two frame rates, in % of the length.");
    page_.table(spread_table(report_));
  }

  void add_reference() {
    page_.heading("How exact is the reference?");
    page_.paragraph(reference_summary(report_));
    page_.table(reference_table(report_));
    page_.heading("Where does the hair come to rest?");
    page_.paragraph("RMS distance of the tips under a still head to the reference's rest, in % of the length.");
    page_.table(settle_table(report_));
  }

  void add_rows() {
    page_.heading("Every measurement");
    page_.table(rows_table(report_));
  }

  [[nodiscard]] tl::expected<std::string, ToolError> finish() const { return page_.finish(); }

 private:
  const AccuracyReport& report_;
  PlottedPage page_;
};

}  // namespace

tl::expected<std::string, ToolError> accuracy_page(const ReportHeading& heading, const AccuracyReport& report,
                                                   const Plotter& plotter) {
  AccuracyPage page(heading, report, plotter);
  page.add_comparison();
  page.add_frame_rates();
  page.add_reference();
  page.add_rows();
  return page.finish();
}

}  // namespace coif
