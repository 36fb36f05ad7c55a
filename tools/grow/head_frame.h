#pragma once

#include "cook/recipe/hair_style.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>

namespace coif::grow {

inline constexpr float kRadians = std::numbers::pi_v<float> / 180;
inline constexpr float kUsualRadius = 0.0885f;  ///< Metres, of a head.

/// The skull as an ellipsoid, face towards +Z, by which places on any head are described.
struct HeadFrame {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  Eigen::Vector3f radii = Eigen::Vector3f::Ones();

  /// The direction of a place from the middle of a round head; unit.
  [[nodiscard]] Eigen::Vector3f direction(const Eigen::Vector3f& point) const {
    return (point - center).cwiseQuotient(radii).normalized();
  }
  [[nodiscard]] float mean_radius() const { return radii.mean(); }
  /// Factor for the lengths of a style, which are for a head of usual size.
  [[nodiscard]] float scale() const { return mean_radius() / kUsualRadius; }
};

/// Unit; degrees as in HairStyle.
[[nodiscard]] inline Eigen::Vector3f direction_at(float azimuth, float elevation) {
  const float a = azimuth * kRadians, e = elevation * kRadians;
  return {std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}
[[nodiscard]] inline float azimuth_of(const Eigen::Vector3f& direction) {
  return std::atan2(direction.x(), direction.z()) / kRadians;
}
[[nodiscard]] inline float elevation_of(const Eigen::Vector3f& direction) {
  return std::asin(std::clamp(direction.y(), -1.0f, 1.0f)) / kRadians;
}

/// The head at the top of a body: from the top down to where it is widest. None where nothing there has a head's
/// proportions.
[[nodiscard]] std::optional<HeadFrame> find_head(std::span<const Eigen::Vector3f> positions,
                                                 std::span<const std::uint32_t> triangles);

}  // namespace coif::grow
