#include "report/page/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif {

void PlotAxis::add(double value) {
  low_ = std::min(low_, value);
  high_ = std::max(high_, value);
}

void PlotAxis::close(std::vector<double> wanted) {
  if (low_ > high_) {
    logarithmic_ = false;
    low_ = 1;
    high_ = 10;
  } else if (logarithmic_) {
    constexpr double kMargin = 1.2;
    low_ /= kMargin;
    high_ *= kMargin;
  } else {
    // The margin is of what is shown, or points at the top would be cut.
    const double shown = high_ - std::min(low_, 0.0);
    const double margin = shown > 0 ? 0.05 * shown : 0.5;
    low_ = low_ >= 0 ? 0 : low_ - margin;
    high_ += margin;
  }
  ticks_ = !wanted.empty() ? std::move(wanted) : logarithmic_ ? log_ticks() : linear_ticks();
  std::erase_if(ticks_, [this](double tick) { return tick < low_ || tick > high_; });
}

double PlotAxis::pixel(double value) const {
  const auto scaled = [this](double number) { return logarithmic_ ? std::log10(number) : number; };
  return first_ + (scaled(value) - scaled(low_)) / (scaled(high_) - scaled(low_)) * (last_ - first_);
}

/// 1, 2 and 5 of every decade, or powers of ten alone where there are many.
std::vector<double> PlotAxis::log_ticks() const {
  constexpr int kFewDecades = 3, kMostPowers = 12;
  const int first = int(std::floor(std::log10(low_))), last = int(std::ceil(std::log10(high_)));
  std::vector<double> ticks;
  for (int decade = first; decade <= last; decade += 1 + (last - first) / kMostPowers) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      if (digit == 1.0 || last - first <= kFewDecades) ticks.push_back(digit * std::pow(10.0, decade));
    }
  }
  return ticks;
}

/// Up to ten or so, 1, 2 or 5 times a power of ten apart.
std::vector<double> PlotAxis::linear_ticks() const {
  const double least = (high_ - low_) / 10, decade = std::pow(10.0, std::floor(std::log10(least)));
  std::vector<double> ticks;
  if (!(decade > 0)) return ticks;  // a range that no number can divide
  double step = 10 * decade;
  for (const double digit : {5.0, 2.0, 1.0}) {
    if (digit * decade >= least) step = digit * decade;
  }
  for (int i = int(std::ceil(low_ / step)); i * step <= high_; ++i) ticks.push_back(i * step);
  return ticks;
}

}  // namespace coif
