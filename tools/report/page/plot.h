#pragma once

#include "base/tool_error.h"
#include "report/page/html_page.h"

#include <tl/expected.hpp>

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

struct PlotPoint {
  double x = 0;
  double y = 0;
};

struct PlotSeries {
  enum class Style {
    kLine,
    kDashedLine,  ///< Grey: joins others' points.
    kPoints,
    kLinePoints,
  };

  std::string name;  ///< In the legend; empty: not there.
  std::vector<PlotPoint> points;
  Style style = Style::kLinePoints;
  std::vector<PlotPoint> marked;  ///< Drawn with a ring around them: the points of a Pareto front.
  unsigned color = 0;             ///< Index into a palette that goes round; also chooses the shape of the points.
};

/// A straight line across the whole plot: a budget, a frame rate.
struct PlotMarker {
  bool vertical = false;
  double at = 0;
  std::string label;
};

/// A diagram as data. Points that an axis cannot show (not finite, or not above zero on a logarithmic one) are left out.
struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool log_x = false;
  bool log_y = false;
  std::vector<double> x_ticks;  ///< Empty: chosen by the range.
  std::vector<PlotSeries> series;
  std::vector<PlotMarker> markers;
};

/// A diagram and what is to be seen in it.
struct Figure {
  Plot plot;
  std::string caption;
};

/// The plot as a gnuplot 5 script that writes SVG to its standard output. The data are in it; texts are quoted so that
/// gnuplot expands nothing in them.
[[nodiscard]] std::string plot_script(const Plot& plot);

/// The program that draws.
struct Plotter {
  std::string program = "gnuplot";                                ///< A name in PATH, or a path.
  std::chrono::milliseconds patience = std::chrono::seconds(20);  ///< Per plot; then it is killed.
};

/// Draws by gnuplot in a child process that reads its script and writes its picture through pipes and can write no
/// file. Returns an <svg> element for HtmlPage::figure(); its lines and letters take the page's colour. Errors:
/// kUnsupported with the cure where gnuplot is not installed, kInternal where it fails or takes too long.
tl::expected<std::string, ToolError> draw(const Plot& plot, const Plotter& plotter = {});

/// Tells before long work whether draw() will find its program. Errors: those of draw().
tl::expected<void, ToolError> check_plotter(const Plotter& plotter = {});

/// A page under way whose figures gnuplot draws. After the first that fails the rest is skipped, and there is no page.
class PlottedPage : public HtmlPage {
 public:
  /// `plotter` must outlive this object.
  PlottedPage(std::string_view title, const Plotter& plotter) : HtmlPage(title), plotter_(plotter) {}

  void plot(const Figure& figure);

  /// The whole document. Errors: those of draw().
  [[nodiscard]] tl::expected<std::string, ToolError> finish() const;

 private:
  const Plotter& plotter_;
  tl::expected<void, ToolError> drawn_;
};

}  // namespace coif
