#include "sample/hair_flow.h"

#include "sample/head_shape.h"
#include "sample/skull_paths.h"
#include "sample/smooth_step.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::sample {
namespace {

using Eigen::Vector3d;

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
constexpr double kRootLift = 0.0035;  // Metres; roots lie close to the scalp, outer layers above inner ones.

/// A side parting on the model's left, from the forehead to the crown.
Vector3d parting_direction(double t) {
  static const Vector3d kForehead = Vector3d(0.30, 0.66, 0.70).normalized();
  static const Vector3d kCrown = Vector3d(0.06, 0.88, -0.46).normalized();
  static const Vector3d kTop = kForehead + kCrown;
  return direction_on_curve(kForehead, 0.6 * kTop, kCrown, t);
}

}  // namespace

Vector3d point_on_hair(const HairCourse& course, double along) {
  const double angle = course.azimuth * kRadiansPerDegree;
  const Vector3d parting = parting_direction(course.parting);
  const Vector3d widest{std::sin(angle), 0.0, std::cos(angle)};
  const double arc = std::acos(parting.dot(widest)) * kCraniumRadii.mean() * (1.0 - course.start);
  const double drop = std::max(kCraniumCenter.y() - course.tip_height, 0.0);
  const double travelled = along * (arc + drop);

  const double on_skull = std::min(travelled / arc, 1.0);
  // Straight above its end, so that hair arrives there hanging.
  const Vector3d control = widest + 0.75 * Vector3d::UnitY();
  const Vector3d direction = direction_on_curve(parting, control, widest, course.start + (1.0 - course.start) * on_skull);
  const double root_lift = kRootLift + 0.45 * course.lift;
  const double lift = root_lift + (course.lift - root_lift) * smooth_step(0.0, 0.06, travelled);
  Vector3d point = kCraniumCenter + (kCraniumRadii.array() + lift).matrix().cwiseProduct(direction);

  const double fallen = std::max(travelled - arc, 0.0);
  if (fallen > 0) {
    const double share = fallen / drop;
    point.y() -= fallen;
    point += (course.flare * smooth_step(0.0, 0.75, share) - course.curl * smooth_step(0.55, 1.15, share)) * widest;
  }
  return pushed_clear(point, 0.003 + 0.5 * course.lift, head_distance, head_normal);
}

double azimuth_of(const Vector3d& point) {
  return std::atan2(point.x(), point.z() - kCraniumCenter.z()) / kRadiansPerDegree;
}

}  // namespace coif::sample
