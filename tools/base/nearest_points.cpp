#include "base/nearest_points.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace coif {

NearestPoints::NearestPoints(std::span<const Eigen::Vector3f> points)
    : points_(points), order_(points.size()), axis_(points.size(), 0) {
  std::iota(order_.begin(), order_.end(), 0u);
  arrange(0, order_.size());
}

/// Halves the longest side of the points' box, and so on; so deep as the number has digits.
void NearestPoints::arrange(std::size_t begin, std::size_t end) {
  if (end - begin < 2) return;
  Eigen::AlignedBox3f box;
  for (std::size_t i = begin; i < end; ++i) box.extend(points_[order_[i]]);
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i) { return order_.begin() + std::ptrdiff_t(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(points_[a][axis], a) < std::pair(points_[b][axis], b);
  });
  axis_[middle] = std::uint8_t(axis);
  arrange(begin, middle);
  arrange(middle + 1, end);
}

void NearestPoints::visit(std::size_t begin, std::size_t end, const Eigen::Vector3f& place, std::size_t count,
                          std::vector<Found>& found) const {
  if (begin >= end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const std::uint32_t point = order_[middle];
  const Found here{(points_[point] - place).squaredNorm(), point};
  if (found.size() < count || here < found.back()) {
    if (found.size() == count) found.pop_back();
    found.insert(std::ranges::upper_bound(found, here), here);
  }
  const float beyond = place[axis_[middle]] - points_[point][axis_[middle]];
  const bool is_above = beyond > 0;
  visit(is_above ? middle + 1 : begin, is_above ? end : middle, place, count, found);
  if (found.size() == count && beyond * beyond > found.back().squared) return;
  visit(is_above ? begin : middle + 1, is_above ? middle : end, place, count, found);
}

void NearestPoints::find(const Eigen::Vector3f& place, std::size_t count, std::vector<Found>& found) const {
  found.clear();
  if (count > 0) visit(0, order_.size(), place, count, found);
}

}  // namespace coif
