#pragma once

#include <coif/renderer.h>

namespace coif {

/// The uniform block of shaders/draw_block.glsl, std140, head space.
struct alignas(16) DrawBlock {
  float clip_from_head[16];
  float eye[4];
  float base_color[4];
  float ambient[4];
  float primary[4];
  float secondary[4];
  float shift[4];
  float component[4];
  float light_position[kMaxLights][4];
  float light_color[kMaxLights][4];
};
static_assert(sizeof(DrawBlock) == 432);

/// Finite, thresholds 0..1, exponents above 0.
[[nodiscard]] bool is_valid(const MaterialRecord& material);

/// Takes a draw call's world-space values into head space. kBadPose or kBadArgument, with `block` undefined, for values
/// that are not finite or out of their range.
Status fill_draw_block(const DrawDesc& desc, const MaterialRecord& material, DrawBlock& block);

}  // namespace coif
