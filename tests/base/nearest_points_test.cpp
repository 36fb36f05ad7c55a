#include "base/nearest_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coif::nearest_points_test {

using Found = NearestPoints::Found;

/// By looking at all of them.
std::vector<Found> all_nearest(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3f& place,
                               std::size_t count) {
  std::vector<Found> found;
  for (std::uint32_t i = 0; i < points.size(); ++i) found.push_back({(points[i] - place).squaredNorm(), i});
  std::ranges::sort(found);
  found.resize(std::min(count, found.size()));
  return found;
}

TEST(NearestPoints, AreThoseThatLookingAtAllOfThemFinds) {
  std::mt19937 numbers(7);
  std::uniform_int_distribution<int> coordinate(0, 12);  // many places twice, many distances equal
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 600; ++i) points.emplace_back(coordinate(numbers), coordinate(numbers), coordinate(numbers) / 4);
  const NearestPoints nearest(points);
  std::vector<Found> found;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3f place(float(coordinate(numbers)) + 0.5f * float(i % 2), float(coordinate(numbers)), 1);
    for (const std::size_t count : {1u, 8u, 50u}) {
      nearest.find(place, count, found);
      EXPECT_EQ(found, all_nearest(points, place, count));
    }
  }
}

TEST(NearestPoints, FindsAsManyAsThereAre) {
  const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {1, 0, 0}};
  std::vector<Found> found{{5, 5}};
  NearestPoints(points).find({2, 0, 0}, 8, found);
  EXPECT_EQ(found, (std::vector<Found>{{1, 1}, {4, 0}}));
  NearestPoints(points).find({2, 0, 0}, 0, found);
  EXPECT_TRUE(found.empty());
  NearestPoints({}).find({2, 0, 0}, 3, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace coif::nearest_points_test
