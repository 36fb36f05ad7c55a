#pragma once

#include "animation/glb_file.h"

#include <coif/asset.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// Adds the finest level of the asset's mesh with its skin attributes and one material, as mesh 0. The asset must have vertices.
/// `base_color_png`: embedded as the base colour texture; empty: none.
void add_hair_mesh(GlbFile& file, const Asset& asset, std::span<const std::uint8_t> base_color_png);

}  // namespace coif
