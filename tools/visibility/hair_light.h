#pragma once

#include "base/studio.h"
#include "visibility/hair_surface.h"

#include <coif/asset.h>
#include <coif/asset_records.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace coif::visibility {

/// sRGB encoding: `linear` 0..1, by channel, within 0.0002.
[[nodiscard]] Eigen::Array3f encode_srgb(const Eigen::Array3f& linear);

/// Linear colour of texels, largest mip first; filtered within a mip.
class ColorTexture {
 public:
  explicit ColorTexture(const Asset& asset);
  /// The colour in the nearer mip, times the material's colour.
  [[nodiscard]] Eigen::Array3f at(const Eigen::Vector2f& uv, const MipChoice& mip) const;

 private:
  struct Level {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< sRGB.
  };
  std::vector<Level> levels_;
  Eigen::Array3f factor_{1, 1, 1};
};

/// Axes of a view, unit, head space.
struct ViewAxes {
  Eigen::Vector3f right, up, back;
};

/// A light of the studio (base/studio.h) in a view, with which it moves.
struct ViewLight {
  Eigen::Vector3f towards;  ///< Unit, head space.
  Eigen::Vector3f half;     ///< Unit, between that and the eye.
  Eigen::Array3f color;
};
using ViewLights = std::array<ViewLight, kStudioLights.size()>;
[[nodiscard]] ViewLights lights_in(const ViewAxes& view);

/// Hair and head in the light of the tools' pictures (base/studio.h): the colours of a pixel's layers, to judge how
/// much their order matters. Wrapped diffuse light, both highlights of the thesis, and the ambient term, as in
/// shaders/shading.glsl for kThesis; other models' highlights are left out. Light is that at rest, and highlights are
/// where they would be without the texture that shifts them.
class HairLight {
 public:
  explicit HairLight(const Asset& asset);  ///< The asset must have a mesh; keeps nothing of it.

  /// Linear, of a point of a triangle with these corners at these shares, seen from the side of its front or back.
  [[nodiscard]] Eigen::Array3f of_hair(const std::uint32_t (&corners)[3], const Eigen::Vector3f& share, bool is_front,
                                       const Eigen::Array3f& base, const ViewLights& lights) const;

  [[nodiscard]] const ColorTexture& texture() const { return texture_; }

 private:
  struct Vertex {
    Eigen::Vector3f normal, tangent;
    float openness = 1;
  };
  ColorTexture texture_;
  MaterialRecord material_{};
  std::vector<Vertex> vertices_;
};

/// Linear colour of the head at a line of sight: a mannequin's clay.
[[nodiscard]] Eigen::Array3f light_on_head(const Eigen::Vector3f& normal, const ViewLights& lights);

/// Linear, behind all; `height`: 0 at the picture's bottom, 1 at its top.
[[nodiscard]] Eigen::Array3f backdrop(float height);

}  // namespace coif::visibility
