#include "research/sample/long.h"

#include "base/geometry.h"
#include "mannequin/head_shape.h"
#include "mannequin/solid_shapes.h"
#include "research/sample/strips.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace coif::research {
namespace {

using Eigen::Vector3d;

constexpr double kRootLift = 0.006;   // Metres; roots lie close to the scalp, outer rows above inner ones.
constexpr double kAxisZ = -0.030;     // The hanging hair gathers around this vertical line.
constexpr double kGathered = 0.95;    // Distance at the tips, as a share of that at the widest line.
constexpr double kClearance = 0.006;  // Metres between a lock's middle line and the skin.

/// A centre parting from the forehead over the crown: 0..1.
Vector3d parting_direction(double t) {
  static const Vector3d kForehead = Vector3d(0.0, 0.66, 0.75).normalized();
  static const Vector3d kBack = Vector3d(0.0, 0.62, -0.79).normalized();
  return direction_on_curve(kForehead, 1.1 * Vector3d::UnitY(), kBack, t);
}

/// Degrees from the face to either side, 0..180.
double to_side(double azimuth) { return azimuth > 180.0 ? 360.0 - azimuth : azimuth; }

/// The place on the parting of the hair that passes the widest line at this azimuth.
double parting_place(double azimuth) { return (to_side(azimuth) - 25.0) / 160.0; }

Vector3d turned(const Vector3d& v, double degrees) {
  const double c = std::cos(degrees * kDegree), s = std::sin(degrees * kDegree);
  return {c * v.x() + s * v.z(), v.y(), c * v.z() - s * v.x()};
}

Vector3d above_skull(const Vector3d& direction, double lift) {
  return mannequin::kCraniumCenter + (mannequin::kCraniumRadii.array() + lift).matrix().cwiseProduct(direction);
}

/// The free part: gathered below the head, moved aside, waved.
Vector3d hanging(const LockCourse& course, const Vector3d& point, double share, double along) {
  Vector3d from_axis{point.x(), 0.0, point.z() - kAxisZ};
  const Vector3d outwards = from_axis.normalized(), aside = outwards.cross(Vector3d::UnitY());
  from_axis *= 1.0 + (kGathered - 1.0) * mannequin::smooth_step(0.0, 0.9, share);
  from_axis = turned(from_axis, course.sweep * mannequin::smooth_step(0.0, 1.0, share));
  const double angle = 2.0 * std::numbers::pi * (course.wave_turns * along + course.wave_phase);
  const double swing = course.wave * mannequin::smooth_step(0.05, 0.6, share);
  return Vector3d(0.0, point.y(), kAxisZ) + from_axis +
         swing * (std::sin(angle) * aside + 0.6 * std::cos(angle) * outwards);
}

/// The directions of a course's angles.
struct LockPath {
  /// Unit directions: where it starts, passes the widest line, and leaves the skull.
  Vector3d parting, widest, lowest;
  double on_skull, hanging;  ///< Lengths, metres.

  explicit LockPath(const LockCourse& course) {
    const double below = 0.5 * std::numbers::pi * std::max(course.start - 1.0, 0.0);
    widest = turned(Vector3d::UnitZ(), course.azimuth);
    lowest = std::cos(below) * widest - std::sin(below) * Vector3d::UnitY();
    parting = parting_direction(parting_place(course.azimuth));
    on_skull = std::acos(parting.dot(widest)) * mannequin::kCraniumRadii.mean() * std::max(1.0 - course.start, 0.0);
    hanging = above_skull(lowest, course.lift).y() - course.tip_height;
  }

  /// The direction on the way over the skull; `share` 0..1 of that way.
  [[nodiscard]] Vector3d direction(double start, double share) const {
    if (start >= 1.0 || share >= 1.0) return lowest;
    // Straight above its end, so that hair arrives there hanging.
    const Vector3d control = widest + 0.75 * Vector3d::UnitY();
    return direction_on_curve(parting, control, widest, start + (1.0 - start) * share);
  }
};

}  // namespace

Vector3d point_on_lock(const LockCourse& course, double along) {
  const LockPath path(course);
  const double travelled = along * (path.on_skull + path.hanging);
  const double share = path.on_skull > 0.0 ? travelled / path.on_skull : 1.0;
  const double root_lift = std::min(kRootLift, course.lift);
  const double lift = root_lift + (course.lift - root_lift) * mannequin::smooth_step(0.0, 0.10, travelled);
  Vector3d point = above_skull(path.direction(course.start, share), lift);
  const double fallen = travelled - path.on_skull;
  if (fallen > 0.0) {
    point.y() -= fallen;
    point = hanging(course, point, fallen / path.hanging, along);
  }
  return pushed_clear(point, kClearance, mannequin::bare_head_distance, mannequin::bare_head_normal);
}

double chain_start(const LockCourse& course) {
  // Metres of the chain that lie on the skull, for a soft bend where hair leaves it.
  constexpr double kOnSkull = 0.015;
  const LockPath path(course);
  return std::max(path.on_skull - kOnSkull, 0.0) / (path.on_skull + path.hanging);
}

std::vector<Lock> make_locks() {
  struct Row {
    int locks;
    /// Azimuth where the row begins on the model's left; it ends at the same distance from the face on the right.
    double front;
    double start, lift, shorter;
  };
  // The numbers of locks follow the rows' lengths on the scalp, so that roots are evenly spread.
  constexpr std::array<Row, 5> kRows{{{28, 47, 0.01, 0.019, 0.030},
                                      {26, 62, 0.30, 0.016, 0.015},
                                      {22, 74, 0.58, 0.013, 0.000},
                                      {16, 88, 0.88, 0.010, 0.000},
                                      {8, 122, 1.30, 0.008, 0.020}}};
  mannequin::SeededNoise noise(100);
  std::vector<Lock> locks;
  for (std::size_t r = 0; r < kRows.size(); ++r) {
    const Row& row = kRows[r];
    for (int i = 0; i < row.locks; ++i) {
      Lock lock;
      lock.row = static_cast<int>(r);
      lock.next = i + 1 < row.locks ? static_cast<int>(locks.size()) + 1 : -1;
      lock.spacing = (360.0 - 2.0 * row.front) / row.locks;
      LockCourse& course = lock.course;
      course.azimuth = row.front + (i + 0.5) * lock.spacing;
      const double side = to_side(course.azimuth);
      course.start = row.start;
      course.lift = row.lift;
      // Shorter towards the face, which it frames, and there swept back.
      course.tip_height =
          0.965 + row.shorter + 0.11 * mannequin::smooth_step(130.0, 50.0, side) + noise.between(-0.018, 0.018);
      course.sweep = (course.azimuth < 180.0 ? 1.0 : -1.0) * 14.0 * mannequin::smooth_step(130.0, 60.0, side);
      course.wave = noise.between(0.009, 0.017);
      course.wave_turns = noise.between(1.9, 2.5);
      // Neighbours swing nearly together.
      course.wave_phase = 0.3 * std::sin(3.0 * side * kDegree) + noise.between(-0.12, 0.12);
      locks.push_back(lock);
    }
  }
  return locks;
}

}  // namespace coif::research
