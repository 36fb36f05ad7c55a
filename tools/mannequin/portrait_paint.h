#pragma once

#include <Eigen/Core>

namespace coif::mannequin {

/// Colour of the portrait's skin at a point on it: lips, brows, lash lines, blush. Linear.
[[nodiscard]] Eigen::Vector3d skin_color(const Eigen::Vector3d& point);

/// Where a point of the skin has its colour in skin_image(). Both halves of the face have the same.
[[nodiscard]] Eigen::Vector2d skin_place(const Eigen::Vector3d& point);

/// skin_color() all around the head, and less light in folds. So many texels wide, a third more high.
[[nodiscard]] PaintedImage skin_image(std::uint32_t width);

/// Colour of its left eye: `x` to the outer corner and `y` up, in radii, 0 where it looks to. Linear.
[[nodiscard]] Eigen::Vector3d eye_color(double x, double y);

inline constexpr double kEyeImageReach = 1.15;  ///< Radii from the middle of eye_image() to its borders.
[[nodiscard]] PaintedImage eye_image();

}  // namespace coif::mannequin
