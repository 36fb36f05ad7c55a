#pragma once

#include "cards/card_strip.h"
#include "cards/card_texture.h"
#include "cards/strand_picture.h"

#include <span>

namespace coif {

/// Cards from one direction, as strand_picture.h has strands. Each of 16 samples of a pixel is covered by as much as all cards there
/// cover together, whatever their order; depth is that of the nearest that covers half. Strips beside textures, one for each.
[[nodiscard]] HairPicture draw_cards(std::span<const Wisp> wisps, std::span<const CardStrip> strips,
                                     std::span<const CardTexture> textures, const PictureFrame& frame,
                                     unsigned threads);

}  // namespace coif
