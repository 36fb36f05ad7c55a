#pragma once

#include "visibility/alpha_texture.h"

#include <coif/asset.h>
#include <coif/math.h>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace coif {

/// What pictures of an asset's finest level of detail have in common, whatever its pose.
struct HairSurface {
  struct Triangle {
    std::uint32_t vertex[3];
    std::uint32_t patch;  ///< Of Asset::lod_patches(0).
  };

  explicit HairSurface(const Asset& asset);  ///< One with a mesh; keeps nothing of it.

  std::vector<Triangle> triangles;   ///< In stored order.
  std::vector<Eigen::Vector2f> uvs;  ///< Per vertex.
  AlphaTexture alpha;
  float faintest = 0;  ///< Alphas below are never drawn.
  bool double_sided = true;
  std::uint32_t patch_count = 0;
  std::vector<ColliderRecord> solids;  ///< The head, as far as colliders tell it: what hides the hair behind it.
};

/// Every vertex in one pose, head space, metres. `palette`: one matrix per bone; empty for the rest pose.
[[nodiscard]] std::vector<Eigen::Vector3f> posed_positions(const Asset& asset, std::span<const Mat34> palette);

}  // namespace coif
