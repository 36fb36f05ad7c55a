#pragma once

#include "cards/card_surface.h"
#include "cards/strand_picture.h"
#include "platform/stop.h"

namespace coif::cards {

/// Cards from one direction, as strand_picture.h has strands. Each of 16 samples of a pixel is covered by as much as
/// all cards there cover together; the nearest ones' shade covers that of what is behind; depth is that of the nearest
/// place that hides half.
[[nodiscard]] HairPicture draw_cards(const CardSurface& surface, const PictureFrame& frame,
                                     const platform::Threads& threads);

}  // namespace coif::cards
