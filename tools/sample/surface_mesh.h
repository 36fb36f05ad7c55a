#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace coif::sample {

/// A joint in the rest pose. Joints have no rotation: their axes are the model's.
struct Joint {
  std::string name;
  int parent = -1;           ///< An earlier joint; -1 for the root.
  Eigen::Vector3d position;  ///< Model space, metres.
};

// A triangle mesh on its way into the sample's file.

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

/// Weights of up to four joints, of which any may have none and one may come twice, rounded to 1/256 such that they add
/// up to exactly one. No joint comes twice in the result; of those that were given once the largest come first.
[[nodiscard]] SkinInfluences rounded_influences(std::array<std::pair<int, double>, 4> shares);

}  // namespace coif::sample
