#include "sample/skull_paths.h"

namespace coif::sample {

using Eigen::Vector3d;

Vector3d direction_on_curve(const Vector3d& from, const Vector3d& control, const Vector3d& to, double t) {
  return ((1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to).normalized();
}

Vector3d pushed_clear(Vector3d point, double clearance, const Field& distance, const Gradient& normal) {
  for (int i = 0; i < 6; ++i) {
    const double found = distance(point);
    if (found >= clearance) break;
    point += (clearance - found) * normal(point);
  }
  return point;
}

}  // namespace coif::sample
