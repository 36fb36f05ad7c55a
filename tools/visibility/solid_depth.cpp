#include "visibility/solid_depth.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif {
namespace {

constexpr float kMiss = std::numeric_limits<float>::infinity();
constexpr int kBalls = 16;

/// The unit ball around the origin; `along` of any length but 0.
float unit_ball_depth(const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  const float a = along.squaredNorm(), b = origin.dot(along), c = origin.squaredNorm() - 1;
  const float root = b * b - a * c;
  return root < 0 ? kMiss : (-b - std::sqrt(root)) / a;
}

float ellipsoid_depth(const ColliderRecord& solid, const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  const Eigen::Map<const Eigen::Vector3f> center(solid.center), radii(solid.radii);
  const Eigen::Quaternionf to_head(solid.rotation[3], solid.rotation[0], solid.rotation[1], solid.rotation[2]);
  const auto in_axes = [&](const Eigen::Vector3f& v) -> Eigen::Vector3f {
    return (to_head.conjugate() * v).cwiseQuotient(radii);
  };
  return unit_ball_depth(in_axes(origin - center), in_axes(along));
}

float capsule_depth(const ColliderRecord& solid, const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  const Eigen::Map<const Eigen::Vector3f> center(solid.center), axis(solid.axis);
  const float first = solid.radii[0];
  const float last = solid.shape == ColliderShape::kTaperedCapsule ? solid.radii[1] : first;
  float nearest = kMiss;
  for (int i = 0; i <= kBalls; ++i) {
    const float share = float(i) / kBalls, radius = first + share * (last - first);
    const Eigen::Vector3f from = (origin - center - share * axis) / radius;
    nearest = std::min(nearest, unit_ball_depth(from, along / radius));
  }
  return nearest;
}

}  // namespace

float solid_depth(std::span<const ColliderRecord> solids, const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  float nearest = kMiss;
  for (const ColliderRecord& solid : solids) {
    const bool has_axis = solid.shape == ColliderShape::kCapsule || solid.shape == ColliderShape::kTaperedCapsule;
    const float depth = has_axis ? capsule_depth(solid, origin, along) : ellipsoid_depth(solid, origin, along);
    nearest = std::min(nearest, depth);
  }
  return nearest;
}

}  // namespace coif
