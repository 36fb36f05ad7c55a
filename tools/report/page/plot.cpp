#include "report/page/plot.h"

#include "base/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace coif {
namespace {

// Bright enough for a dark page, dark enough for a light one; told apart by the shape of the points as well.
constexpr std::array kColors{"#2f8fd8", "#e0662f", "#2aa876", "#c05fb5", "#c79a1e", "#d9486e",
                             "#4fb3c8", "#8f7be0", "#a5744a", "#7fa832", "#d98cae", "#5d86a8"};
constexpr std::array kPointShapes{7, 5, 9, 13, 11, 15, 6, 4, 8, 12, 10, 14};

// Of whatever is not data.
constexpr const char* kGrey = "#8a93a3";

constexpr const char* kTerminal =
    "set terminal svg size 900,480 dynamic noenhanced font 'sans-serif,13' linewidth 1.2\n"
    "set encoding utf8\n"
    "set key outside right top noenhanced\n"
    "set border lw 0.8\n"
    "set format '%g'\n"
    "set grid lc rgb '#8a93a3' lw 0.5 dt 3\n";

// In single quotes gnuplot expands nothing: no macro, no command, no escape. Its rule for a quote within them does not
// hold at their beginning, so texts have typographic quotes.
std::string plain_quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : clean_text(text)) {
    switch (c) {
      case '\'': result += "\u2019"; break;
      case '`': result += "\u2018"; break;
      default: result += c;
    }
  }
  return result + "'";
}

/// Extent of what is drawn along one axis.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] bool is_empty() const { return low > high; }
};

bool fits(double value, bool logarithmic) { return std::isfinite(value) && (!logarithmic || value > 0); }

std::vector<PlotPoint> drawable(const Plot& plot, const std::vector<PlotPoint>& points) {
  std::vector<PlotPoint> result;
  std::ranges::copy_if(points, std::back_inserter(result), [&plot](const PlotPoint& point) {
    return fits(point.x, plot.log_x) && fits(point.y, plot.log_y);
  });
  return result;
}

std::string data_block(std::string_view name, const std::vector<PlotPoint>& points) {
  std::string text = fmt::format("${} << END\n", name);
  for (const PlotPoint& point : points) text += fmt::format("{:.9g} {:.9g}\n", point.x, point.y);
  return text + "END\n";
}

/// 1, 2 and 5 of every decade, or its powers alone where there are many. gnuplot by itself leaves a range within one
/// decade without a single number.
std::vector<double> log_ticks(const Range& range) {
  const double first = std::floor(std::log10(range.low)), last = std::ceil(std::log10(range.high));
  std::vector<double> ticks;
  for (double decade = first; decade <= last; ++decade) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      if (digit == 1.0 || last - first <= 3) ticks.push_back(digit * std::pow(10.0, decade));
    }
  }
  return ticks;
}

std::string axis(char name, bool logarithmic, Range range, std::vector<double> ticks) {
  std::string text;
  if (range.is_empty()) return fmt::format("set {}range [1:10]\n", name);
  if (logarithmic) {
    constexpr double kMargin = 1.2;
    range = {range.low / kMargin, range.high * kMargin};
    text = fmt::format("set logscale {0}\nset {0}range [{1:.9g}:{2:.9g}]\n", name, range.low, range.high);
    if (ticks.empty()) ticks = log_ticks(range);
  } else {
    // From 0 on where nothing is below it; the margin is of what is shown, or points at the top would be cut.
    const double shown = range.high - std::min(range.low, 0.0);
    const double margin = shown > 0 ? 0.05 * shown : 0.5;
    const double low = range.low >= 0 ? 0 : range.low - margin;
    text = fmt::format("set {}range [{:.9g}:{:.9g}]\n", name, low, range.high + margin);
  }
  if (!ticks.empty()) text += fmt::format("set {}tics ({:.9g})\n", name, fmt::join(ticks, ","));
  return text;
}

std::string marker_line(const PlotMarker& marker) {
  const std::string at = fmt::format("{:.9g}", marker.at);
  const std::string ends = marker.vertical ? fmt::format("first {0}, graph 0 to first {0}, graph 1", at)
                                           : fmt::format("graph 0, first {0} to graph 1, first {0}", at);
  const std::string place = marker.vertical ? fmt::format("first {}, graph 0.97 offset 0.5,0", at)
                                            : fmt::format("graph 0.99, first {} right offset 0,0.5", at);
  return fmt::format("set arrow from {} nohead back lc rgb '#8a93a3' lw 1.2 dt 2\nset label {} at {} font ',11'\n",
                     ends, plain_quoted(marker.label), place);
}

const char* style_of(PlotSeries::Style style) {
  switch (style) {
    case PlotSeries::Style::kLine:
    case PlotSeries::Style::kDashedLine: return "lines";
    case PlotSeries::Style::kPoints: return "points";
    case PlotSeries::Style::kLinePoints: return "linespoints";
  }
  return "points";
}

/// Data blocks and the clauses of the plot command that draw them.
class Curves {
 public:
  explicit Curves(const Plot& plot) {
    for (const PlotSeries& series : plot.series) {
      add(series, drawable(plot, series.points), drawable(plot, series.marked));
    }
  }

  Range x, y;
  std::string blocks;
  std::vector<std::string> clauses;

 private:
  void add(const PlotSeries& series, const std::vector<PlotPoint>& points, const std::vector<PlotPoint>& marked) {
    const std::string title = series.name.empty() ? "notitle" : "title " + plain_quoted(series.name);
    const bool dashed = series.style == PlotSeries::Style::kDashedLine;
    const char* const color = dashed ? kGrey : kColors[series.color % kColors.size()];
    add_block(points, fmt::format("with {} lc rgb '{}' lw 1.6 dt {} pt {} ps 0.7 {}", style_of(series.style), color,
                                  dashed ? 2 : 1, kPointShapes[series.color % kPointShapes.size()], title));
    add_block(marked, fmt::format("with points lc rgb '{}' lw 1.6 pt 6 ps 1.7 notitle", color));
  }

  void add_block(const std::vector<PlotPoint>& points, const std::string& looks) {
    if (points.empty()) return;
    for (const PlotPoint& point : points) {
      x.add(point.x);
      y.add(point.y);
    }
    const std::string name = fmt::format("data{}", clauses.size());
    blocks += data_block(name, points);
    clauses.push_back(fmt::format("${} using 1:2 {}", name, looks));
  }
};

}  // namespace

std::string plot_script(const Plot& plot) {
  Curves curves(plot);
  std::string script = kTerminal;
  script += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\n", plain_quoted(plot.title), plain_quoted(plot.x_label),
                        plain_quoted(plot.y_label));
  for (const PlotMarker& marker : plot.markers) {
    if (curves.clauses.empty() || !fits(marker.at, marker.vertical ? plot.log_x : plot.log_y)) continue;
    (marker.vertical ? curves.x : curves.y).add(marker.at);
    script += marker_line(marker);
  }
  script += axis('x', plot.log_x, curves.x, plot.x_ticks) + axis('y', plot.log_y, curves.y, {}) + curves.blocks;
  if (curves.clauses.empty()) {
    return script + "set label 'no data' at graph 0.5, graph 0.5 center\nplot NaN notitle\n";
  }
  return script + fmt::format("plot {}\n", fmt::join(curves.clauses, ", "));
}

}  // namespace coif
