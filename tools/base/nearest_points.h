#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// Finds which of many points are nearest to a place (Bentley 1975, "Multidimensional binary search trees used for
/// associative searching").
class NearestPoints {
 public:
  struct Found {
    float squared = 0;  ///< Distance.
    std::uint32_t point = 0;
    auto operator<=>(const Found&) const = default;
  };

  /// The points must outlive this.
  explicit NearestPoints(std::span<const Eigen::Vector3f> points);

  /// Fills `found` with the nearest points, nearest first, up to its capacity or the number of points; at equal
  /// distance the lower index comes first.
  void find(const Eigen::Vector3f& place, std::size_t count, std::vector<Found>& found) const;

 private:
  void arrange(std::size_t begin, std::size_t end);
  void visit(std::size_t begin, std::size_t end, const Eigen::Vector3f& place, std::size_t count,
             std::vector<Found>& found) const;

  std::span<const Eigen::Vector3f> points_;
  /// In every part of the range the middle point divides the others along its axis.
  std::vector<std::uint32_t> order_;
  std::vector<std::uint8_t> axis_;  ///< The axis of the point at the same place of `order_`.
};

}  // namespace coif
