#pragma once

#include "mannequin/head_shape.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coif::mannequin {

/// Colour of the portrait's skin at a point on it: lips, brows, lash lines, blush. Linear.
[[nodiscard]] Eigen::Vector3d skin_color(const Eigen::Vector3d& point);

/// The place of a skin point's colour in skin_image(). Both halves of the face share it.
[[nodiscard]] Eigen::Vector2d skin_place(const Eigen::Vector3d& point);

/// skin_color() all around the head, darker in folds. This many texels wide, a third more high.
[[nodiscard]] PaintedImage skin_image(std::uint32_t width);

/// Colour of its left eye: `x` to the outer corner and `y` up, in radii, 0 where it looks to. Linear.
[[nodiscard]] Eigen::Vector3d eye_color(double x, double y);

inline constexpr double kEyeImageReach = 1.15;  ///< Radii from the middle of eye_image() to its borders.
[[nodiscard]] PaintedImage eye_image();

/// The resolution of the portrait.
struct PortraitDetail {
  double spacing = 1;          ///< Factor on the sample's spacing of vertices.
  std::uint32_t texels = 768;  ///< Width of the skin's image.
  bool has_shoulders = true;   ///< Without them head and neck alone, for hair that would hang into them.
};

struct PortraitMaterial {
  double red = 1, green = 1, blue = 1;  ///< Linear base colour.
  double roughness = 0.6;
};

/// A part with one material.
struct PortraitPart {
  std::string name;
  SurfaceMesh mesh;  ///< Without weights; portrait_head.h has its measures.
  PortraitMaterial material;
  std::optional<PaintedImage> image;  ///< The material's image.
};

/// A head with a face to show hair on: skin, eyes, lashes, and a shirt where there are shoulders.
[[nodiscard]] std::vector<PortraitPart> make_portrait_parts(const PortraitDetail& detail = {});

}  // namespace coif::mannequin
