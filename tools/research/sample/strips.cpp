#include "research/sample/strips.h"

#include "base/geometry.h"
#include "mannequin/head_shape.h"
#include "mannequin/solid_shapes.h"
#include "research/sample/long.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace coif::research {
namespace {

using Eigen::Vector3d;

/// The differences between locks.
struct Irregularity {
  double wave_degrees, wave_turns, wave_phase, twist, length;

  explicit Irregularity(unsigned seed) {
    mannequin::SeededNoise noise(seed);
    wave_degrees = noise.between(0.8, 2.2);
    wave_turns = noise.between(0.9, 1.5);
    wave_phase = noise.between(0.0, 1.0);
    twist = noise.between(-0.0035, 0.0035);  // Height of one edge of the tip above the other, metres.
    length = noise.between(-0.006, 0.006);   // Metres.
  }
};

/// `across` -1..1, `along` 0..1.
Vector3d point_on_strip(const StripStyle& style, const Irregularity& odd, double across, double along) {
  const double width = style.half_width * (1.0 - style.taper * mannequin::smooth_step(0.50, 1.0, along));
  const double wave =
      odd.wave_degrees * along * std::sin(2.0 * std::numbers::pi * (odd.wave_turns * along + odd.wave_phase));
  HairCourse course = style.course;
  course.parting = style.parting_from + (style.parting_to - style.parting_from) * 0.5 * (across + 1.0);
  course.azimuth = style.course.azimuth + across * width + wave + style.sweep * along * along;
  const double rounding = style.bulge * (1.0 - across * across) * mannequin::smooth_step(0.0, 0.3, along);
  course.lift = style.course.lift + rounding + odd.twist * across * along;
  course.tip_height += odd.length;
  return point_on_hair(course, along);
}

Vector3d normal_on(const StripSurface& surface, double across, double along) {
  constexpr double kStep = 0.02;
  const Vector3d u = surface(across + kStep, along) - surface(across - kStep, along);
  const double from = std::max(along - kStep, 0.0), to = std::min(along + kStep, 1.0);
  const Vector3d v = surface(across, to) - surface(across, from);
  return v.cross(u).normalized();
}

}  // namespace

void append_grid(int columns, std::span<const double> places, const TextureWindow& window, const StripSurface& surface,
                 mannequin::SurfaceMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto stride = static_cast<std::uint32_t>(columns + 1);
  for (const double v : places) {
    for (int column = 0; column <= columns; ++column) {
      const double u = static_cast<double>(column) / columns;
      mesh.positions.push_back(surface(2.0 * u - 1.0, v));
      mesh.normals.push_back(normal_on(surface, 2.0 * u - 1.0, v));
      mesh.uvs.emplace_back(window.from + u * (window.to - window.from), v);
    }
  }
  for (std::uint32_t row = 0; row + 1 < places.size(); ++row) {
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t a = first + row * stride + column, b = a + 1, c = a + stride, d = c + 1;
      mesh.triangles.insert(mesh.triangles.end(), {a, c, b, b, c, d});
    }
  }
}

void append_strip(const StripStyle& style, unsigned seed, mannequin::SurfaceMesh& mesh) {
  const Irregularity odd(seed);
  const auto surface = [&](double across, double along) { return point_on_strip(style, odd, across, along); };
  std::vector<double> places;
  for (int row = 0; row <= style.rows; ++row) places.push_back(static_cast<double>(row) / style.rows);
  append_grid(style.columns, places, style.window, surface, mesh);
}

namespace {

constexpr double kScalpLift = 0.0035;  // Metres; roots lie close to the scalp, outer layers above inner ones.

/// A side parting on the model's left, from the forehead to the crown.
Vector3d side_parting(double t) {
  static const Vector3d kForehead = Vector3d(0.30, 0.66, 0.70).normalized();
  static const Vector3d kCrown = Vector3d(0.06, 0.88, -0.46).normalized();
  static const Vector3d kTop = kForehead + kCrown;
  return direction_on_curve(kForehead, 0.6 * kTop, kCrown, t);
}

}  // namespace

Vector3d point_on_hair(const HairCourse& course, double along) {
  const double angle = course.azimuth * kDegree;
  const Vector3d parting = side_parting(course.parting);
  const Vector3d widest{std::sin(angle), 0.0, std::cos(angle)};
  const double arc = std::acos(parting.dot(widest)) * mannequin::kCraniumRadii.mean() * (1.0 - course.start);
  const double drop = std::max(mannequin::kCraniumCenter.y() - course.tip_height, 0.0);
  const double travelled = along * (arc + drop);

  const double on_skull = std::min(travelled / arc, 1.0);
  // Straight above its end, so that hair arrives there hanging.
  const Vector3d control = widest + 0.75 * Vector3d::UnitY();
  const Vector3d direction =
      direction_on_curve(parting, control, widest, course.start + (1.0 - course.start) * on_skull);
  const double root_lift = kScalpLift + 0.45 * course.lift;
  const double lift = root_lift + (course.lift - root_lift) * mannequin::smooth_step(0.0, 0.06, travelled);
  Vector3d point =
      mannequin::kCraniumCenter + (mannequin::kCraniumRadii.array() + lift).matrix().cwiseProduct(direction);

  const double fallen = std::max(travelled - arc, 0.0);
  if (fallen > 0) {
    const double share = fallen / drop;
    point.y() -= fallen;
    point += (course.flare * mannequin::smooth_step(0.0, 0.75, share) -
              course.curl * mannequin::smooth_step(0.55, 1.15, share)) *
             widest;
  }
  return pushed_clear(point, 0.003 + 0.5 * course.lift, mannequin::head_distance, mannequin::head_normal);
}

double azimuth_of(const Vector3d& point) {
  return std::atan2(point.x(), point.z() - mannequin::kCraniumCenter.z()) / kDegree;
}

}  // namespace coif::research
