#include "sample/strip.h"

#include "sample/hair_flow.h"
#include "sample/seeded_noise.h"
#include "sample/smooth_step.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <vector>

namespace coif::sample {
namespace {

using Eigen::Vector3d;

/// What makes one lock differ from the next.
struct Irregularity {
  double wave_degrees, wave_turns, wave_phase, twist, length;

  explicit Irregularity(unsigned seed) {
    SeededNoise noise(seed);
    wave_degrees = noise.between(0.8, 2.2);
    wave_turns = noise.between(0.9, 1.5);
    wave_phase = noise.between(0.0, 1.0);
    twist = noise.between(-0.0035, 0.0035);  // Metres by which one edge of the tip stands above the other.
    length = noise.between(-0.006, 0.006);   // Metres.
  }
};

/// `across` -1..1, `along` 0..1.
Vector3d point_on_strip(const StripStyle& style, const Irregularity& odd, double across, double along) {
  const double width = style.half_width * (1.0 - style.taper * smooth_step(0.50, 1.0, along));
  const double wave =
      odd.wave_degrees * along * std::sin(2.0 * std::numbers::pi * (odd.wave_turns * along + odd.wave_phase));
  HairCourse course;
  course.parting = style.parting_from + (style.parting_to - style.parting_from) * 0.5 * (across + 1.0);
  course.azimuth = style.azimuth + across * width + wave + style.sweep * along * along;
  course.start = style.start;
  const double rounding = style.bulge * (1.0 - across * across) * smooth_step(0.0, 0.3, along);
  course.lift = style.lift + rounding + odd.twist * across * along;
  course.tip_height = style.tip_height + odd.length;
  course.flare = style.flare;
  course.curl = style.curl;
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
                 SurfaceMesh& mesh) {
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

void append_strip(const StripStyle& style, unsigned seed, SurfaceMesh& mesh) {
  const Irregularity odd(seed);
  const auto surface = [&](double across, double along) { return point_on_strip(style, odd, across, along); };
  std::vector<double> places;
  for (int row = 0; row <= style.rows; ++row) places.push_back(static_cast<double>(row) / style.rows);
  append_grid(style.columns, places, style.window, surface, mesh);
}

}  // namespace coif::sample
