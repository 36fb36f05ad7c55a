#include "base/json.h"
#include "report/accuracy/show_accuracy.h"
#include "report/page/plot.h"
#include "report/page/report_heading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace coif {
namespace {

// Hair that is ten lengths off has no look to compare; one such point would squeeze all the others into a line.
constexpr double kOffTheScalePct = 1000;
constexpr const char* kOffTheScaleNote = " Values above 1000 % are left out.";

constexpr const char* kRuntimeSolvers[] = {"coif", "thesis"};
constexpr std::size_t kOthersShown = 2;

bool is_runtime(const std::string& solver) {
  return std::ranges::find(kRuntimeSolvers, solver) != std::end(kRuntimeSolvers);
}

/// The same solver has the same colour in every plot of a report.
unsigned color_of(const AccuracyReport& report, const std::string& solver) {
  const auto solvers = solvers_of(report);
  return unsigned(std::ranges::find(solvers, solver) - solvers.begin());
}

std::uint32_t fewest_substeps(const AccuracyReport& report, const std::string& solver) {
  std::uint32_t fewest = ~0u;
  for (const AccuracyRow& row : report.rows) {
    if (row.solver == solver) fewest = std::min(fewest, row.substeps);
  }
  return fewest;
}

/// The runtime's solvers, then those others that are least wrong at the main frame rate with their fewest sub-steps.
std::vector<std::string> solvers_shown(const AccuracyReport& report) {
  std::vector<std::string> shown, others;
  std::map<std::string, double> errors;
  for (const SettingMean& mean : means_over_motions(report, main_frame_rate(report))) {
    if (mean.substeps != fewest_substeps(report, mean.solver)) continue;
    errors[mean.solver] = std::isfinite(mean.rms_error_pct) ? mean.rms_error_pct : HUGE_VAL;
    (is_runtime(mean.solver) ? shown : others).push_back(mean.solver);
  }
  std::ranges::stable_sort(others, {}, [&errors](const std::string& solver) { return errors[solver]; });
  others.resize(std::min(others.size(), kOthersShown));
  shown.insert(shown.end(), others.begin(), others.end());
  return shown;
}

std::vector<double> frame_rates(const AccuracyReport& report) {
  std::vector<double> rates;
  for (const AccuracyRow& row : report.rows) rates.push_back(row.fps);
  std::ranges::sort(rates);
  rates.erase(std::unique(rates.begin(), rates.end()), rates.end());
  return rates;
}

void sort_by_x(std::vector<PlotPoint>& points) { std::ranges::stable_sort(points, {}, &PlotPoint::x); }

/// Removes points above the scale; true where there were any.
bool drop_off_the_scale(Plot& plot) {
  bool dropped = false;
  for (PlotSeries& series : plot.series) {
    const auto above = [](const PlotPoint& point) { return point.y > kOffTheScalePct; };
    dropped |= std::erase_if(series.points, above) > 0;
    std::erase_if(series.marked, above);
  }
  return dropped;
}

void finish(Figure& figure) {
  if (drop_off_the_scale(figure.plot)) figure.caption += kOffTheScaleNote;
}

/// Over frame rates, from rows that `wanted` takes; of several at one rate the worst counts.
template <typename Wanted>
std::vector<PlotPoint> over_frame_rates(const AccuracyReport& report, double AccuracyRow::*value, Wanted wanted) {
  std::map<double, double> worst;
  for (const AccuracyRow& row : report.rows) {
    if (!wanted(row)) continue;
    const auto [it, is_new] = worst.emplace(row.fps, row.*value);
    // A NaN stays: what failed in one motion has no worst value.
    if (!is_new && !(row.*value <= it->second)) it->second = std::isnan(it->second) ? it->second : row.*value;
  }
  std::vector<PlotPoint> points;
  for (const auto& [fps, number] : worst) points.push_back({fps, number});
  return points;
}

PlotSeries front_of(const std::vector<SettingMean>& means) {
  PlotSeries front;
  front.name = "Pareto front";
  front.style = PlotSeries::Style::kDashedLine;
  for (const SettingMean& mean : means) {
    if (mean.pareto) front.points.push_back({mean.ns_per_bone_frame, mean.rms_error_pct});
  }
  sort_by_x(front.points);
  return front;
}

/// Where the reference's own doubt matters for what is drawn.
void mark_self_difference(const AccuracyReport& report, const std::string& motion, Plot& plot) {
  double least = HUGE_VAL;
  for (const PlotSeries& series : plot.series) {
    for (const PlotPoint& point : series.points) {
      if (point.y > 0) least = std::min(least, point.y);
    }
  }
  for (const ReferenceRow& row : report.reference) {
    if (row.motion != motion || !(row.self_difference_pct > 0.1 * least)) continue;
    plot.markers.push_back(
        {false, row.self_difference_pct,
         fmt::format("the reference agrees with itself to {}", percent_text(row.self_difference_pct))});
  }
}

Plot frame_rate_plot(const AccuracyReport& report) {
  Plot plot;
  plot.x_label = "frames per second";
  plot.log_x = true;
  plot.x_ticks = frame_rates(report);
  return plot;
}

}  // namespace

Figure work_precision_figure(const AccuracyReport& report) {
  const double fps = main_frame_rate(report);
  const auto means = means_over_motions(report, fps);
  Figure figure;
  Plot& plot = figure.plot;
  plot.title = fmt::format("Error against cost at {} frames per second", fps);
  plot.x_label = "ns per bone and frame, one core";
  plot.y_label = "RMS error, % of the chain's length";
  plot.log_x = plot.log_y = true;
  for (const std::string& solver : solvers_of(report)) {
    PlotSeries series;
    series.name = solver;
    series.color = color_of(report, solver);
    for (const SettingMean& mean : means) {
      if (mean.solver != solver) continue;
      series.points.push_back({mean.ns_per_bone_frame, mean.rms_error_pct});
      if (mean.pareto) series.marked.push_back(series.points.back());
    }
    sort_by_x(series.points);
    plot.series.push_back(series);
  }
  plot.series.push_back(front_of(means));
  if (std::isfinite(report.budget_rms_pct)) {
    plot.markers.push_back({false, report.budget_rms_pct, "budget"});
  }
  figure.caption =
      "Every point is one solver with one number of sub-steps or iterations, over all motions; further left is "
      "cheaper, further down "
      "more exact. Ringed points are the Pareto front: whatever is not on it is beaten in both by something that is.";
  finish(figure);
  return figure;
}

Figure frame_rate_figure(const AccuracyReport& report, const std::string& motion) {
  Figure figure{frame_rate_plot(report), ""};
  Plot& plot = figure.plot;
  plot.title = "Error against frame rate: " + motion;
  plot.y_label = "RMS error, % of the chain's length";
  plot.log_y = true;
  for (const std::string& solver : solvers_shown(report)) {
    const std::uint32_t substeps = fewest_substeps(report, solver);
    PlotSeries series;
    series.name = setting_text(solver, substeps);
    series.color = color_of(report, solver);
    series.points = over_frame_rates(report, &AccuracyRow::rms_error_pct, [&](const AccuracyRow& row) {
      return row.motion == motion && row.solver == solver && row.substeps == substeps;
    });
    plot.series.push_back(series);
  }
  mark_self_difference(report, motion, plot);
  figure.caption =
      fmt::format("{}: how far the tips are from the exact motion, one step a frame where possible.", motion);
  finish(figure);
  return figure;
}

Figure stretch_figure(const AccuracyReport& report) {
  Figure figure{frame_rate_plot(report), ""};
  Plot& plot = figure.plot;
  plot.title = "Worst stretch against frame rate, all motions";
  plot.y_label = "stretch of a bone, % of its length";
  for (const std::string& solver : solvers_of(report)) {
    const std::uint32_t substeps = fewest_substeps(report, solver);
    PlotSeries series;
    series.name = setting_text(solver, substeps);
    series.color = color_of(report, solver);
    series.points = over_frame_rates(report, &AccuracyRow::stretch_max_pct, [&](const AccuracyRow& row) {
      return row.solver == solver && row.substeps == substeps;
    });
    plot.series.push_back(series);
  }
  figure.caption = "Hair that stretches shows as rubber; 0 is a bone that keeps its length.";
  finish(figure);
  return figure;
}

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
