#pragma once

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

/// A diagram as data. Points that an axis cannot show (not finite, or not above zero on a logarithmic one) are left
/// out.
struct Plot {
  std::string title{};
  std::string x_label{};
  std::string y_label{};
  bool log_x = false;
  bool log_y = false;
  std::vector<double> x_ticks{};  ///< Empty: chosen by the range.
  std::vector<PlotSeries> series{};
  std::vector<PlotMarker> markers{};

  /// Adds a series in the next colour. The reference holds until the next is added.
  PlotSeries& add(std::string name, std::vector<PlotPoint> points = {},
                  PlotSeries::Style style = PlotSeries::Style::kLinePoints);
};

/// A diagram and what is to be seen in it.
struct Figure {
  Plot plot;
  std::string caption;
};

/// The plot as an <svg> element, well-formed as XML; its lines and letters take the page's colour. `prefix` goes before
/// its ids, so that several can stand in one document.
[[nodiscard]] std::string draw(const Plot& plot, std::string_view prefix = "");

}  // namespace coif
