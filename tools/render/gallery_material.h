#pragma once

#include <coif/asset.h>

#include <Eigen/Core>

namespace coif {

/// The asset's own, or where it has none that of the thesis's first gallery; shaded by the thesis's model, whatever its own is.
[[nodiscard]] MaterialRecord thesis_material(const Asset& asset);

/// Mean of the base texture, linear, each texel counted by its alpha; white without a texture.
[[nodiscard]] Eigen::Vector3d mean_base_color(const Asset& asset);

/// That material, dyed: hair whose texture is on average of `color` (linear).
[[nodiscard]] MaterialRecord dyed_material(const Asset& asset, const Eigen::Vector3d& color);

}  // namespace coif
