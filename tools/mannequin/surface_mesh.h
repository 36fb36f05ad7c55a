#pragma once
// A triangle mesh on its way into a file or a picture, and an image on it.

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace coif::mannequin {

/// Up to four joints of one vertex. Unused places have weight zero; the weights add up to one.
struct SkinInfluences {
  std::array<std::uint16_t, 4> joints{};
  std::array<double, 4> weights{};
};

/// Arrays per vertex are either empty or as long as `positions`.
struct SurfaceMesh {
  std::vector<Eigen::Vector3d> positions;  ///< Model space, metres, Y up, face towards +Z.
  std::vector<Eigen::Vector3d> normals;    ///< Unit, outwards.
  std::vector<Eigen::Vector2d> uvs;        ///< V grows downwards in the image.
  std::vector<SkinInfluences> skin;
  std::vector<std::uint32_t> triangles;  ///< Three indices each, counter-clockwise seen from outside.
};

/// RGBA, sRGB, straight alpha, rows top to bottom.
struct PaintedImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace coif::mannequin
