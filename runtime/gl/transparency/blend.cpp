#include "gl/passes.h"

namespace coif {
namespace {

Pass faces_pass(GLenum culled, const MaterialRecord& material) {
  Pass pass = soft_pass(material);
  pass.culled = culled;
  return pass;
}

/// Texels from the opaque threshold on count as solid; fainter ones blend. Below the discard threshold nothing is
/// drawn, which spares the blend unit the empty parts of the texture. Back faces come first, since over most of a head
/// they are the far side, except for assets that look better with both faces in one order. One-sided hair has no back
/// faces to draw.
PassList plan(const MaterialRecord& material, const AlphaRange& texture) {
  const AlphaRange alpha = drawn_alpha(material, texture);
  const bool both_faces = (material.flags & kMaterialDoubleSided) != 0;
  const bool together = both_faces && (material.flags & kMaterialFacesTogether) != 0;
  PassList drawn;
  drawn.add_for(alpha, solid_pass(material));
  if (both_faces && !together) drawn.add_for(alpha, faces_pass(GL_FRONT, material));
  drawn.add_for(alpha, faces_pass(together ? GL_NONE : GL_BACK, material));
  drawn.add_for(alpha, soft_depth_pass(material));
  return drawn;
}

}  // namespace

const TransparencyMode kBlendMode = {"blend", plan};

}  // namespace coif
