#include "report/shadow/shadow_points.h"

#include <Eigen/Geometry>

#include <cmath>

namespace coif {

namespace {

Eigen::Vector3f normal_of(const HairSurface::Triangle& triangle, std::span<const Eigen::Vector3f> positions) {
  const Eigen::Vector3f& a = positions[triangle.vertex[0]];
  return (positions[triangle.vertex[1]] - a).cross(positions[triangle.vertex[2]] - a);
}

}  // namespace

std::vector<ShadowPoint> shadow_points(const FragmentView& seen, const HairSurface& hair,
                                       std::span<const Eigen::Vector3f> positions) {
  std::vector<ShadowPoint> points;
  for (std::size_t line = 0; line < seen.line_count(); ++line) {
    const float solid = seen.solid_depth(line);
    float passes = 1;
    for (const Fragment& fragment : seen.line(line)) {
      if (fragment.depth > solid) break;
      points.push_back({seen.place(line, fragment.depth), normal_of(hair.triangles[fragment.triangle], positions),
                        passes, fragment.alpha, false});
      passes *= 1 - fragment.alpha;
    }
    if (std::isfinite(solid)) points.push_back({seen.place(line, solid), Eigen::Vector3f::Zero(), passes, 1, true});
  }
  return points;
}

}  // namespace coif
