#include "cards/even_strands.h"

#include "base/geometry.h"

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

/// Points at even shares of a polyline's length; returns that.
float resample(std::span<const Eigen::Vector3f> line, bool from_end, std::span<Eigen::Vector3f> out) {
  const auto at = [&](std::size_t i) -> const Eigen::Vector3f& { return line[from_end ? line.size() - 1 - i : i]; };
  float length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (at(i) - at(i - 1)).norm();
  std::size_t segment = 1;
  float before = 0, long_ = (at(1) - at(0)).norm();
  for (std::size_t k = 0; k < out.size(); ++k) {
    const float wanted = length * float(k) / float(out.size() - 1);
    while (segment + 1 < line.size() && before + long_ < wanted) {
      before += long_;
      ++segment;
      long_ = (at(segment) - at(segment - 1)).norm();
    }
    const float share = long_ > 0 ? std::clamp((wanted - before) / long_, 0.0f, 1.0f) : 0.0f;
    out[k] = at(segment - 1) + share * (at(segment) - at(segment - 1));
  }
  out.back() = at(line.size() - 1);
  return length;
}

struct Sphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0;
  double residual = 1;  ///< Median distance from its surface, in radii.
};

/// The sphere that points lie on, by least squares of |p|^2 = 2 c p + d, once for all and once for the nearer half.
Sphere sphere_of(const std::vector<Eigen::Vector3f>& points) {
  std::vector<Eigen::Vector3f> kept = points;
  Sphere sphere;
  for (int round = 0; round < 2; ++round) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& p : kept) middle += p.cast<double>() / double(kept.size());
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const Eigen::Vector3f& p : kept) {
      const Eigen::Vector3d q = p.cast<double>() - middle;
      const Eigen::Vector4d row(2 * q.x(), 2 * q.y(), 2 * q.z(), 1);
      normal += row * row.transpose();
      right += row * q.squaredNorm();
    }
    const Eigen::Vector4d found = least_squares(normal, right);
    sphere.center = middle + found.head<3>();
    sphere.radius = std::sqrt(std::max(found.w() + found.head<3>().squaredNorm(), 0.0));
    if (!(sphere.radius > 0)) return sphere;
    const auto off = [&](const Eigen::Vector3f& p) {
      return std::abs((p.cast<double>() - sphere.center).norm() / sphere.radius - 1);
    };
    const auto half = kept.begin() + std::ptrdiff_t(kept.size() / 2);
    std::ranges::nth_element(kept, half, {}, off);
    sphere.residual = off(*half);
    if (kept.size() > 8) kept.erase(half + 1, kept.end());
  }
  return sphere;
}

}  // namespace

EvenStrands even_strands(const Groom& groom, std::span<const std::uint8_t> is_reversed) {
  EvenStrands even;
  even.points.resize(groom.strand_count() * EvenStrands::kStations);
  even.lengths.resize(groom.strand_count());
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    const bool from_end = !is_reversed.empty() && is_reversed[i] != 0;
    even.lengths[i] = resample(groom.strand(i), from_end,
                               std::span(even.points).subspan(i * EvenStrands::kStations, EvenStrands::kStations));
  }
  return even;
}

std::vector<std::uint8_t> find_reversed_strands(const Groom& groom) {
  std::vector<std::uint8_t> reversed(groom.strand_count(), 0);
  if (groom.root_first || groom.strand_count() == 0) return reversed;
  std::vector<Eigen::Vector3f> first, last;
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    first.push_back(groom.strand(i).front());
    last.push_back(groom.strand(i).back());
  }
  const Sphere of_first = sphere_of(first), of_last = sphere_of(last);
  const Sphere& scalp = of_first.residual <= of_last.residual ? of_first : of_last;
  const auto off = [&](const Eigen::Vector3f& p) { return std::abs((p.cast<double>() - scalp.center).norm() - scalp.radius); };
  const bool mostly = &scalp == &of_last;
  for (std::size_t i = 0; i < reversed.size(); ++i) {
    // The other way round only where that is beyond doubt: hair that lies on the head has both ends near the scalp.
    const double begin = off(first[i]), end = off(last[i]);
    const bool is_odd = mostly ? begin < 0.1 * scalp.radius && end > 3 * begin + 0.2 * scalp.radius
                               : end < 0.1 * scalp.radius && begin > 3 * end + 0.2 * scalp.radius;
    reversed[i] = mostly != is_odd;
  }
  return reversed;
}

}  // namespace coif
