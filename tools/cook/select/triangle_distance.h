#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace coif::cook {

/// Squared distance of `p` from the triangle `a`, `b`, `c`, by the region of the triangle's plane that `p` lies above
/// (Ericson 2005, "Real-Time Collision Detection", 5.1.5). Exact for degenerate triangles as well, up to rounding.
[[nodiscard]] double squared_distance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                      const Eigen::Vector3d& c);

/// Triangles by the cubes of one size that their boxes touch, to find how far a point is from them.
class TriangleGrid {
 public:
  /// `triangles`: three indices of `positions` each; `group_of` gives each triangle's group. The spans must outlive the
  /// grid. Distances above `reach` (metres, > 0) are not distinguished.
  TriangleGrid(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> triangles,
               std::span<const std::uint32_t> group_of, double reach);
  /// A grid without groups.
  TriangleGrid(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> triangles, double reach)
      : TriangleGrid(positions, triangles, {}, reach) {}

  /// Metres to the nearest triangle of the groups that count; `reach` if none is nearer. Below `enough` any distance
  /// may be returned: in dense hair the first triangles are enough to know that, and all of them would take long.
  [[nodiscard]] double distance(const Eigen::Vector3f& point, const std::vector<bool>& group_counts,
                                double enough) const;
  /// Metres to the nearest triangle of any group.
  [[nodiscard]] double distance(const Eigen::Vector3f& point, double enough) const;

 private:
  using Cube = std::array<std::int32_t, 3>;
  struct CubeHash {
    std::size_t operator()(const Cube& cube) const;
  };

  [[nodiscard]] Cube cube_of(const Eigen::Vector3f& point) const;
  template <typename Counts>
  [[nodiscard]] double nearest(const Eigen::Vector3f& point, double enough, const Counts& counts) const;

  std::span<const Eigen::Vector3f> positions_;
  std::span<const std::uint32_t> triangles_;
  std::span<const std::uint32_t> group_of_;
  double reach_;
  double side_;
  std::unordered_map<Cube, std::vector<std::uint32_t>, CubeHash> cubes_;
};

}  // namespace coif::cook
