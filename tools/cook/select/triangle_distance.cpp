#include "cook/select/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

double squared_distance(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double length2 = along.squaredNorm();
  const double at = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (a + at * along - p).squaredNorm();
}

}  // namespace

double squared_distance(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  const double area2 = normal.squaredNorm();
  if (!(area2 > 0)) {
    return std::min({squared_distance(p, a, b), squared_distance(p, b, c), squared_distance(p, c, a)});
  }
  // The nearest point is on an edge that has the point on its outer side; if there is none, the point is inside.
  const bool outside[3] = {(b - a).cross(p - a).dot(normal) < 0, (c - b).cross(p - b).dot(normal) < 0,
                           (a - c).cross(p - c).dot(normal) < 0};
  double nearest = std::numeric_limits<double>::infinity();
  if (outside[0]) nearest = squared_distance(p, a, b);
  if (outside[1]) nearest = std::min(nearest, squared_distance(p, b, c));
  if (outside[2]) nearest = std::min(nearest, squared_distance(p, c, a));
  if (outside[0] || outside[1] || outside[2]) return nearest;
  const double height = (p - a).dot(normal);
  return height * height / area2;
}

namespace {

/// A triangle larger than this many reaches makes the cubes larger, so that it is not in millions of them.
constexpr double kLargestInReaches = 8;
constexpr int kHome = 13;  ///< Index of the middle one of the 27 cubes around a point.

}  // namespace

std::size_t TriangleGrid::CubeHash::operator()(const Cube& cube) const {
  std::uint64_t hash = 0;
  for (std::int32_t k : cube) hash = (hash ^ std::uint64_t(std::uint32_t(k))) * 0x9E3779B97F4A7C15u;
  return std::size_t(hash ^ (hash >> 32));
}

TriangleGrid::Cube TriangleGrid::cube_of(const Eigen::Vector3f& point) const {
  Cube cube;
  for (int k = 0; k < 3; ++k) cube[std::size_t(k)] = std::int32_t(std::floor(point[k] / side_));
  return cube;
}

TriangleGrid::TriangleGrid(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> triangles,
                           std::span<const std::uint32_t> group_of, double reach)
    : positions_(positions), triangles_(triangles), group_of_(group_of), reach_(reach), side_(reach) {
  const auto corner = [&](std::size_t i) -> const Eigen::Vector3f& { return positions_[triangles_[i]]; };
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const Eigen::Vector3f size = corner(i).cwiseMax(corner(i + 1)).cwiseMax(corner(i + 2)) -
                                 corner(i).cwiseMin(corner(i + 1)).cwiseMin(corner(i + 2));
    side_ = std::max(side_, size.maxCoeff() / kLargestInReaches);
  }
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const Cube low = cube_of(corner(i).cwiseMin(corner(i + 1)).cwiseMin(corner(i + 2)));
    const Cube high = cube_of(corner(i).cwiseMax(corner(i + 1)).cwiseMax(corner(i + 2)));
    for (Cube c = low; c[0] <= high[0]; ++c[0]) {
      for (c[1] = low[1]; c[1] <= high[1]; ++c[1]) {
        for (c[2] = low[2]; c[2] <= high[2]; ++c[2]) cubes_[c].push_back(std::uint32_t(i / 3));
      }
    }
  }
}

namespace {

/// Whether all of the triangle's box is farther from the point than that, by more than rounding.
bool is_farther(const Eigen::Vector3f& point, const std::array<Eigen::Vector3f, 3>& corner, double squared) {
  constexpr double kSlack = 1 - 1.0e-9;
  const Vector3d low = corner[0].cwiseMin(corner[1]).cwiseMin(corner[2]).cast<double>();
  const Vector3d high = corner[0].cwiseMax(corner[1]).cwiseMax(corner[2]).cast<double>();
  const Vector3d p = point.cast<double>();
  return (p - p.cwiseMax(low).cwiseMin(high)).squaredNorm() * kSlack > squared;
}

}  // namespace

template <typename Counts>
double TriangleGrid::nearest(const Eigen::Vector3f& point, double enough, const Counts& counts) const {
  const Cube home = cube_of(point);
  double least = reach_ * reach_;
  for (int i = 0; i < 27; ++i) {
    const int n = (i + kHome) % 27;
    const auto cube = cubes_.find({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1});
    if (cube == cubes_.end()) continue;
    for (std::uint32_t t : cube->second) {
      if (!counts(t)) continue;
      const std::size_t first = 3 * std::size_t(t);
      const std::array<Eigen::Vector3f, 3> corner = {positions_[triangles_[first]], positions_[triangles_[first + 1]],
                                                     positions_[triangles_[first + 2]]};
      // For most triangles around a point their boxes show that another one is nearer.
      if (!is_farther(point, corner, least)) {
        least = std::min(least, squared_distance(point.cast<double>(), corner[0].cast<double>(),
                                                 corner[1].cast<double>(), corner[2].cast<double>()));
      }
      if (least < enough * enough) return std::sqrt(least);
    }
  }
  return std::sqrt(least);
}

double TriangleGrid::distance(const Eigen::Vector3f& point, const std::vector<bool>& group_counts,
                              double enough) const {
  return nearest(point, enough, [&](std::uint32_t t) { return group_counts[group_of_[t]]; });
}

double TriangleGrid::distance(const Eigen::Vector3f& point, double enough) const {
  return nearest(point, enough, [](std::uint32_t) { return true; });
}

}  // namespace coif::cook
