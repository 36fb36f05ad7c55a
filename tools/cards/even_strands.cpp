#include "cards/even_strands.h"

#include "base/geometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::cards {
namespace {

/// Writes points at even shares of a polyline's length to `out` and returns the length.
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

constexpr int kSphereRounds = 20;      // until a sphere has settled
constexpr double kMostOff = 0.12;      // In radii: largest distance of the nearer two thirds of roots from a scalp.
constexpr double kLeastSpread = 0.12;  // radii, their deviation where it is least: many spheres hold a line or a ring
constexpr double kBeyondDoubt = 0.6;   // radii of the scalp that a tip is farther from it than the root

struct Sphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0;

  /// Distance from its surface, in radii.
  [[nodiscard]] double off(const Eigen::Vector3f& point) const {
    return std::abs((point.cast<double>() - center).norm() / radius - 1);
  }
};

/// The sphere that points lie on, by least squares of |p|^2 = 2 c p + d; radius 0: none.
Sphere sphere_of(std::span<const Eigen::Vector3f> points) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points) middle += p.cast<double>() / double(points.size());
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3d q = p.cast<double>() - middle;
    const Eigen::Vector4d row(2 * q.x(), 2 * q.y(), 2 * q.z(), 1);
    normal += row * row.transpose();
    right += row * q.squaredNorm();
  }
  const Eigen::Vector4d found = least_squares(normal, right);
  const double squared = found.w() + found.head<3>().squaredNorm();
  return {middle + found.head<3>(), squared > 0 && std::isfinite(squared) ? std::sqrt(squared) : 0.0};
}

/// The nearer two thirds of points that may lie on a sphere: hair of an animal's tail or of a beard has its roots
/// elsewhere.
std::span<const Eigen::Vector3f> nearer_to(const Sphere& sphere, std::vector<Eigen::Vector3f>& points) {
  const auto kept = points.begin() + std::ptrdiff_t(2 * points.size() / 3);
  std::ranges::nth_element(points, kept, {}, [&](const Eigen::Vector3f& p) { return sphere.off(p); });
  return std::span(points).first(std::max<std::size_t>(2 * points.size() / 3, std::min<std::size_t>(points.size(), 4)));
}

/// Coordinate by coordinate.
Eigen::Vector3d middle_of(std::vector<Eigen::Vector3f> points) {
  Eigen::Vector3d middle;
  const auto half = points.begin() + std::ptrdiff_t(points.size() / 2);
  for (int axis = 0; axis < 3; ++axis) {
    std::ranges::nth_element(points, half, {}, [&](const Eigen::Vector3f& p) { return p[axis]; });
    middle[axis] = double((*half)[axis]);
  }
  return middle;
}

/// Standard deviation of points along the axis on which it is least.
double least_spread(std::span<const Eigen::Vector3f> points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points) mean += p.cast<double>() / double(points.size());
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3d off = p.cast<double>() - mean;
    sum += off * off.transpose() / double(points.size());
  }
  const Eigen::Vector3d least = principal_axes(sum).col(2);
  return std::sqrt(std::max(least.dot(sum * least), 0.0));
}

/// Both ends of all strands, and tests of which lie on a scalp.
class StrandEnds {
 public:
  explicit StrandEnds(const groom::Groom& groom) {
    for (std::size_t i = 0; i < groom.strand_count(); ++i) {
      first_.push_back(groom.strand(i).front());
      last_.push_back(groom.strand(i).back());
    }
  }

  /// The sphere on which one end of each strand lies. Starts with the spheres through all first, all last, and all
  /// ends; takes the nearer end of each strand.
  [[nodiscard]] Sphere scalp() const {
    Sphere best;
    double least = 1e30;
    std::vector<Eigen::Vector3f> all = first_;
    all.insert(all.end(), last_.begin(), last_.end());
    const std::vector<Eigen::Vector3f>* const begins[] = {&first_, &last_, &all};
    for (const auto* const begin : begins) {
      const Sphere sphere = settled(sphere_of(*begin));
      if (!(sphere.radius > 0)) continue;
      const double off = typical_distance(sphere);
      if (off < 0.98 * least) {
        least = off;
        best = sphere;
      }
    }
    return best;
  }

  [[nodiscard]] std::size_t count() const { return first_.size(); }
  [[nodiscard]] const Eigen::Vector3f& first(std::size_t i) const { return first_[i]; }
  [[nodiscard]] const Eigen::Vector3f& last(std::size_t i) const { return last_[i]; }

 private:
  [[nodiscard]] Sphere settled(Sphere sphere) const {
    std::vector<Eigen::Vector3f> nearer(count());
    for (int round = 0; round < kSphereRounds && sphere.radius > 0; ++round) {
      for (std::size_t i = 0; i < count(); ++i)
        nearer[i] = sphere.off(first_[i]) <= sphere.off(last_[i]) ? first_[i] : last_[i];
      sphere = sphere_of(nearer_to(sphere, nearer));
    }
    return sphere;
  }

  /// Median of the nearer ends', metres: a small sphere is not better for being small.
  [[nodiscard]] double typical_distance(const Sphere& sphere) const {
    std::vector<double> off(count());
    for (std::size_t i = 0; i < off.size(); ++i)
      off[i] = sphere.radius * std::min(sphere.off(first_[i]), sphere.off(last_[i]));
    return quantile(off, 0.5f);
  }

  std::vector<Eigen::Vector3f> first_, last_;
};

}  // namespace

Eigen::AlignedBox3f box_of_roots(const EvenStrands& strands) {
  Eigen::AlignedBox3f roots;
  for (std::size_t i = 0; i < strands.count(); ++i) roots.extend(strands.strand(i).front());
  return roots;
}

double scalp_radius_of(const EvenStrands& strands) {
  if (strands.count() < 4) return 0;
  std::vector<Eigen::Vector3f> roots;
  for (std::size_t i = 0; i < strands.count(); ++i) roots.push_back(strands.strand(i).front());
  Sphere sphere{middle_of(roots), 1};
  for (int round = 0; round < kSphereRounds && sphere.radius > 0; ++round) sphere = sphere_of(nearer_to(sphere, roots));
  if (!(sphere.radius > 0)) return 0;
  const std::span<const Eigen::Vector3f> near = nearer_to(sphere, roots);
  const bool lie_on_it = std::ranges::all_of(near, [&](const Eigen::Vector3f& p) { return sphere.off(p) < kMostOff; });
  return lie_on_it && least_spread(near) > kLeastSpread * sphere.radius ? sphere.radius : 0;
}

EvenStrands even_strands(const groom::Groom& groom, float width, std::span<const std::uint8_t> is_reversed) {
  EvenStrands even;
  even.width = width;
  if (!groom.widths.empty()) {
    even.width = std::accumulate(groom.widths.begin(), groom.widths.end(), 0.0f) / float(groom.widths.size());
  }
  even.points.resize(groom.strand_count() * EvenStrands::kStations);
  even.lengths.resize(groom.strand_count());
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    const bool from_end = !is_reversed.empty() && is_reversed[i] != 0;
    even.lengths[i] = resample(groom.strand(i), from_end,
                               std::span(even.points).subspan(i * EvenStrands::kStations, EvenStrands::kStations));
  }
  return even;
}

std::vector<std::uint8_t> find_reversed_strands(const groom::Groom& groom) {
  std::vector<std::uint8_t> reversed(groom.strand_count(), 0);
  if (groom.root_first || groom.strand_count() == 0) return reversed;
  const StrandEnds ends(groom);
  const Sphere scalp = ends.scalp();
  if (!(scalp.radius > 0)) return reversed;
  // Hair that is tied or lies on the head has both ends near the scalp. Free hair shows the order of the file's
  // strands.
  std::vector<double> begins_nearer(ends.count());  // Differences in radii.
  std::size_t free = 0, free_from_root = 0;
  for (std::size_t i = 0; i < ends.count(); ++i) {
    begins_nearer[i] = scalp.off(ends.last(i)) - scalp.off(ends.first(i));
    if (std::abs(begins_nearer[i]) < kBeyondDoubt) continue;
    ++free;
    free_from_root += begins_nearer[i] > 0 ? 1 : 0;
  }
  const double share = free > 0 ? double(free_from_root) / double(free) : 1;
  const bool is_ordered = share < 0.1 || share > 0.9;  // Otherwise somebody has joined files of both kinds.
  for (std::size_t i = 0; i < reversed.size(); ++i) {
    const bool is_told = !is_ordered || std::abs(begins_nearer[i]) >= kBeyondDoubt;
    reversed[i] = is_told ? begins_nearer[i] < 0 : share < 0.5;
  }
  return reversed;
}

}  // namespace coif::cards
