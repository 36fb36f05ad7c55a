#pragma once

#include "cook/hair_mesh.h"
#include "cook/image.h"

namespace coif {

/// Which texels of an image the hair shows: one channel, 255 where a triangle touches the texel, else 0. Coordinates
/// outside 0..1 wrap. An atlas may hold a face too; what is measured of a hair texture is measured over these.
[[nodiscard]] Image used_texels(const HairMesh& hair, std::uint32_t width, std::uint32_t height);

}  // namespace coif
