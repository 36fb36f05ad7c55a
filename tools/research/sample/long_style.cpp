#include "research/sample/long.h"

#include "mannequin/solid_shapes.h"
#include "research/sample/strips.h"

#include <algorithm>
#include <array>

namespace coif::research {
namespace {

using Eigen::Vector3d;

constexpr int kColumns = 2, kRows = 25;

/// One strip of a lock, with the values that differ between strips.
struct LockStrip {
  int a = 0, b = 0;        ///< Locks between which it lies.
  LockCourse course;       ///< The course of its middle.
  double half_width = 10;  ///< Degrees.
  double bulge = 0.003;    ///< Height of the middle above the edges, metres.
  double taper = 0.4;      ///< Share of the width lost at the tip.
  double twist = 0;        ///< Height of one edge of the tip above the other, metres.
  TextureWindow window;
};

LockCourse middle_of(const LockCourse& a, const LockCourse& b) {
  const auto mean = [](double x, double y) { return 0.5 * (x + y); };
  return {.azimuth = mean(a.azimuth, b.azimuth),
          .start = mean(a.start, b.start),
          .lift = mean(a.lift, b.lift),
          .tip_height = mean(a.tip_height, b.tip_height),
          .sweep = mean(a.sweep, b.sweep),
          .wave = mean(a.wave, b.wave),
          .wave_turns = mean(a.wave_turns, b.wave_turns),
          .wave_phase = mean(a.wave_phase, b.wave_phase)};
}

Vector3d point_on(const LockStrip& strip, double across, double along) {
  LockCourse course = strip.course;
  course.azimuth += across * strip.half_width * (1.0 - strip.taper * mannequin::smooth_step(0.45, 1.0, along));
  course.lift +=
      strip.bulge * (1.0 - across * across) * mannequin::smooth_step(0.0, 0.15, along) + strip.twist * across * along;
  return point_on_lock(course, along);
}

/// Closer on the skull, which is round, than where hair hangs.
std::array<double, kRows + 1> row_places() {
  constexpr int kRowsOnSkull = 9;
  constexpr double kOnSkull = 0.20;
  std::array<double, kRows + 1> places{};
  for (int row = 0; row <= kRows; ++row) {
    const int beyond = std::max(row - kRowsOnSkull, 0);
    places[static_cast<std::size_t>(row)] =
        kOnSkull * std::min(row, kRowsOnSkull) / kRowsOnSkull + (1.0 - kOnSkull) * beyond / (kRows - kRowsOnSkull);
  }
  return places;
}

void append(std::span<const Lock> locks, const LockStrip& strip, mannequin::SurfaceMesh& mesh) {
  const auto places = row_places();
  append_grid(
      kColumns, places, strip.window, [&](double across, double along) { return point_on(strip, across, along); },
      mesh);
  const double start = chain_start(strip.course);
  for (const double place : places) {
    const double along = (place - start) / (1.0 - start);
    for (int column = 0; column <= kColumns; ++column) {
      const double share_b = strip.a == strip.b ? 0.0 : 0.25 + 0.5 * column / kColumns;
      mesh.skin.push_back(lock_influences(locks, strip.a, strip.b, share_b, along));
    }
  }
}

/// On the lock itself; from the third row on the hair of others hides it, so it may be broad and plain.
LockStrip base_strip(const Lock& lock, int index, mannequin::SeededNoise& noise) {
  LockStrip strip;
  strip.a = strip.b = index;
  strip.course = lock.course;
  strip.half_width = 0.85 * lock.spacing;
  strip.twist = noise.between(-0.006, 0.006);
  strip.taper = noise.between(0.25, 0.45);
  const auto window = static_cast<std::size_t>(noise.between(0.0, double(kClumpWindows.size())));
  strip.window = lock.row >= 2 ? kBroadWindow : kClumpWindows[window];
  return strip;
}

/// Above the gap to the next lock; at the end of the row above the lock itself, a little aside.
LockStrip bridging_strip(std::span<const Lock> locks, int index, mannequin::SeededNoise& noise) {
  const Lock& lock = locks[static_cast<std::size_t>(index)];
  LockStrip strip;
  strip.a = index;
  strip.b = lock.next < 0 ? index : lock.next;
  strip.course = middle_of(lock.course, locks[static_cast<std::size_t>(strip.b)].course);
  strip.course.lift += 0.003;
  if (lock.next < 0) strip.course.azimuth -= 0.25 * lock.spacing;
  strip.course.tip_height += noise.between(0.0, 0.05);
  strip.half_width = 0.70 * lock.spacing;
  strip.taper = noise.between(0.45, 0.65);
  strip.twist = noise.between(-0.008, 0.008);
  strip.window = kClumpWindows[static_cast<std::size_t>(noise.between(0.0, double(kClumpWindows.size())))];
  return strip;
}

}  // namespace

mannequin::SurfaceMesh make_long_hair(std::span<const Lock> locks) {
  mannequin::SurfaceMesh mesh;
  mannequin::SeededNoise noise(16);
  for (int l = 0; l < static_cast<int>(locks.size()); ++l) {
    append(locks, base_strip(locks[static_cast<std::size_t>(l)], l, noise), mesh);
    append(locks, bridging_strip(locks, l, noise), mesh);
  }
  return mesh;
}

}  // namespace coif::research
