#pragma once
// How far each pixel of hair has moved in the picture since the last frame, for temporal anti-aliasing and motion blur;
// without these vectors hair leaves ghosts. A separate pass, which a program links only where it calls it.

#include <coif/drawing.h>
#include <coif/export.h>
#include <coif/renderer.h>
#include <coif/status.h>

#include <span>

namespace coif {

/// The view of this frame and of the last one.
struct MotionDesc {
  /// As in DrawDesc, with the same values as for colour: coverage and depth then agree to the bit.
  float clip_from_world[16] = {};
  Vec3 eye;
  /// The last frame's view. Use this frame's jitter of the camera in both matrices to keep it out of the vectors.
  float previous_clip_from_world[16] = {};
  Vec3 previous_eye;
  float alpha = 0.5f;                        ///< Texels from this alpha on get a vector, 0..1.
  const MaterialRecord* material = nullptr;  ///< As in DrawDesc.
};

/// Writes motion vectors and depth of the hair into the bound framebuffer. Its first colour attachment has two signed
/// channels or more: GL_RG16F, which OpenGL ES 3.0 draws to with GL_EXT_color_buffer_half_float or _float. A vector is
/// the way of a point from the last frame to this one, in parts of the viewport: (0.5, 0.5) is half of it to the right
/// and up. It is this frame's texture coordinate minus the last one's; (2, 2) for a point that was behind the eye.
/// Pixels without hair keep their value.
///
/// `instances` and `previous` are the same heads in the same order; `lod` is taken from `instances`. The host keeps the
/// last frame's matrices, see coif/last_frame.h. For a head that is new or was put elsewhere, give this frame's
/// matrices as the previous ones.
///
/// Depth test with GL_LEQUAL and depth writes as in HairRenderer::draw(), after or before it. Blending is off. Two
/// matrices per bone are sent. If an asset's two frames do not fit into a uniform block, it is drawn head by head, and
/// its first vectors create one texture. Errors and OpenGL state as HairRenderer::draw(); also kSizeMismatch unless
/// both lists are equally long, kBadArgument for an `alpha` out of range or an asset whose matrices do not fit into the
/// stream.
COIF_API Status draw_motion_vectors(HairRenderer& renderer, const HairModel& model,
                                    std::span<const HairInstance> instances, std::span<const HairInstance> previous,
                                    const MotionDesc& desc);

/// Builds the programs that the first draw_motion_vectors() of this model would build. Reads only `alpha` and
/// `material`.
COIF_API Status prepare_motion_vectors(HairRenderer& renderer, const HairModel& model, const MotionDesc& desc = {});

}  // namespace coif
