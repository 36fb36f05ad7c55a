// The points at which the exact reference is evaluated, and its agreement with itself.

#include "report/shadow/measure_shadows.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace coif::report {
namespace {

// A surface within this share of the way aside, and of the slope's, is the one looked for.
constexpr float kSameSurface = 0.3f;

Eigen::Vector3f normal_of(const visibility::HairSurface::Triangle& triangle,
                          std::span<const Eigen::Vector3f> positions) {
  const Eigen::Vector3f& a = positions[triangle.vertex[0]];
  return (positions[triangle.vertex[1]] - a).cross(positions[triangle.vertex[2]] - a);
}

/// Light at the patch's surface next to this depth; none where the line does not meet it.
std::optional<float> light_on_patch(const visibility::FragmentView& view, std::size_t line, std::uint32_t patch,
                                    float depth, float tolerance) {
  std::optional<float> found;
  const float solid = view.solid_depth(line);
  float passes = 1;
  for (const visibility::Fragment& fragment : view.line(line)) {
    if (fragment.depth > solid) break;
    const float distance = std::fabs(fragment.depth - depth);
    if (fragment.patch == patch && distance < tolerance) {
      tolerance = distance;
      found = passes;
    }
    passes *= 1 - fragment.alpha;
  }
  return found;
}

}  // namespace

std::vector<ShadowPoint> shadow_points(const visibility::FragmentView& seen, const visibility::HairSurface& hair,
                                       std::span<const Eigen::Vector3f> positions) {
  std::vector<ShadowPoint> points;
  for (std::size_t line = 0; line < seen.line_count(); ++line) {
    const float solid = seen.solid_depth(line);
    float passes = 1;
    for (const visibility::Fragment& fragment : seen.line(line)) {
      if (fragment.depth > solid) break;
      points.push_back({seen.place(line, fragment.depth), normal_of(hair.triangles[fragment.triangle], positions),
                        passes, fragment.alpha, false});
      passes *= 1 - fragment.alpha;
    }
    if (std::isfinite(solid)) points.push_back({seen.place(line, solid), Eigen::Vector3f::Zero(), passes, 1, true});
  }
  return points;
}

void TruthAgreement::add(const visibility::FragmentView& seen, const visibility::FragmentView& aside,
                         const visibility::HairSurface& hair, std::span<const Eigen::Vector3f> positions) {
  const Eigen::Vector3f towards = seen.place(0, 0) - seen.place(0, 1), offset = aside.place(0, 0) - seen.place(0, 0);
  for (std::size_t line = 0; line < std::min(seen.line_count(), aside.line_count()); ++line) {
    const float solid = seen.solid_depth(line);
    float passes = 1;
    for (const visibility::Fragment& fragment : seen.line(line)) {
      if (fragment.depth > solid) break;
      const Eigen::Vector3f normal = normal_of(hair.triangles[fragment.triangle], positions);
      const float facing = normal.dot(towards);
      const float rise = facing != 0 ? normal.dot(offset) / facing : 0;
      const float tolerance = kSameSurface * (offset.norm() + std::fabs(rise));
      const auto light = light_on_patch(aside, line, fragment.patch, fragment.depth + rise, tolerance);
      points_ += fragment.alpha;
      if (light) {
        met_ += fragment.alpha;
        squares_ += double(fragment.alpha) * (double(*light) - passes) * (double(*light) - passes);
      }
      passes *= 1 - fragment.alpha;
    }
  }
}

}  // namespace coif::report
