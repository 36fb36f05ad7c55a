#include "mannequin/head_shape.h"

#include "mannequin/solid_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::mannequin {
namespace {

using Eigen::Vector3d;

constexpr double kGradientStep = 2e-4;  // metres

double neck(const Vector3d& p) { return rod(p, {0, 1.520, -0.028}, {0, 1.380, -0.040}, 0.047, 0.052); }

double throat(const Vector3d& p) { return rod(p, {0, 1.480, 0.012}, {0, 1.395, 0.004}, 0.022, 0.020); }

double neck_and_shoulders(const Vector3d& p) {
  const double trapezius = rod(p, {0.020, 1.413, -0.040}, {0.150, 1.350, -0.036}, 0.040, 0.050);
  const double chest = ellipsoid(p, {0, 1.270, -0.022}, {0.195, 0.132, 0.094});
  const double collar_bone = rod(p, {0.018, 1.368, 0.028}, {0.125, 1.380, -0.006}, 0.008, 0.009);
  double body = join(neck(p), join(trapezius, chest, 0.060), 0.050);
  body = join(body, throat(p), 0.030);
  return join(body, collar_bone, 0.022);
}

/// The skull with cheeks, jaw and chin. `p` has x >= 0: the face is symmetric.
double skull(const Vector3d& p) {
  const double cranium = ellipsoid(p, kCraniumCenter, kCraniumRadii);
  const double face = ellipsoid(p, {0, 1.560, 0.020}, {0.0600, 0.082, 0.066});
  const double jaw = rod(p, {0.039, 1.534, 0.004}, {0.011, 1.496, 0.061}, 0.018, 0.016);
  const double chin = ellipsoid(p, {0, 1.493, 0.067}, {0.019, 0.016, 0.016});
  const double cheek = ellipsoid(p, {0.036, 1.563, 0.054}, {0.022, 0.024, 0.022});
  double head = join(cranium, face, 0.045);
  head = join(head, jaw, 0.040);
  head = join(head, chin, 0.025);
  return join(head, cheek, 0.030);
}

double with_eyes(double head, const Vector3d& p) {
  const double brow = rod(p, {0.012, 1.6090, 0.0800}, {0.043, 1.6110, 0.0650}, 0.0065, 0.0055);
  const double socket = ellipsoid(p, {0.0310, 1.5930, 0.0980}, {0.0190, 0.0115, 0.0160});
  const double lid = ellipsoid(p, {0.0310, 1.5915, 0.0690}, {0.0165, 0.0120, 0.0150});
  head = join(head, brow, 0.022);
  head = carve(head, socket, 0.020);
  return join(head, lid, 0.006);
}

double with_nose_and_mouth(double head, const Vector3d& p) {
  const double bridge = rod(p, {0, 1.6050, 0.0805}, {0, 1.5620, 0.1020}, 0.0045, 0.0070);
  const double wing = ellipsoid(p, {0.0090, 1.5575, 0.0950}, {0.0058, 0.0055, 0.0085});
  const double mouth = ellipsoid(p, {0, 1.5240, 0.0710}, {0.0300, 0.0200, 0.0160});
  const double upper_lip = rod(p, {0.0030, 1.5300, 0.0895}, {0.0200, 1.5250, 0.0838}, 0.0046, 0.0020);
  const double lower_lip = rod(p, {0.0000, 1.5195, 0.0885}, {0.0170, 1.5228, 0.0838}, 0.0056, 0.0024);
  head = join(head, mouth, 0.030);
  head = join(head, bridge, 0.020);
  head = join(head, wing, 0.010);
  return join(head, join(upper_lip, lower_lip, 0.0010), 0.006);
}

double face(const Vector3d& p) { return with_nose_and_mouth(with_eyes(skull(p), p), p); }

}  // namespace

double head_distance(const Vector3d& point) {
  const Vector3d p{std::abs(point.x()), point.y(), point.z()};
  const double bust = join(face(p), neck_and_shoulders(p), 0.030);
  constexpr double kBase = 1.280;  // The bust stands on a flat base here.
  return carve(bust, p.y() - kBase, 0.012);
}

Vector3d head_normal(const Vector3d& point) { return unit_gradient(head_distance, point, kGradientStep); }

double bare_head_distance(const Vector3d& point) {
  const Vector3d p{std::abs(point.x()), point.y(), point.z()};
  const double head = join(face(p), join(neck(p), throat(p), 0.030), 0.030);
  constexpr double kBase = 1.400;  // The neck stands on a flat base here.
  return carve(head, p.y() - kBase, 0.030);
}

Vector3d bare_head_normal(const Vector3d& point) { return unit_gradient(bare_head_distance, point, kGradientStep); }

SurfaceMesh make_bust() {
  // Finest at the face.
  const SamplingGrid grid{graded_axis(-0.222, 0.222, 0.0180, -0.032, 0.032, 0.0038),
                          graded_axis(1.258, 1.735, 0.0150, 1.505, 1.608, 0.0036),
                          graded_axis(-0.150, 0.120, 0.0140, 0.066, 0.120, 0.0038)};
  return extract_surface(grid, head_distance, head_normal);
}

SurfaceMesh make_bare_head() {
  const SamplingGrid grid{graded_axis(-0.118, 0.118, 0.0200, -0.032, 0.032, 0.0046),
                          graded_axis(1.380, 1.735, 0.0180, 1.505, 1.608, 0.0046),
                          graded_axis(-0.150, 0.120, 0.0180, 0.066, 0.120, 0.0048)};
  return extract_surface(grid, bare_head_distance, bare_head_normal);
}

SurfaceMesh make_scalp_cap(const Field& distance, const Gradient& normal) {
  constexpr int kAround = 60;
  constexpr int kRings = 14;
  constexpr double kClearance = 0.0015;  // Metres above the skin.
  SurfaceMesh cap;
  const auto add = [&](const Vector3d& direction) {
    Vector3d p = kCraniumCenter + kCraniumRadii.cwiseProduct(direction);
    for (int i = 0; i < 4; ++i) p -= (distance(p) - kClearance) * normal(p);
    cap.positions.push_back(p);
    cap.normals.push_back(normal(p));
  };
  add(Vector3d::UnitY());
  for (int ring = 1; ring <= kRings; ++ring) {
    for (int step = 0; step < kAround; ++step) {
      const double azimuth = 2.0 * std::numbers::pi * step / kAround;
      const double backness = 0.5 - 0.5 * std::cos(azimuth);
      // The hairline: high above the forehead, past the ears, low at the nape.
      const double lowest = 0.70 - 0.60 * smooth_step(0.02, 0.42, backness) - 0.85 * smooth_step(0.36, 0.85, backness);
      const double elevation = std::numbers::pi / 2 + (lowest - std::numbers::pi / 2) * ring / kRings;
      add({std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)});
    }
  }
  const auto index = [](int ring, int step) {
    return static_cast<std::uint32_t>(ring == 0 ? 0 : 1 + (ring - 1) * kAround + step % kAround);
  };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int step = 0; step < kAround; ++step) {
      const std::uint32_t a = index(ring, step), b = index(ring, step + 1);
      const std::uint32_t c = index(ring + 1, step), d = index(ring + 1, step + 1);
      if (ring > 0) cap.triangles.insert(cap.triangles.end(), {a, c, b});
      cap.triangles.insert(cap.triangles.end(), {b, c, d});
    }
  }
  return cap;
}

}  // namespace coif::mannequin
