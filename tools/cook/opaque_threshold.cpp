#include "cook/opaque_threshold.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif {
namespace {

constexpr int kLowest = 128;   ///< 0.5: half transparent texels drawn as solid are the worst edge to accept.
constexpr int kHighest = 242;  ///< 0.95.
constexpr int kSmoothing = 6;  ///< Texels of one painted alpha spread about this far by filtering and compression.
constexpr double kFootShare = 0.25;  ///< Of the mode's height; below it the texels are no longer of the core.
constexpr double kModeShare = 0.1;   ///< Of the drawn texels within the mode's width; fewer are no core.
constexpr double kWantedOpaque = 0.25;
constexpr int kSolid = 250;  ///< From here on an alpha is one that lossy compression touched.

/// Mean over the bins within kSmoothing; at the ends over those that there are.
AlphaHistogram smoothed(const AlphaHistogram& histogram) {
  AlphaHistogram result{};
  for (int bin = 0; bin < 256; ++bin) {
    const int first = std::max(0, bin - kSmoothing), last = std::min(255, bin + kSmoothing);
    result[std::size_t(bin)] = std::accumulate(&histogram[std::size_t(first)], &histogram[std::size_t(last)] + 1, 0.0) /
                               double(last - first + 1);
  }
  return result;
}

double share_from(const AlphaHistogram& histogram, int bin, double total) {
  return std::accumulate(histogram.begin() + bin, histogram.end(), 0.0) / total;
}

/// The uppermost local maximum of at least half alpha that holds enough texels; -1 without one.
int find_core(const AlphaHistogram& smooth, double total) {
  for (int bin = 255; bin >= kLowest; --bin) {
    const double here = smooth[std::size_t(bin)];
    const int first = std::max(0, bin - kSmoothing), last = std::min(255, bin + kSmoothing);
    const bool highest = std::all_of(&smooth[std::size_t(first)], &smooth[std::size_t(last)] + 1,
                                     [&](double other) { return other <= here; });
    if (highest && here * (last - first + 1) >= kModeShare * total) return bin;
  }
  return -1;
}

int find_foot(const AlphaHistogram& smooth, int core) {
  int foot = core;
  while (foot > kLowest && smooth[std::size_t(foot - 1)] >= kFootShare * smooth[std::size_t(core)] &&
         // Rising again: the mode below begins.
         smooth[std::size_t(foot - 1)] <= smooth[std::size_t(foot)]) {
    --foot;
  }
  return foot;
}

}  // namespace

AlphaHistogram alpha_histogram(const Image& image, const Image& used, double factor) {
  AlphaHistogram histogram{};
  for (std::size_t i = 0; i < image.texel_count(); ++i) {
    if (used.texels[i] == 0) continue;
    const double alpha = image.texels[4 * i + 3] * std::clamp(factor, 0.0, 1.0);
    histogram[std::size_t(std::lround(alpha))] += used.texels[i] / 255.0;
  }
  return histogram;
}

OpaqueThreshold choose_opaque_threshold(const AlphaHistogram& histogram, double discard) {
  AlphaHistogram drawn = histogram;
  const int faintest = std::clamp(int(std::ceil(discard * 255)), 1, 255);
  std::fill_n(drawn.begin(), faintest, 0.0);
  const double total = std::accumulate(drawn.begin(), drawn.end(), 0.0);
  const double hidden = std::accumulate(histogram.begin(), histogram.end(), 0.0) - total;
  const double solid = std::accumulate(drawn.begin() + kSolid, drawn.end(), 0.0);
  if (hidden <= 0 && solid >= total) return {0, 1, "nothing is transparent"};
  if (total <= 0) return {kHighest / 255.0, 0, "nothing is visible"};

  const AlphaHistogram smooth = smoothed(drawn);
  const int core = find_core(smooth, total);
  int bin = core < 0 ? kHighest : std::min(find_foot(smooth, core), kHighest);
  const bool enough = share_from(drawn, bin, total) >= kWantedOpaque;
  while (bin > kLowest && share_from(drawn, bin, total) < kWantedOpaque) --bin;
  const std::string reason = core < 0 ? "no opaque core stands out, so as low as a quarter of the texels asks for"
                             : enough ? fmt::format("the foot of the opaque core around alpha {:.2f}", core / 255.0)
                                      : "lower than the small opaque core, so that a quarter of the texels is opaque";
  return {bin / 255.0, share_from(drawn, bin, total), reason};
}

}  // namespace coif
