#include "grow/body_field.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <cmath>

namespace coif::grow {
namespace {

using Eigen::Vector3f;

constexpr float kMostSamples = 3e6f;

}  // namespace

BodyField::BodyField(const BodySurface& surface, const Eigen::AlignedBox3f& box, float spacing,
                     const platform::Threads& threads)
    : low_(box.min()), spacing_(std::max(spacing, std::cbrt(box.volume() / kMostSamples))) {
  for (std::size_t k = 0; k < 3; ++k) size_[k] = int(std::ceil(box.sizes()[int(k)] / spacing_)) + 2;
  samples_.resize(std::size_t(size_[0]) * std::size_t(size_[1]) * std::size_t(size_[2]));
  const auto rows = std::size_t(size_[1]) * std::size_t(size_[2]);
  parallel_for(rows, threads, [&](std::size_t row) {
    Vector3f at = low_ + spacing_ * Vector3f(0, float(row % std::size_t(size_[1])), float(row / std::size_t(size_[1])));
    BodySurface::Nearest before;
    bool inside = false;
    for (std::size_t x = 0; x < std::size_t(size_[0]); ++x, at.x() += spacing_) {
      const BodySurface::Nearest here = surface.nearest(at, before.triangle);
      // If the surface runs between two samples, the sum of their distances from it is at most their distance from each
      // other.
      if (x == 0 || here.distance + before.distance <= 1.01f * spacing_) inside = surface.is_inside(at);
      samples_[row * std::size_t(size_[0]) + x] = inside ? -here.distance : here.distance;
      before = here;
    }
  });
}

float BodyField::distance(const Vector3f& point) const {
  const Vector3f wanted = (point - low_) / spacing_;
  Vector3f place;
  std::array<int, 3> c{};
  for (int k = 0; k < 3; ++k) {
    place[k] = std::clamp(wanted[k], 0.0f, float(size_[std::size_t(k)] - 1) - 1e-3f);
    c[std::size_t(k)] = int(place[k]);
    place[k] -= float(c[std::size_t(k)]);
  }
  const auto along_x = [&](int y, int z) {
    return (1 - place.x()) * sample(c[0], c[1] + y, c[2] + z) + place.x() * sample(c[0] + 1, c[1] + y, c[2] + z);
  };
  const auto along_y = [&](int z) { return (1 - place.y()) * along_x(0, z) + place.y() * along_x(1, z); };
  const float inside_box = (1 - place.z()) * along_y(0) + place.z() * along_y(1);
  float outside = 0;
  for (int k = 0; k < 3; ++k) {
    const float off = wanted[k] - std::clamp(wanted[k], 0.0f, float(size_[std::size_t(k)] - 1));
    outside += off * off;
  }
  return inside_box + spacing_ * std::sqrt(outside);
}

Vector3f BodyField::normal(const Vector3f& point) const {
  Vector3f gradient;
  for (int k = 0; k < 3; ++k) {
    const Vector3f step = 0.5f * spacing_ * Vector3f::Unit(k);
    gradient[k] = distance(point + step) - distance(point - step);
  }
  const float length = gradient.norm();
  return length > 0 ? Vector3f(gradient / length) : Vector3f::UnitY();
}

Vector3f BodyField::kept_off(const Vector3f& point, float clearance) const {
  constexpr int kTries = 8;
  Vector3f kept = point;
  for (int i = 0; i < kTries; ++i) {
    const float short_of = clearance - distance(kept);
    if (!(short_of > 0)) break;
    kept += 1.02f * short_of * normal(kept);
  }
  return kept;
}

}  // namespace coif::grow
