#include "research/sample/bob.h"

#include "research/sample/strips.h"

#include <algorithm>
#include <cmath>

namespace coif::research {
namespace {

/// The layer next to the skull: it closes the hair, so it is broad and as long as the cut.
StripStyle panel(double azimuth, double half_width, double parting_from, double parting_to) {
  return {
      .course = {.azimuth = azimuth, .start = 0.03, .lift = 0.007, .tip_height = 1.428, .flare = 0.004, .curl = 0.022},
      .columns = 7,
      .rows = 9,
      .half_width = half_width,
      .parting_from = parting_from,
      .parting_to = parting_to,
      .bulge = 0.001,
      .taper = 0.12,
      .window = kBroadWindow};
}

/// A lock of the middle layer, full length.
StripStyle lock(double azimuth, double half_width, double parting_from, double parting_to, int window) {
  return {
      .course = {.azimuth = azimuth, .start = 0.02, .lift = 0.012, .tip_height = 1.425, .flare = 0.009, .curl = 0.032},
      .half_width = half_width,
      .parting_from = parting_from,
      .parting_to = parting_to,
      .bulge = 0.005,
      .taper = 0.30,
      .window = kClumpWindows[static_cast<std::size_t>(window)]};
}

/// A lock of the outer layer: shorter, so that the layers show.
StripStyle top_lock(double azimuth, double half_width, double parting_from, double parting_to, int window) {
  StripStyle style = lock(azimuth, half_width, parting_from, parting_to, window);
  style.course.start = -0.015;  // Over the parting, which then shows no gap.
  style.course.lift = 0.020;
  style.bulge = 0.006;
  style.course.tip_height = 1.462;
  style.course.flare = 0.012;
  style.course.curl = 0.030;
  style.taper = 0.38;
  return style;
}

/// An outer lock at the back, whose hairs all start near the crown.
StripStyle crown_lock(double azimuth, double half_width, double parting_from, double parting_to, int window) {
  StripStyle style = top_lock(azimuth, half_width, parting_from, parting_to, window);
  style.course.start = 0.01;
  return style;
}

/// A lock that falls over the forehead and is combed towards the model's right.
StripStyle fringe(double azimuth, double half_width, double parting_from, double parting_to, double lift, int window) {
  StripStyle style = lock(azimuth, half_width, parting_from, parting_to, window);
  style.course.lift = lift;
  style.sweep = -14;
  style.course.tip_height = 1.600;
  style.course.flare = 0.002;
  style.course.curl = 0.002;
  style.taper = 0.25;
  return style;
}

/// The short side of the parting: combed back over the temple.
StripStyle side_fringe(double azimuth, double half_width, double parting_from, double parting_to, int window) {
  StripStyle style = fringe(azimuth, half_width, parting_from, parting_to, 0.014, window);
  style.course.start = 0.0;
  style.sweep = 16;
  style.course.tip_height = 1.545;
  style.course.flare = 0.014;
  style.course.curl = 0.004;
  style.taper = 0.5;
  return style;
}

void append_copies(StripStyle style, const BobDensity& density, unsigned first_seed, mannequin::SurfaceMesh& mesh) {
  style.columns = std::max(1, int(std::lround(style.columns * density.quads)));
  style.rows = std::max(1, int(std::lround(style.rows * density.quads)));
  const double spread = 0.5 * style.half_width / density.copies;  // Degrees and metres that set copies apart.
  const double rise = 0.003 / density.copies;
  for (int copy = 0; copy < density.copies; ++copy) {
    append_strip(style, first_seed + 1000 * unsigned(copy), mesh);
    style.course.azimuth += spread;
    style.course.lift += rise;
  }
}

}  // namespace

mannequin::SurfaceMesh make_bob_hair(const BobDensity& density) {
  const StripStyle styles[] = {
      panel(72, 30, 0.10, 0.80),          panel(124, 32, 0.75, 1.00),           panel(180, 36, 0.80, 0.80),
      panel(-124, 32, 1.00, 0.75),        panel(-72, 30, 0.80, 0.10),

      lock(62, 15, 0.05, 0.40, 0),        lock(90, 20, 0.35, 0.75, 1),          lock(122, 20, 0.70, 0.95, 2),
      lock(152, 19, 0.92, 1.00, 3),       lock(180, 18, 0.86, 0.86, 0),         lock(-152, 19, 1.00, 0.92, 1),
      lock(-122, 20, 0.95, 0.70, 2),      lock(-90, 20, 0.75, 0.35, 3),         lock(-62, 15, 0.40, 0.05, 0),

      top_lock(76, 17, 0.15, 0.60, 2),    top_lock(106, 17, 0.55, 0.85, 3),     crown_lock(137, 17, 0.82, 0.98, 0),
      crown_lock(167, 16, 0.91, 0.93, 1), crown_lock(-167, 16, 0.93, 0.91, 2),  crown_lock(-137, 17, 0.98, 0.82, 3),
      top_lock(-106, 17, 0.85, 0.55, 1),  top_lock(-76, 17, 0.60, 0.15, 0),

      side_fringe(38, 15, 0.01, 0.24, 3), fringe(12, 20, 0.06, 0.06, 0.012, 2), fringe(-21, 22, 0.36, 0.06, 0.017, 1),
  };
  mannequin::SurfaceMesh mesh;
  unsigned seed = 1;
  for (const StripStyle& style : styles) append_copies(style, density, seed++, mesh);
  return mesh;
}

}  // namespace coif::research
