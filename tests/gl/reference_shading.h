#pragma once

// The shading models on the CPU, written from their papers, in double precision.

#include <coif/asset_records.h>
#include <coif/renderer.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>

namespace coif {

struct ShadedPoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;                    ///< Unit, on the side that is seen.
  Eigen::Vector3d tangent;                   ///< Unit, root to tip.
  std::array<std::uint8_t, 4> base_texel{};  ///< sRGB.
  std::array<std::uint8_t, 2> shift_mask{};
};

/// What one light adds, linear, base colour included.
struct ReflectedLight {
  Eigen::Array3d diffuse = Eigen::Array3d::Zero();
  Eigen::Array3d primary = Eigen::Array3d::Zero();
  Eigen::Array3d secondary = Eigen::Array3d::Zero();

  [[nodiscard]] Eigen::Array3d sum() const { return diffuse + primary + secondary; }
};

/// The reflection of a light of colour 1 from the unit direction `towards`, seen from the unit direction `view`, by the
/// material's model.
[[nodiscard]] ReflectedLight reference_reflection(const ShadedPoint& point, const Eigen::Vector3d& view,
                                                  const Eigen::Vector3d& towards, const MaterialRecord& material);

/// sRGB-encoded red, green, blue, 0..255.
[[nodiscard]] std::array<int, 3> reference_color(const ShadedPoint& point, const Eigen::Vector3d& eye,
                                                 std::span<const Light> lights, const MaterialRecord& material,
                                                 Component component = Component::kAll);

}  // namespace coif
