#pragma once

#include "base/parallel_for.h"
#include "platform/stop.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace coif::cards {

/// Chooses `wanted` of `count` things (at least one) that lie far from each other: each is drawn with a probability by
/// its squared distance from those drawn before (Arthur and Vassilvitskii 2007, "k-means++"). Fewer if the rest are
/// copies of these. `squared_distance(i, k)` is that of two things. Repeats for equal input.
template <typename Distance>
[[nodiscard]] std::vector<std::uint32_t> spread_seeds(std::size_t count, std::size_t wanted,
                                                      const Distance& squared_distance) {
  std::mt19937_64 random(1);
  std::vector<std::uint32_t> seeds{std::uint32_t(count / 2)};
  std::vector<float> nearest(count, std::numeric_limits<float>::max());
  while (seeds.size() < wanted) {
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      nearest[i] = std::min(nearest[i], squared_distance(i, seeds.back()));
      sum += double(nearest[i]);
    }
    if (!(sum > 0)) break;  // the rest are copies of these
    double left = sum * (double(random() >> 11) * 0x1p-53);
    std::uint32_t next = 0;
    while (next + 1 < count && (left -= double(nearest[next])) >= 0) ++next;
    seeds.push_back(next);
  }
  return seeds;
}

/// Groups points into clusters by squared distance (Lloyd 1982; the first middles by spread_seeds()). With very many
/// points a sample finds the middles. `D`: coordinates of a point, a multiple of 8.
template <std::size_t D>
class PointClusters {
 public:
  using Point = std::array<float, D>;

  /// The numbers of `points` in at most `count` clusters, each ascending, none empty. Repeats for equal input, with any
  /// `threads`.
  [[nodiscard]] static std::vector<std::vector<std::uint32_t>> find(const std::vector<Point>& points, std::size_t count,
                                                                    const platform::Threads& threads) {
    if (points.empty() || count == 0) return {};
    const std::vector<Point> middles = middles_of(sample_of(points), count, threads);
    std::vector<std::vector<std::uint32_t>> clusters(middles.size());
    const Nearest nearest = nearest_middles(points, middles, threads);
    for (std::uint32_t i = 0; i < points.size(); ++i) clusters[nearest.middle[i]].push_back(i);
    std::erase_if(clusters, [](const auto& members) { return members.empty(); });
    return clusters;
  }

 private:
  static constexpr std::size_t kMostSample = 16384;  // points that find the middles
  static constexpr int kMostRounds = 30;
  static constexpr float kLeastGain = 0.001f;  // Share of all squared distances.

  /// For each point its nearest middle, and the sum of all distances.
  struct Nearest {
    std::vector<std::uint32_t> middle;
    double distance = 0;
  };

  static std::vector<Point> sample_of(const std::vector<Point>& points) {
    if (points.size() <= kMostSample) return points;
    std::vector<Point> sample(kMostSample);
    for (std::size_t i = 0; i < kMostSample; ++i) sample[i] = points[i * points.size() / kMostSample];
    return sample;
  }

  static float squared_distance(const Point& a, const Point& b) {
    // Eight sums side by side, which a compiler turns into vectors.
    static_assert(D % 8 == 0);
    std::array<float, 8> sums{};
    for (std::size_t k = 0; k < D; k += sums.size()) {
      for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += (a[k + j] - b[k + j]) * (a[k + j] - b[k + j]);
    }
    return std::accumulate(sums.begin(), sums.end(), 0.0f);
  }

  static Nearest nearest_middles(const std::vector<Point>& points, const std::vector<Point>& middles,
                                 const platform::Threads& threads) {
    Nearest found{std::vector<std::uint32_t>(points.size()), 0};
    std::vector<float> distances(points.size(), std::numeric_limits<float>::max());
    parallel_for(points.size(), threads, [&](std::size_t i) {
      for (std::uint32_t m = 0; m < middles.size(); ++m) {
        const float distance = squared_distance(points[i], middles[m]);
        if (!(distance < distances[i])) continue;
        distances[i] = distance;
        found.middle[i] = m;
      }
    });
    found.distance = std::accumulate(distances.begin(), distances.end(), 0.0);
    return found;
  }

  /// Moves each middle to the mean of the points nearest to it; a middle without points stays.
  static void move_to_means(const std::vector<Point>& points, const Nearest& nearest, std::vector<Point>& middles) {
    std::vector<std::array<double, D>> sums(middles.size());
    std::vector<std::size_t> counts(middles.size(), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint32_t m = nearest.middle[i];
      ++counts[m];
      for (std::size_t k = 0; k < D; ++k) sums[m][k] += double(points[i][k]);
    }
    for (std::size_t m = 0; m < middles.size(); ++m) {
      if (counts[m] == 0) continue;
      for (std::size_t k = 0; k < D; ++k) middles[m][k] = float(sums[m][k] / double(counts[m]));
    }
  }

  static std::vector<Point> middles_of(const std::vector<Point>& sample, std::size_t count,
                                       const platform::Threads& threads) {
    const auto apart = [&](std::uint32_t i, std::uint32_t k) { return squared_distance(sample[i], sample[k]); };
    std::vector<Point> middles;
    for (const std::uint32_t seed : spread_seeds(sample.size(), std::min(count, sample.size()), apart))
      middles.push_back(sample[seed]);
    double before = std::numeric_limits<double>::max();
    for (int round = 0; round < kMostRounds; ++round) {
      const Nearest nearest = nearest_middles(sample, middles, threads);
      if (nearest.distance >= (1 - double(kLeastGain)) * before) break;
      before = nearest.distance;
      move_to_means(sample, nearest, middles);
    }
    return middles;
  }
};

}  // namespace coif::cards
