#pragma once

#include "gl/transparency/exact_memory.h"

namespace coif {

/// Find, in each pixel, the furthest soft texel that is not yet drawn: first its depth, then which one it is.
extern const FragmentCode kPeelDepthCode;
extern const FragmentCode kPeelKeyCode;
/// Draws the one that was found.
extern const FragmentCode kPeeledCode;

/// Makes what is missing for this area. False where the driver refuses, with the reason in draw.failure. Leaves the host's
/// framebuffer bound.
[[nodiscard]] bool make_peel_targets(const ModeDraw& draw, const PixelArea& area, ExactMemory& memory);

struct PeelPasses {
  PassList find_depth;
  PassList find_key;
  PassList draw_found;
};

/// Draws the crowd's soft texels layer by layer, from the furthest on, over what is in the framebuffer. Waits for the GPU
/// after each. False where the driver refuses. Restores the host's framebuffer and polygon offset; leaves the depth
/// function as it likes, and no texture bound.
[[nodiscard]] bool draw_peeled(const ModeDraw& draw, const PeelPasses& passes, ExactMemory& memory);

}  // namespace coif
