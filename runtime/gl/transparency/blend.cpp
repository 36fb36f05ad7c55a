#include "gl/transparency_mode.h"

namespace coif {
namespace {

// Of everything that is hidden by hair and drawn later, a texel of alpha a should show 1 - a. Writing depth shows 0 of
// it, not writing shows 1, so half is where one error becomes smaller than the other. Lower, the faint borders of cards
// would punch holes into smoke or glass behind them; higher, it would shine through hair that is nearly solid.
constexpr float kDepthAlpha = 0.5f;

Pass blended_pass(GLenum culled, const MaterialRecord& material) {
  return {.shaded = true,
          .blended = true,
          .writes_depth = false,
          .culled = culled,
          .alpha_min = material.discard_threshold,
          .alpha_max = material.opaque_threshold,
          .solid_from = kNoAlphaLimit};
}

Pass depth_pass(const MaterialRecord& material) {
  const float faintest = material.discard_threshold;
  return {.shaded = false,
          .blended = false,
          .writes_depth = true,
          .culled = unseen_faces(material),
          .alpha_min = faintest > kDepthAlpha ? faintest : kDepthAlpha,
          .alpha_max = material.opaque_threshold};
}

/// Texels from the opaque threshold on count as solid; what is fainter blends; below the discard threshold nothing is
/// drawn, which spares the blend unit the empty parts of the texture. Back faces come first, since over most of a head
/// they are the far side, but for assets that were found to look better with both faces in one order. One-sided hair has
/// no back faces to draw.
PassList plan(const MaterialRecord& material, const AlphaRange& texture) {
  const AlphaRange alpha = drawn_alpha(material, texture);
  const bool both_faces = (material.flags & kMaterialDoubleSided) != 0;
  const bool together = both_faces && (material.flags & kMaterialFacesTogether) != 0;
  PassList drawn;
  drawn.add_for(alpha, solid_pass(material));
  if (both_faces && !together) drawn.add_for(alpha, blended_pass(GL_FRONT, material));
  drawn.add_for(alpha, blended_pass(together ? GL_NONE : GL_BACK, material));
  drawn.add_for(alpha, depth_pass(material));
  return drawn;
}

}  // namespace

const TransparencyMode kBlendMode = {"blend", plan};

}  // namespace coif
