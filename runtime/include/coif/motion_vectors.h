#pragma once
// How far each pixel of hair has moved in the picture since the last frame: what temporal anti-aliasing and motion
// blur ask for. Hair without it leaves ghosts. A pass of its own, which a program links only where it is called.

#include <coif/drawing.h>
#include <coif/export.h>
#include <coif/renderer.h>
#include <coif/status.h>

#include <span>

namespace coif {

/// From where a crowd is seen in this frame, and was in the last.
struct MotionDesc {
  /// As in DrawDesc, and the same values that colour is drawn with: what is covered and how deep it is agree then
  /// to the bit.
  float clip_from_world[16] = {};
  Vec3 eye;
  /// The last frame's. A jitter of the camera stays out of the vectors where both matrices have this frame's.
  float previous_clip_from_world[16] = {};
  Vec3 previous_eye;
  float alpha = 0.5f;                        ///< Texels from this alpha on have a vector, 0..1.
  const MaterialRecord* material = nullptr;  ///< As in DrawDesc.
};

/// Writes vectors and depth of the hair into the framebuffer that is bound. Its first colour attachment holds two
/// signed channels: GL_RG16F, which OpenGL ES 3.0 draws to with GL_EXT_color_buffer_half_float or _float, or more.
/// The value is the way from where the point was to where it is, in parts of the viewport, (0.5, 0.5) half of it
/// to the right and up: this frame's texture coordinate less the last one's. (2, 2) for what was behind the eye.
/// Pixels without hair keep what the host has put there.
///
/// `instances` and `previous` are the same heads in the same order; `lod` is this frame's. The last frame's
/// matrices are the host's to keep, see coif/last_frame.h. A head that is new or was put somewhere else has no
/// past: give this frame's.
///
/// Depth test with GL_LEQUAL and depth writes as in HairRenderer::draw(), after or before it. Blending is off. Two
/// matrices a bone are sent: an asset whose two frames do not fit into a uniform block is drawn head by head, and
/// its first vectors make one texture. Errors and OpenGL state as HairRenderer::draw(); also kSizeMismatch unless
/// both lists are equally long, kBadArgument for an `alpha` out of range or an asset whose matrices the stream has
/// no room for.
COIF_API Status draw_motion_vectors(HairRenderer& renderer, const HairModel& model,
                                    std::span<const HairInstance> instances, std::span<const HairInstance> previous,
                                    const MotionDesc& desc);

/// Builds what the first draw_motion_vectors() of this model would have to build. Looks at `alpha` and `material`
/// alone.
COIF_API Status prepare_motion_vectors(HairRenderer& renderer, const HairModel& model, const MotionDesc& desc = {});

}  // namespace coif
