#include "cook/triangle_distance.h"

#include <algorithm>
#include <limits>

namespace coif {
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
  // The nearest point is on an edge that has the point on its outer side, or there is none and it is inside.
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

}  // namespace coif
