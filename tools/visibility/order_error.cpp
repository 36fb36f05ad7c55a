#include "visibility/order_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace coif {
namespace {

constexpr double kBestPsnr = 99;

/// A layer in the order in which it is blended.
struct Blended {
  std::uint64_t key;
  float alpha;
  float share;  ///< Of the pixel, where depth sorts.
};

/// A solid layer hides what is behind it, which has as much of the pixel as it should have let through; as one more layer.
/// `passes`: of the light before it.
double error_of_solid(float alpha, float passes) {
  const double off = double((1 - alpha) * passes);
  return (1 + kHiddenVariance) * off * off;
}

/// Squared differences of one line. `blended` is memory that calls share.
class LineError {
 public:
  LineError(std::span<const std::uint32_t> rank, const DrawRule& rule) : rank_(rank), rule_(rule) {}

  double operator()(std::span<const Layer> line) {
    blended_.clear();
    float passes = 1;
    std::size_t i = 0;
    for (; i < line.size() && line[i].alpha < rule_.opaque_threshold; ++i) {
      blended_.push_back({key_of(line[i]), line[i].alpha, line[i].alpha * passes});
      passes *= 1 - line[i].alpha;
    }
    return error_of_blended() + (i < line.size() ? error_of_solid(line[i].alpha, passes) : 0);
  }

 private:
  [[nodiscard]] std::uint64_t key_of(const Layer& layer) const {
    const bool later = !rule_.faces_together && layer.is_front != 0;
    return std::uint64_t(later) << 32 | rank_[layer.triangle];
  }

  double error_of_blended() {
    std::ranges::stable_sort(blended_, std::greater{}, &Blended::key);
    float passes = 1;
    double error = 0;
    for (const Blended& layer : blended_) {
      const double off = double(layer.alpha * passes - layer.share);
      error += off * off;
      passes *= 1 - layer.alpha;
    }
    return error;
  }

  std::span<const std::uint32_t> rank_;
  DrawRule rule_;
  std::vector<Blended> blended_;
};

}  // namespace

double squared_error(const SightLines& lines, std::span<const std::uint32_t> rank, const DrawRule& rule) {
  LineError error_of(rank, rule);
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) sum += error_of(lines.line(i));
  return sum;
}

double threshold_error(const SightLines& lines, float opaque_threshold) {
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    float passes = 1;
    for (const Layer& layer : lines.line(i)) {
      if (layer.alpha >= opaque_threshold) {
        sum += error_of_solid(layer.alpha, passes);
        break;
      }
      passes *= 1 - layer.alpha;
    }
  }
  return sum;
}

double psnr_db(double squared_error, std::size_t pixels) {
  const double mean = kColorSpread * kColorSpread * squared_error / double(std::max<std::size_t>(pixels, 1));
  return mean > 0 ? std::min(kBestPsnr, -10 * std::log10(mean)) : kBestPsnr;
}

}  // namespace coif
