#include "mannequin/portrait.h"

#include "mannequin/head_shape.h"
#include "mannequin/portrait_head.h"
#include "mannequin/solid_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace coif::mannequin {
namespace {

using Eigen::Vector3d;

constexpr double kNeckCut = 1.4480;    ///< Model Y of the end of a neck without shoulders.
constexpr double kShirtLine = 1.3200;  ///< Model Y below which the shirt covers all skin.

/// `axis` with more coordinates where it is coarser than `fine` between `from` and `to`.
std::vector<double> refined(const std::vector<double>& axis, double from, double to, double fine) {
  std::vector<double> out;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const bool is_there = axis[i + 1] > from && axis[i] < to;
    const int pieces = is_there ? int(std::ceil((axis[i + 1] - axis[i]) / fine)) : 1;
    for (int k = 0; k < pieces; ++k) out.push_back(axis[i] + (axis[i + 1] - axis[i]) * k / pieces);
  }
  out.push_back(axis.back());
  return out;
}

/// Closest where lids, nostrils and lips are, and closer than elsewhere at the ears.
SurfaceMesh portrait_skin(const PortraitDetail& detail) {
  const double f = detail.spacing;
  const double cut = detail.has_shoulders ? kShirtLine : kNeckCut, widest = detail.has_shoulders ? 0.216 : 0.110;
  SamplingGrid grid{graded_axis(-widest, widest, 0.0130 * f, -0.050, 0.050, 0.00125 * f),
                    graded_axis(cut - 0.015, 1.735, 0.0110 * f, 1.526, 1.616, 0.00130 * f),
                    graded_axis(-0.150, 0.120, 0.0110 * f, 0.062, 0.104, 0.00150 * f)};
  for (const double side : {-1.0, 1.0})
    grid[0] = refined(grid[0], side * 0.078 - 0.010, side * 0.078 + 0.010, 0.0024 * f * f);
  grid[2] = refined(grid[2], -0.036, 0.010, 0.0032 * f * f);
  const double edge = detail.has_shoulders ? 0.004 : 0.020;
  const auto distance = [&](const Vector3d& point) { return carve(portrait_distance(point), point.y() - cut, edge); };
  const auto normal = [&](const Vector3d& point) { return unit_gradient(distance, point, 1.5e-4); };
  SurfaceMesh mesh = extract_surface(grid, distance, normal);
  for (const Vector3d& point : mesh.positions) mesh.uvs.push_back(skin_place(point));
  return mesh;
}

SurfaceMesh portrait_garment(const PortraitDetail& detail) {
  const double f = detail.spacing;
  const SamplingGrid grid{graded_axis(-0.226, 0.226, 0.0090 * f, -0.11, 0.11, 0.0060 * f),
                          graded_axis(1.035, 1.500, 0.0110 * f, 1.330, 1.440, 0.0050 * f),
                          graded_axis(-0.150, 0.130, 0.0090 * f, -0.10, 0.100, 0.0060 * f)};
  const auto normal = [](const Vector3d& point) { return unit_gradient(garment_distance, point, 2e-4); };
  return extract_surface(grid, garment_distance, normal);
}

/// The front half of an eyeball; `side` 1 is the left, -1 the right.
void append_eye(double side, SurfaceMesh& mesh) {
  constexpr int kEyeRings = 20, kEyeSectors = 40;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int ring = 0; ring <= kEyeRings; ++ring) {
    const double polar = 0.58 * std::numbers::pi * ring / kEyeRings;
    for (int sector = 0; sector <= kEyeSectors; ++sector) {
      const double around = 2 * std::numbers::pi * sector / kEyeSectors;
      const Vector3d unit{std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)};
      const Vector3d outwards{side, 1, 1};
      mesh.positions.push_back((kEyeCenter + kEyeRadii.cwiseProduct(unit)).cwiseProduct(outwards));
      mesh.normals.push_back(unit.cwiseQuotient(kEyeRadii).normalized().cwiseProduct(outwards));
      // In the radii of a round eye, so that the iris is round on an eye that is not.
      const double wide = unit.x() * kEyeRadii.x() / kEyeRadii.y();
      mesh.uvs.emplace_back(0.5 + 0.5 * wide / kEyeImageReach, 0.5 - 0.5 * unit.y() / kEyeImageReach);
    }
  }
  constexpr int kRow = kEyeSectors + 1;
  for (int ring = 0; ring < kEyeRings; ++ring) {
    for (int sector = 0; sector < kEyeSectors; ++sector) {
      const std::uint32_t a = first + static_cast<std::uint32_t>(ring * kRow + sector), b = a + kRow;
      if (side > 0)
        mesh.triangles.insert(mesh.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
      else
        mesh.triangles.insert(mesh.triangles.end(), {a, b + 1, b, a, a + 1, b + 1});
    }
  }
}

/// One lash: three quads that get narrower, from a point of the lid's edge.
struct Lash {
  Vector3d root, outwards, up;  ///< Metres; unit vectors.
  double length, rise;          ///< Metres that it gets out, and up.
  double width;
};

void append_lash(const Lash& lash, double side, SurfaceMesh& mesh) {
  constexpr int kPieces = 4;
  const Vector3d across = Vector3d(lash.outwards.z(), 0, -lash.outwards.x()).normalized();
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i <= kPieces; ++i) {
    const double t = double(i) / kPieces;
    const Vector3d middle = lash.root + lash.length * t * lash.outwards + lash.rise * t * t * lash.up;
    const double half = 0.5 * lash.width * (1 - 0.85 * t);
    for (const double edge : {-half, half}) {
      mesh.positions.push_back((middle + edge * across).cwiseProduct(Vector3d(side, 1, 1)));
      mesh.normals.push_back((lash.up - lash.outwards * 0.3).normalized().cwiseProduct(Vector3d(side, 1, 1)));
    }
  }
  for (std::uint32_t i = 0; i < kPieces; ++i) {
    const std::uint32_t a = first + 2 * i;
    mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
  }
}

/// The skin's foremost point there, a little above it.
Vector3d in_front_of_skin(double x, double y) {
  Vector3d point{x, y, 0.100};
  for (int i = 0; i < 40; ++i) point.z() -= 0.9 * (portrait_distance(point) - 0.0001);
  return point;
}

/// On the lid's edge, at `across` of its opening.
Lash lash_at(double across, bool is_upper, SeededNoise& noise) {
  const double x = kOpeningMiddle + kOpeningHalf * across;
  const LidEdges edges = lid_edges(x);
  Lash lash;
  lash.root = in_front_of_skin(x, is_upper ? edges.upper + 0.0011 : edges.lower - 0.0010);
  const double fan = 0.10 + 0.80 * across + noise.between(-0.10, 0.10);
  lash.outwards = Vector3d(fan, is_upper ? 0.10 : -0.50, 1).normalized();
  lash.up = is_upper ? Vector3d::UnitY() : Vector3d(-Vector3d::UnitY());
  const double full = is_upper ? 0.0066 + 0.0020 * across : 0.0019;
  lash.length = full * (1 - 0.30 * across * across) * noise.between(0.85, 1.08);
  lash.rise = lash.length * (is_upper ? 0.60 : 0.20) * noise.between(0.85, 1.15);
  lash.width = is_upper ? 0.00042 : 0.00020;
  return lash;
}

SurfaceMesh portrait_lashes() {
  constexpr int kUpperLashes = 54, kLowerLashes = 14;
  SurfaceMesh mesh;
  SeededNoise noise(31);
  for (const double side : {1.0, -1.0}) {
    for (int i = 0; i < kUpperLashes; ++i)
      append_lash(lash_at(-0.90 + 1.86 * (i + noise.between(0, 0.7)) / kUpperLashes, true, noise), side, mesh);
    for (int i = 0; i < kLowerLashes; ++i)
      append_lash(lash_at(-0.55 + 1.45 * (i + noise.between(0, 0.8)) / kLowerLashes, false, noise), side, mesh);
  }
  return mesh;
}

}  // namespace

std::vector<PortraitPart> make_portrait_parts(const PortraitDetail& detail) {
  SurfaceMesh eyes;
  append_eye(1, eyes);
  append_eye(-1, eyes);
  std::vector<PortraitPart> parts;
  parts.push_back({"skin", portrait_skin(detail), {.roughness = 0.56}, skin_image(detail.texels)});
  parts.push_back({"eyes", std::move(eyes), {.roughness = 0.22}, eye_image()});
  const PortraitMaterial lashes{.red = 0.012, .green = 0.009, .blue = 0.008, .roughness = 0.7};
  parts.push_back({"lashes", portrait_lashes(), lashes, {}});
  const PortraitMaterial shirt{.red = 0.022, .green = 0.024, .blue = 0.030, .roughness = 0.85};
  if (detail.has_shoulders) parts.push_back({"shirt", portrait_garment(detail), shirt, {}});
  return parts;
}

}  // namespace coif::mannequin
