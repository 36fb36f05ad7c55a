#include "report/page/accuracy_page.h"

#include "report/page/accuracy_means.h"
#include "report/page/accuracy_plots.h"
#include "report/page/accuracy_summary.h"
#include "report/page/accuracy_tables.h"
#include "report/page/html_page.h"
#include "report/page/report_frame.h"

#include <fmt/format.h>

namespace coif {
namespace {

/// A page under way. After the first figure that fails the rest is skipped.
class AccuracyPage {
 public:
  AccuracyPage(const ReportHeading& heading, const AccuracyReport& report, const Plotter& plotter)
      : report_(report), plotter_(plotter), page_("Error against run time: " + heading.asset) {
    page_.paragraph(heading_text(heading));
    page_.summary(accuracy_summary(report));
  }

  void add_comparison() {
    page_.heading("What each solver costs and gets right");
    figure(work_precision_figure(report_));
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
    for (const std::string& motion : motions_of(report_)) figure(frame_rate_figure(report_, motion));
    figure(stretch_figure(report_));
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

  [[nodiscard]] tl::expected<std::string, ToolError> finish() const {
    if (!drawn_) return tl::unexpected(drawn_.error());
    return page_.text();
  }

 private:
  void figure(const Figure& figure) {
    if (!drawn_) return;
    const auto svg = draw(figure.plot, plotter_);
    if (svg) {
      page_.figure(*svg, figure.caption);
    } else {
      drawn_ = tl::unexpected(svg.error());
    }
  }

  const AccuracyReport& report_;
  const Plotter& plotter_;
  HtmlPage page_;
  tl::expected<void, ToolError> drawn_;
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
