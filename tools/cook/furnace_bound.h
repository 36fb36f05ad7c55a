#pragma once

#include <coif/asset_records.h>

namespace coif {

/// The most that a shading model returns of light that comes from everywhere alike ("white furnace"), where a white matte
/// surface returns 1: an upper bound over all directions of view, of a white base texture with a full mask, in the
/// channel that returns most, without the ambient term and before `light_cut`. Derived in shaders/SHADING.md.
[[nodiscard]] double furnace_bound(const MaterialRecord& material);

/// The cut with which the material returns no more than it gets; 0 where it does not anyway.
[[nodiscard]] float bounding_cut(const MaterialRecord& material);

}  // namespace coif
