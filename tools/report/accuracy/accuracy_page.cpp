#include "report/accuracy/accuracy_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

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
  const auto solvers = names_of(report.rows, &AccuracyRow::solver);
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
  for (const AccuracyRow& mean : means_over_motions(report, main_frame_rate(report))) {
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

/// Removes points above the scale, and says so in the caption where there were any.
void leave_out_off_the_scale(Figure& figure) {
  const auto above = [](const PlotPoint& point) { return point.y > kOffTheScalePct; };
  std::size_t removed = 0;
  for (PlotSeries& series : figure.plot.series) {
    removed += std::erase_if(series.points, above);
    std::erase_if(series.marked, above);
  }
  if (removed > 0) figure.caption += kOffTheScaleNote;
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

void add_front(const std::vector<AccuracyRow>& means, Plot& plot) {
  PlotSeries& front = plot.add("Pareto front", {}, PlotSeries::Style::kDashedLine);
  for (const AccuracyRow& mean : means) {
    if (mean.pareto) front.points.push_back({mean.ns_per_bone_frame, mean.rms_error_pct});
  }
  sort_by_x(front.points);
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

/// With an axis of frame rates.
Figure over_rates(const AccuracyReport& report, std::string title, std::string caption) {
  Figure figure{{.title = std::move(title), .x_label = "frames per second", .log_x = true}, std::move(caption)};
  figure.plot.x_ticks = frame_rates(report);
  return figure;
}

/// Of whose code the times are: what ships, with all that a game gets, and studies of methods.
constexpr const char* kWhoseCode =
    " Times are not of equal code: coif, cascade, passive and thesis are the library itself, single precision in "
    "vectors of sixteen "
    "lanes, of which one head uses as many as it has chains of a shape, bone matrices included; the others are this "
    "report's own, "
    "double precision, one bone after the other, without matrices.";

Figure over_cost(std::string title, std::string caption) {
  caption += kWhoseCode;
  return {{.title = std::move(title), .x_label = "ns per bone and frame, one core", .log_x = true, .log_y = true},
          std::move(caption)};
}

/// A curve of a solver's figure with its fewest sub-steps over frame rates, in one motion or (null) the worst of all.
void add_solver(const AccuracyReport& report, const std::string& solver, double AccuracyRow::*value,
                const std::string* motion, Plot& plot) {
  const std::uint32_t substeps = fewest_substeps(report, solver);
  auto points = over_frame_rates(report, value, [&](const AccuracyRow& row) {
    return row.solver == solver && row.substeps == substeps && (motion == nullptr || row.motion == *motion);
  });
  plot.add(setting_text(solver, substeps), std::move(points)).color = color_of(report, solver);
}

}  // namespace

Figure work_precision_figure(const AccuracyReport& report) {
  const double fps = main_frame_rate(report);
  const auto means = means_over_motions(report, fps);
  Figure figure =
      over_cost(fmt::format("Error against cost at {} frames per second", fps),
                "Every point is one solver with one number of sub-steps or iterations, over all motions; further left "
                "is cheaper, further down more exact. Ringed points are the Pareto front: whatever is not on it is "
                "beaten in both by something that is.");
  figure.plot.y_label = "RMS error, % of the chain's length";
  for (const std::string& solver : names_of(report.rows, &AccuracyRow::solver)) {
    PlotSeries& series = figure.plot.add(solver);
    for (const AccuracyRow& mean : means) {
      if (mean.solver != solver) continue;
      series.points.push_back({mean.ns_per_bone_frame, mean.rms_error_pct});
      if (mean.pareto) series.marked.push_back(series.points.back());
    }
    sort_by_x(series.points);
  }
  add_front(means, figure.plot);
  if (std::isfinite(report.budget_rms_pct)) figure.plot.markers.push_back({false, report.budget_rms_pct, "budget"});
  leave_out_off_the_scale(figure);
  return figure;
}

Figure own_model_figure(const AccuracyReport& report) {
  const double fps = main_frame_rate(report);
  const auto means = means_over_motions(report, fps);
  Figure figure =
      over_cost(fmt::format("Error against each solver's own model at {} frames per second", fps),
                "What more steps can mend: how far each solver is from where it comes itself with ever finer steps. "
                "How far that is "
                "from the asset's own motion is in the table, and no number of steps changes it. Algorithm 1 and the "
                "thesis's attempts "
                "before it are not here: their strengths are shares of a step, and finer steps come to other hair.");
  figure.plot.y_label = "RMS distance to its own converged motion, % of the chain's length";
  for (const std::string& solver : names_of(report.rows, &AccuracyRow::solver)) {
    std::vector<PlotPoint> points;
    for (const AccuracyRow& mean : means) {
      if (mean.solver == solver && std::isfinite(mean.own_error_pct)) {
        points.push_back({mean.ns_per_bone_frame, mean.own_error_pct});
      }
    }
    if (points.empty()) continue;
    sort_by_x(points);
    // As in the other figures, which have more solvers.
    figure.plot.add(solver, std::move(points)).color = color_of(report, solver);
  }
  leave_out_off_the_scale(figure);
  return figure;
}

Figure frame_rate_figure(const AccuracyReport& report, const std::string& motion) {
  Figure figure = over_rates(
      report, "Error against frame rate: " + motion,
      fmt::format("{}: how far the tips are from the exact motion, one step a frame where possible.", motion));
  figure.plot.y_label = "RMS error, % of the chain's length";
  figure.plot.log_y = true;
  for (const std::string& solver : solvers_shown(report)) {
    add_solver(report, solver, &AccuracyRow::rms_error_pct, &motion, figure.plot);
  }
  mark_self_difference(report, motion, figure.plot);
  leave_out_off_the_scale(figure);
  return figure;
}

Figure stretch_figure(const AccuracyReport& report) {
  Figure figure = over_rates(report, "Worst stretch against frame rate, all motions",
                             "Hair that stretches shows as rubber; 0 is a bone that keeps its length.");
  figure.plot.y_label = "stretch of a bone, % of its length";
  for (const std::string& solver : names_of(report.rows, &AccuracyRow::solver)) {
    add_solver(report, solver, &AccuracyRow::stretch_max_pct, nullptr, figure.plot);
  }
  leave_out_off_the_scale(figure);
  return figure;
}

Figure swing_figure(const SwingPath& path) {
  constexpr double kShown = 2.5;  // seconds
  Figure figure{{.title = "Swing of " + path.chain,
                 .x_label = "seconds since the head began to charge",
                 .y_label = "mm behind where the tip began"},
                "From 0 to 8 m/s in 0.3 s, at 60 frames per second, seen from the head. Above the axis the tip is "
                "thrown back, below "
                "it swings past where it began."};
  const auto add = [&](const char* name, const std::vector<double>& behind) {
    PlotSeries& series = figure.plot.add(name, {}, PlotSeries::Style::kLine);
    for (std::size_t i = 0; i < behind.size() && double(i) * path.seconds_per_frame < kShown; ++i) {
      series.points.push_back({double(i + 1) * path.seconds_per_frame, 1000 * behind[i]});
    }
  };
  add("as cooked", path.behind_m);
  add("Algorithm 1", path.artist_behind_m);
  return figure;
}

Table settings_table(const AccuracyReport& report) {
  return page_table(accuracy_columns(report.budget_rms_pct).without({"motion", "fps"}),
                    means_over_motions(report, main_frame_rate(report)));
}

std::string accuracy_page(const ReportHeading& heading, const AccuracyReport& report) {
  HtmlPage page = report_page("Error against run time", heading, accuracy_summary(report), accuracy_link(report));
  page.heading("What each solver costs and gets right");
  page.figure(work_precision_figure(report));
  page.figure(own_model_figure(report));
  page.table(settings_table(report));
  page.paragraph(
      fmt::format("All motions at {} frames per second. Steps are sub-steps of a frame, or iterations for solvers that "
                  "repeat their "
                  "constraints instead. Errors are distances of chain tips, seen from the head, in % of the chain's "
                  "length; stretch "
                  "is in % of a bone's length; penetration is how deep a bone's end is in a collider, in % of the "
                  "collider's radius, "
                  "and beside it the same of whole bones. Time is the least that one thread took of several runs, of "
                  "its processor's own clock: other "
                  "programs do not count. Where it is less than with fewer steps the machine was disturbed all the "
                  "same, and the row says so.",
                  main_frame_rate(report)));
  page.heading("Does it look the same at every frame rate?");
  page.paragraph(
      "A solver whose error is large and changes with the frame rate makes hair that looks different on every machine; "
      "one whose error is small everywhere looks the same everywhere.");
  for (const std::string& motion : names_of(report.rows, &AccuracyRow::motion)) {
    page.figure(frame_rate_figure(report, motion));
    page.links("See " + motion + " at so many frames per second: ", motion_links(heading, report, motion));
  }
  page.figure(stretch_figure(report));
  page.paragraph("Frame-rate spread: the largest RMS difference between any two frame rates, in % of the length.");
  page.table(spread_table(report));
  page.heading("How exact is the reference?");
  page.paragraph(reference_summary(report));
  page.table(page_table(reference_columns(report.budget_rms_pct), report.reference));
  for (const std::string& sentence : {own_reference_summary(report), numbers_read(report), velocities_told(report)}) {
    if (!sentence.empty()) page.paragraph(sentence);
  }
  page.paragraph(
      "The same of the other methods' own models: each run twice, the second time with steps of double length.");
  page.table(page_table(own_reference_columns(report.budget_rms_pct), report.own_reference));
  page.heading("Where does the hair come to rest?");
  page.paragraph("RMS distance of the tips under a still head to the reference's rest, in % of the length.");
  page.table(page_table(settle_columns(report.budget_rms_pct), report.settle));
  if (!report.swings.rows.empty()) {
    page.heading("How does it swing?");
    page.paragraph(
        "After a charge from 0 to 8 m/s in 0.3 s, at 60 frames per second: how far each tip is thrown, how far it then "
        "comes to the other side, and when it stays within a twentieth of the first. As the asset asks for, and by "
        "Algorithm 1 "
        "with the artist's resistance and friction and eight iterations; apart is the RMS distance of the two, their "
        "different rests "
        "included.");
    page.figure(swing_figure(report.swings.longest));
    page.table(page_table(swing_columns(), report.swings.rows));
  }
  if (!report.stroke.empty()) {
    page.heading("With a hand in it");
    page.paragraph(
        "On a character, a hand stroking the hair of a head that stands still: against the same solver, told of the "
        "same hand "
        "3840 times a second. What that differs by from half as many steps is beside it: smaller errors say nothing. "
        "Penetration is the deepest that any part of a bone was in the hand, in % of the hand's radius, bones that "
        "start in there "
        "aside.");
    page.table(page_table(stroke_columns(), report.stroke));
  }
  page.heading("Every measurement");
  page.table(page_table(accuracy_columns(report.budget_rms_pct), report.rows));
  return page.text();
}

}  // namespace coif
