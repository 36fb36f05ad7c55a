#pragma once

#include <coif/asset.h>
#include <coif/asset_records.h>
#include <coif/math.h>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::visibility {

/// The mip of a texture that fits a triangle's size in the picture, and how far to blend to the next smaller one.
struct MipChoice {
  std::uint32_t level = 0;
  float next = 0;  ///< 0..1.
};

/// The alpha of an asset's base colour as the renderer's sampler reads it, times the material's: repeated, filtered
/// within and between mips. 1 everywhere without a texture.
class AlphaTexture {
 public:
  explicit AlphaTexture(const Asset& asset);

  /// For texture coordinates that change by `dx` from pixel to pixel along a row and by `dy` along a column. The share
  /// of the next mip is linear in size, not in its logarithm: within a twelfth of a mip of OpenGL's rule, and the same
  /// on every machine.
  [[nodiscard]] MipChoice choose_mip(const Eigen::Vector2f& dx, const Eigen::Vector2f& dy) const;

  [[nodiscard]] float at(const Eigen::Vector2f& uv, const MipChoice& mip) const;

  /// Gives a mip the alpha of these RGBA texels, which must have its size.
  void set_texels(std::size_t mip, std::span<const std::uint8_t> rgba);

 private:
  /// Rows and columns have one more texel at each end, equal to that at the other end, as texels repeat.
  class Level {
   public:
    Level(std::uint32_t width, std::uint32_t height);
    void set_texels(std::span<const std::uint8_t> rgba);

    [[nodiscard]] Eigen::Vector2f size() const { return {width_, height_}; }
    /// Filtered, at texture coordinates within 0..1.
    [[nodiscard]] float at(float u, float v) const;

   private:
    float width_, height_;
    std::size_t stride_;
    std::vector<std::uint8_t> alpha_;  ///< As stored: a quarter of the memory traffic.
  };
  std::vector<Level> levels_;
  float factor_ = 1;
};

/// Where a line first meets one of the solids: the smallest depth_along().
[[nodiscard]] float solid_depth(std::span<const ColliderRecord> solids, const Eigen::Vector3f& origin,
                                const Eigen::Vector3f& along);

/// The same along one direction from many places.
class SolidsAlong {
 public:
  SolidsAlong(std::span<const ColliderRecord> solids, const Eigen::Vector3f& along);

  [[nodiscard]] float depth(const Eigen::Vector3f& origin) const;

 private:
  /// A sphere or an ellipsoid, made the unit ball.
  struct Ball {
    Eigen::Matrix3f to_unit;
    Eigen::Vector3f center, along;
    float square;  ///< Square of the length of `along`.
  };
  std::vector<Ball> balls_;
  std::vector<ColliderRecord> others_;
  Eigen::Vector3f along_;
};

/// The data that pictures of a level of detail share, in any pose.
struct HairSurface {
  struct Triangle {
    std::uint32_t vertex[3];
    std::uint32_t patch;  ///< Index into Asset::lod_patches(lod).
  };

  /// The asset must have a mesh; keeps nothing of it.
  explicit HairSurface(const Asset& asset, std::uint32_t lod = 0);

  std::vector<Triangle> triangles;      ///< In stored order.
  std::vector<std::uint32_t> vertices;  ///< Vertices of triangles, ascending.
  std::vector<Eigen::Vector2f> uvs;     ///< Per vertex.
  AlphaTexture alpha;
  float faintest = 0;  ///< Alphas below are never drawn.
  bool double_sided = true;
  std::uint32_t patch_count = 0;
  std::vector<ColliderRecord> solids;  ///< The head's colliders, which hide the hair behind them.
};

/// Every vertex in one pose, head space, metres. `palette`: one matrix per bone; empty for the rest pose.
[[nodiscard]] std::vector<Eigen::Vector3f> posed_positions(const Asset& asset, std::span<const Mat34> palette);

}  // namespace coif::visibility
