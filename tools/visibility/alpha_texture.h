#pragma once

#include <coif/asset.h>

#include <Eigen/Core>

#include <vector>

namespace coif {

/// Which mips of a texture fit a triangle's size in the picture: one, and how far to the next smaller one.
struct MipChoice {
  std::size_t level = 0;
  float next = 0;  ///< 0..1.
};

/// The alpha of an asset's base colour as the renderer's sampler reads it, times the material's: repeated, filtered within
/// and between mips. 1 everywhere without a texture.
class AlphaTexture {
 public:
  explicit AlphaTexture(const Asset& asset);

  /// For texture coordinates that change by `dx` from pixel to pixel along a row and by `dy` along a column. The share of
  /// the next mip is linear in size, not in its logarithm: within a twelfth of a mip of what OpenGL asks for, and the same on
  /// every machine.
  [[nodiscard]] MipChoice choose_mip(const Eigen::Vector2f& dx, const Eigen::Vector2f& dy) const;

  [[nodiscard]] float at(const Eigen::Vector2f& uv, const MipChoice& mip) const;

 private:
  struct Level {
    int width = 0;
    int height = 0;
    std::vector<float> alpha;
  };
  [[nodiscard]] static float filtered(const Level& level, const Eigen::Vector2f& uv);

  std::vector<Level> levels_;
  float factor_ = 1;
};

}  // namespace coif
