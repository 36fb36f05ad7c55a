#pragma once
// Algorithm 3 of the thesis on the CPU, written from the text, in double precision.

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

/// sRGB-encoded red, green, blue, 0..255.
[[nodiscard]] std::array<int, 3> reference_color(const ShadedPoint& point, const Eigen::Vector3d& eye,
                                                 std::span<const Light> lights, const MaterialRecord& material,
                                                 Component component = Component::kAll);

}  // namespace coif
