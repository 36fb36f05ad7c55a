#pragma once

#include "gl/transparency/exact_memory.h"

namespace coif {

/// Of soft texels, which it stores with their depths instead of drawing them.
extern const FragmentCode kListCode;

/// Whether the driver can do it at all. With OpenGL ES 3.0 alone it cannot.
[[nodiscard]] bool has_lists(const ModeDraw& draw, const ExactMemory& memory);

/// Makes what is missing for this area. False where the driver refuses, with the reason in draw.failure.
[[nodiscard]] bool make_lists(const ModeDraw& draw, const PixelArea& area, ListMemory& lists);

enum class Listed : std::uint8_t { kDrawn, kOverflow, kDriver };

/// Draws the crowd's soft texels through lists, over what is in the framebuffer. Draws nothing after an overflow. Waits
/// for the GPU. Leaves depth test and colour mask as it likes, and no storage buffer bound.
[[nodiscard]] Listed draw_lists(const ModeDraw& draw, const PassList& listed, const PixelArea& area,
                                ExactMemory& memory);

}  // namespace coif
