#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace coif::cards {

/// Looks along a direction without perspective at a ball, so that pictures of one size from all around show one scale.
struct PictureFrame {
  Eigen::Matrix3f axes;    ///< Rows: right, down, away from the eye. Unit.
  Eigen::Vector3f center;  ///< The picture's middle, at depth 0.
  float pixels_of_metre = 1;
  std::uint32_t size = 0;  ///< Pixels, both ways.

  /// x and y in pixels, (0, 0) at the upper left corner; depth in metres, growing away from the eye.
  [[nodiscard]] Eigen::Vector3f place(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f seen = axes * (point - center);
    const float middle = 0.5f * float(size);
    return {middle + pixels_of_metre * seen.x(), middle + pixels_of_metre * seen.y(), seen.z()};
  }
};

/// The ball around points that all frames show.
struct ShownBall {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius = 1;  ///< Metres, > 0.
};

[[nodiscard]] inline ShownBall ball_around(std::span<const Eigen::Vector3f> points) {
  if (points.empty()) return {};
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& point : points) box.extend(point);
  ShownBall ball{box.center(), 0};
  for (const Eigen::Vector3f& point : points) ball.radius = std::max(ball.radius, (point - ball.center).norm());
  if (!(ball.radius > 0)) ball.radius = 1;
  return ball;
}

/// Looks in the direction `towards`: (0, 0, -1) looks along -Z, from the front of a model that faces +Z.
[[nodiscard]] inline PictureFrame frame_along(const Eigen::Vector3f& towards, const ShownBall& ball,
                                              std::uint32_t size) {
  const Eigen::Vector3f away = towards.normalized();
  const Eigen::Vector3f up = std::abs(away.y()) < 0.99f ? Eigen::Vector3f::UnitY() : Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f right = away.cross(up).normalized();
  PictureFrame frame;
  frame.axes << right.transpose(), away.cross(right).transpose(), away.transpose();
  frame.center = ball.center;
  frame.pixels_of_metre = 0.49f * float(size) / ball.radius;
  frame.size = size;
  return frame;
}

/// `count` directions spread evenly over the sphere: a spiral (Swinbank and Purser 2006, "Fibonacci grids").
[[nodiscard]] inline std::vector<Eigen::Vector3f> spread_directions(std::size_t count) {
  std::vector<Eigen::Vector3f> directions(count);
  for (std::size_t i = 0; i < count; ++i) {
    const float y = 1 - 2 * (float(i) + 0.5f) / float(count);
    const float around = float(i) * std::numbers::pi_v<float> * (3 - std::sqrt(5.0f));
    const float r = std::sqrt(1 - y * y);
    directions[i] = {r * std::cos(around), y, r * std::sin(around)};
  }
  return directions;
}

}  // namespace coif::cards
