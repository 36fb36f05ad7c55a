#include "report/page/plot.h"

#include "report/page/html_page.h"
#include "report/page/plot_axis.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace coif {
namespace {

// Bright enough for a dark page, dark enough for a light one; told apart by the shape of the points as well.
constexpr std::array kColors{"#2f8fd8", "#e0662f", "#2aa876", "#c05fb5", "#c79a1e", "#d9486e",
                             "#4fb3c8", "#8f7be0", "#a5744a", "#7fa832", "#d98cae", "#5d86a8"};
constexpr const char* kGrey = "#8a93a3";  // of whatever is not data

struct PointShape {
  int corners;  ///< 0: round.
  double turn;  ///< Of the first corner from the top, corners' distances.
};
constexpr PointShape kShapes[] = {{0, 0}, {4, 0.5}, {3, 0}, {4, 0}, {3, 0.5}, {5, 0}};  // filled, then hollow

// Pixels.
constexpr double kWidth = 900, kHeight = 480, kTop = 58, kBottom = 418, kLetter = 7.5, kLine = 20, kSample = 46;

bool fits(double value, bool logarithmic) {
  constexpr double kLargest = 1e300;  // so that ranges of such values are finite
  return std::abs(value) <= kLargest && (!logarithmic || value > 0);
}

std::vector<PlotPoint> drawable(const Plot& plot, const std::vector<PlotPoint>& points) {
  std::vector<PlotPoint> result;
  std::ranges::copy_if(points, std::back_inserter(result), [&plot](const PlotPoint& point) {
    return fits(point.x, plot.log_x) && fits(point.y, plot.log_y);
  });
  return result;
}

std::string tick_text(double tick) { return fmt::format("{:.6g}", tick); }

std::string line(double x1, double y1, double x2, double y2, std::string_view looks) {
  return fmt::format("<path d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\" {}/>\n", x1, y1, x2, y2, looks);
}

std::string label(double x, double y, std::string_view looks, std::string_view text) {
  return fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" {}>{}</text>\n", x, y, looks, markup_text(text));
}

std::string circle(double x, double y, double radius, std::string_view looks) {
  return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" {}/>\n", x, y, radius, looks);
}

std::string point_shape(double x, double y, unsigned color) {
  const PointShape& shape = kShapes[color % std::size(kShapes)];
  const bool is_hollow = color / std::size(kShapes) % 2 == 1;
  const std::string looks =
      fmt::format("fill=\"{}\" stroke=\"{}\"", is_hollow ? "none" : kColors[color % kColors.size()],
                  kColors[color % kColors.size()]);
  if (shape.corners == 0) return circle(x, y, 3.5, looks);
  std::string corners;
  for (int i = 0; i < shape.corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + shape.turn) / shape.corners;
    corners += fmt::format("{:.2f},{:.2f} ", x + 4.6 * std::sin(angle), y - 4.6 * std::cos(angle));
  }
  return fmt::format("<polygon points=\"{}\" {}/>\n", corners, looks);
}

class Drawing {
 public:
  Drawing(const Plot& plot, std::string_view prefix) : plot_(plot), prefix_(prefix), x_(plot.log_x), y_(plot.log_y) {
    for (const PlotSeries& series : plot.series) {
      curves_.push_back({drawable(plot, series.points), drawable(plot, series.marked)});
      for (const auto* points : {&curves_.back().points, &curves_.back().marked}) {
        is_empty_ = is_empty_ && points->empty();
        for (const PlotPoint& point : *points) {
          x_.add(point.x);
          y_.add(point.y);
        }
      }
    }
    for (const PlotMarker& marker : plot.markers) {
      if (is_shown(marker)) (marker.vertical ? x_ : y_).add(marker.at);
    }
    x_.close(plot.x_ticks);
    y_.close({});
    place();
  }

  std::string svg() {
    text_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" aria-labelledby=\"{}title\" "
        "font-family=\"sans-serif\" font-size=\"13\" fill=\"currentColor\">\n",
        kWidth, kHeight, prefix_);
    add_axes();
    for (const PlotMarker& marker : plot_.markers) {
      if (is_shown(marker)) add_marker(marker);
    }
    for (std::size_t i = 0; i < curves_.size(); ++i) add_curve(i);
    add_legend();
    if (is_empty_) text_ += label(middle_, (kTop + kBottom) / 2, "text-anchor=\"middle\"", "no data");
    return text_ + "</svg>";
  }

 private:
  struct Curve {
    std::vector<PlotPoint> points, marked;
  };

  [[nodiscard]] bool is_shown(const PlotMarker& marker) const {
    return !is_empty_ && fits(marker.at, marker.vertical ? plot_.log_x : plot_.log_y);
  }

  void place() {
    std::size_t tick = 0, name = 0;
    for (const double value : y_.ticks()) tick = std::max(tick, tick_text(value).size());
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (in_legend(i)) name = std::max(name, plot_.series[i].name.size());
    }
    const double legend = name > 0 ? kSample + kLetter * double(name) + 24 : 0;
    x_.set_pixels(44 + kLetter * double(tick), kWidth - 20 - legend);
    y_.set_pixels(kBottom, kTop);
    middle_ = (x_.first() + x_.last()) / 2;
  }

  [[nodiscard]] bool in_legend(std::size_t i) const {
    return !plot_.series[i].name.empty() && !(curves_[i].points.empty() && curves_[i].marked.empty());
  }

  void add_axes() {
    constexpr double kTick = 7;
    const std::string grid = fmt::format("stroke=\"{}\" stroke-width=\"0.6\" stroke-dasharray=\"2 4\"", kGrey);
    const std::string border = "fill=\"none\" stroke=\"currentColor\"";
    const double left = x_.first(), right = x_.last();
    for (const double tick : x_.ticks()) {
      const double x = x_.pixel(tick);
      text_ += line(x, kBottom, x, kTop, grid) + line(x, kBottom, x, kBottom - kTick, border) +
               line(x, kTop, x, kTop + kTick, border) +
               label(x, kBottom + 22, "text-anchor=\"middle\"", tick_text(tick));
    }
    for (const double tick : y_.ticks()) {
      const double y = y_.pixel(tick);
      text_ += line(left, y, right, y, grid) + line(left, y, left + kTick, y, border) +
               line(right, y, right - kTick, y, border) +
               label(left - 8, y + 4.5, "text-anchor=\"end\"", tick_text(tick));
    }
    text_ += fmt::format("<rect x=\"{:.2f}\" y=\"{}\" width=\"{:.2f}\" height=\"{}\" {}/>\n", left, kTop, right - left,
                         kBottom - kTop, border);
    text_ += label(middle_, 32, fmt::format("id=\"{}title\" text-anchor=\"middle\"", prefix_), plot_.title);
    text_ += label(middle_, kHeight - 12, "text-anchor=\"middle\"", plot_.x_label);
    const double y = (kTop + kBottom) / 2;
    text_ += label(18, y, fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 18 {})\"", y), plot_.y_label);
  }

  void add_marker(const PlotMarker& marker) {
    const std::string looks = fmt::format("stroke=\"{}\" stroke-width=\"1.4\" stroke-dasharray=\"6 5\"", kGrey);
    if (marker.vertical) {
      const double x = x_.pixel(marker.at);
      text_ += line(x, kBottom, x, kTop, looks) + label(x + 5, kTop + 15, "font-size=\"11\"", marker.label);
    } else {
      const double y = y_.pixel(marker.at);
      text_ += line(x_.first(), y, x_.last(), y, looks) +
               label(x_.last() - 8, y - 6, "font-size=\"11\" text-anchor=\"end\"", marker.label);
    }
  }

  [[nodiscard]] static std::string stroke(const PlotSeries& series) {
    if (series.style == PlotSeries::Style::kDashedLine) {
      return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.9\" stroke-dasharray=\"6 5\"", kGrey);
    }
    return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.9\"", kColors[series.color % kColors.size()]);
  }

  void add_curve(std::size_t i) {
    using Style = PlotSeries::Style;
    const PlotSeries& series = plot_.series[i];
    const bool has_shapes = series.style == Style::kPoints || series.style == Style::kLinePoints;
    text_ += fmt::format("<g id=\"{}series{}\">\n", prefix_, i);
    if (series.style != Style::kPoints && curves_[i].points.size() > 1) {
      std::vector<std::string> places;
      for (const PlotPoint& point : curves_[i].points) {
        places.push_back(fmt::format("{:.2f},{:.2f}", x_.pixel(point.x), y_.pixel(point.y)));
      }
      text_ += fmt::format("<polyline points=\"{}\" {}/>\n", fmt::join(places, " "), stroke(series));
    }
    for (const PlotPoint& point : curves_[i].points) {
      if (has_shapes) text_ += point_shape(x_.pixel(point.x), y_.pixel(point.y), series.color);
    }
    for (const PlotPoint& point : curves_[i].marked) {
      text_ += circle(x_.pixel(point.x), y_.pixel(point.y), 8.5, stroke(series));
    }
    text_ += "</g>\n";
  }

  void add_legend() {
    const double left = x_.last() + 24;
    double y = kTop + 10;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (!in_legend(i)) continue;
      const PlotSeries& series = plot_.series[i];
      using Style = PlotSeries::Style;
      if (series.style != Style::kPoints) text_ += line(left, y, left + kSample, y, stroke(series));
      if (series.style == Style::kPoints || series.style == Style::kLinePoints) {
        text_ += point_shape(left + kSample / 2, y, series.color);
      }
      text_ += label(left + kSample + 8, y + 4.5, "", series.name);
      y += kLine;
    }
  }

  const Plot& plot_;
  std::string_view prefix_;
  PlotAxis x_, y_;
  std::vector<Curve> curves_;  ///< What can be drawn of each series.
  bool is_empty_ = true;
  double middle_ = 0;  ///< Of the x axis.
  std::string text_;
};

}  // namespace

PlotSeries& Plot::add(std::string name, std::vector<PlotPoint> points, PlotSeries::Style style) {
  series.push_back({std::move(name), std::move(points), style, {}, unsigned(series.size())});
  return series.back();
}

std::string draw(const Plot& plot, std::string_view prefix) { return Drawing(plot, prefix).svg(); }

}  // namespace coif
