#pragma once

#include <limits>
#include <vector>

namespace coif {

/// From values along one axis of a plot to pixels. First add() all that is drawn, then close(), then ask.
class PlotAxis {
 public:
  explicit PlotAxis(bool logarithmic) : logarithmic_(logarithmic) {}

  /// `value`: finite, above zero on a logarithmic axis.
  void add(double value);

  /// Widens the range by a margin and chooses ticks unless some are `wanted`; those out of the range are left out.
  /// Linear axes begin at 0 where nothing is below it. Without any value the range is 1 to 10.
  void close(std::vector<double> wanted = {});

  /// Where the range begins and ends on the picture.
  void set_pixels(double first, double last) {
    first_ = first;
    last_ = last;
  }

  [[nodiscard]] double first() const { return first_; }
  [[nodiscard]] double last() const { return last_; }
  [[nodiscard]] const std::vector<double>& ticks() const { return ticks_; }
  [[nodiscard]] double pixel(double value) const;

 private:
  [[nodiscard]] std::vector<double> log_ticks() const;
  [[nodiscard]] std::vector<double> linear_ticks() const;

  bool logarithmic_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
  double first_ = 0, last_ = 1;
  std::vector<double> ticks_;
};

}  // namespace coif
