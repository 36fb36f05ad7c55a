#include "base/parallel_for.h"
#include "cards/spread_seeds.h"
#include "report/cards/baseline_cards.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace coif {
namespace {

constexpr std::size_t kDimensions = 3 * EvenStrands::kStations;
constexpr std::size_t kMostSample = 16384;  // strands that find the middles
constexpr int kMostRounds = 30;
constexpr float kLeastGain = 0.001f;  // of all squared distances

/// A strand as a place among all strands.
using Shape = std::array<float, kDimensions>;

Shape shape_at(const EvenStrands& strands, std::uint32_t i) {
  Shape shape;
  const auto points = strands.strand(i);
  for (std::size_t k = 0; k < points.size(); ++k)
    std::copy_n(points[k].data(), 3, shape.begin() + std::ptrdiff_t(3 * k));
  return shape;
}

float squared_distance_of(const Shape& a, const Shape& b) {
  // Eight sums side by side, which a compiler turns into vectors.
  std::array<float, 8> sums{};
  for (std::size_t k = 0; k < kDimensions; k += sums.size()) {
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += (a[k + j] - b[k + j]) * (a[k + j] - b[k + j]);
  }
  return std::accumulate(sums.begin(), sums.end(), 0.0f);
}
static_assert(kDimensions % 8 == 0);

/// Of each shape, which middle is nearest, and how far all are from theirs.
struct Nearest {
  std::vector<std::uint32_t> middle;
  double distance = 0;
};

Nearest nearest_middles(const std::vector<Shape>& shapes, const std::vector<Shape>& middles, unsigned threads) {
  Nearest found{std::vector<std::uint32_t>(shapes.size()), 0};
  std::vector<float> distances(shapes.size(), std::numeric_limits<float>::max());
  parallel_for(shapes.size(), threads, [&](std::size_t i) {
    for (std::uint32_t m = 0; m < middles.size(); ++m) {
      const float distance = squared_distance_of(shapes[i], middles[m]);
      if (!(distance < distances[i])) continue;
      distances[i] = distance;
      found.middle[i] = m;
    }
  });
  found.distance = std::accumulate(distances.begin(), distances.end(), 0.0);
  return found;
}

/// Of those that are nearest to each middle; a middle that is nearest to none stays.
void move_to_means(const std::vector<Shape>& shapes, const Nearest& nearest, std::vector<Shape>& middles) {
  std::vector<std::array<double, kDimensions>> sums(middles.size());
  std::vector<std::size_t> counts(middles.size(), 0);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::uint32_t m = nearest.middle[i];
    ++counts[m];
    for (std::size_t k = 0; k < kDimensions; ++k) sums[m][k] += double(shapes[i][k]);
  }
  for (std::size_t m = 0; m < middles.size(); ++m) {
    if (counts[m] == 0) continue;
    for (std::size_t k = 0; k < kDimensions; ++k) middles[m][k] = float(sums[m][k] / double(counts[m]));
  }
}

}  // namespace

std::vector<std::vector<std::uint32_t>> cluster_strands(const EvenStrands& strands, std::size_t count,
                                                        unsigned threads) {
  if (strands.count() == 0 || count == 0) return {};
  std::vector<Shape> all(strands.count());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = shape_at(strands, i);
  std::vector<Shape> sample = all;
  if (all.size() > kMostSample) {
    for (std::size_t i = 0; i < kMostSample; ++i) sample[i] = all[i * all.size() / kMostSample];
    sample.resize(kMostSample);
  }
  const auto apart = [&](std::uint32_t i, std::uint32_t k) { return squared_distance_of(sample[i], sample[k]); };
  std::vector<Shape> middles;
  for (const std::uint32_t seed : spread_seeds(sample.size(), std::min(count, sample.size()), apart))
    middles.push_back(sample[seed]);
  double before = std::numeric_limits<double>::max();
  for (int round = 0; round < kMostRounds; ++round) {
    const Nearest nearest = nearest_middles(sample, middles, threads);
    if (nearest.distance >= (1 - double(kLeastGain)) * before) break;
    before = nearest.distance;
    move_to_means(sample, nearest, middles);
  }
  std::vector<std::vector<std::uint32_t>> clusters(middles.size());
  const Nearest nearest = nearest_middles(all, middles, threads);
  for (std::uint32_t i = 0; i < all.size(); ++i) clusters[nearest.middle[i]].push_back(i);
  std::erase_if(clusters, [](const auto& members) { return members.empty(); });
  return clusters;
}

}  // namespace coif
