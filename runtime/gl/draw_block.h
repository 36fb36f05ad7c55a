#pragma once

#include <coif/renderer.h>
#include <coif/shadow.h>

namespace coif {

/// The uniform block of shaders/draw_block.glsl, std140, view space: the world's axes, its origin at the eye.
struct alignas(16) DrawBlock {
  float clip_from_view[16];
  float base_color[4];
  float ambient[4];
  float primary[4];
  float secondary[4];
  float shift[4];
  float component[4];
  float fiber[4];
  float light_position[kMaxLights][4];
  float light_color[kMaxLights][4];
  float light_spot[kMaxLights][4];
  ShadowUniforms shadow;  ///< From view space; map[3]: which light it belongs to.
};
static_assert(sizeof(DrawBlock) == 656);

/// View from head space.
struct HeadMatrix {
  float rows[3][4];
};

/// Finite, thresholds and shares 0..1, exponents above 0, and what the shading model needs.
[[nodiscard]] bool is_valid(const MaterialRecord& material);

/// Takes a draw call's world-space values into view space. kBadArgument, with `block` undefined, for values that are not
/// finite or out of their range. `rows_of_head`: vec4 that an instance has in the matrices' block.
Status fill_draw_block(const DrawDesc& desc, const MaterialRecord& material, std::uint32_t rows_of_head,
                       DrawBlock& block);

[[nodiscard]] bool is_valid(const HeadPose& pose);

/// Of a valid pose. Double on its way, because a head's place in a large world is.
[[nodiscard]] HeadMatrix head_matrix(const HeadPose& pose, const Vec3& eye);

}  // namespace coif
