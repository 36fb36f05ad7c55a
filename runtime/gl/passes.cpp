#include "gl/passes.h"

#include <hair_shaders.h>

namespace coif {
namespace {

// Things that are hidden by hair and drawn later should show 1 - a through a texel of alpha a. With depth written they
// show 0 of it, without they show 1, so at a half one error becomes smaller than the other. With a lower value the
// faint borders of cards would punch holes into smoke or glass behind them; with a higher one these would shine through
// hair that is nearly solid.
constexpr float kDepthAlpha = 0.5f;

void set_enabled(const GlFunctions& gl, GLenum capability, bool enabled) {
  enabled ? gl.Enable(capability) : gl.Disable(capability);
}

}  // namespace

const FragmentCode kRangeCode = {0, kShaderKeepRangeGlsl, kShaderHairOutputGlsl};

const char* name_of(const TransparencyMode& transparency) { return transparency.name; }

void PassList::add_for(const AlphaRange& alpha, Pass pass) {
  const bool is_empty =
      pass.alpha_min >= pass.alpha_max || alpha.highest < pass.alpha_min || alpha.lowest >= pass.alpha_max;
  if (is_empty) return;
  const bool is_thinned = pass.code->thins && alpha.lowest < pass.solid_from;
  pass.tests_alpha = is_thinned || alpha.lowest < pass.alpha_min || alpha.highest >= pass.alpha_max;
  add(pass);
}

void PassList::add_shadow(const ShadowLookup& shadow) {
  for (Pass& pass : passes_) {
    if (pass.shaded) pass.shadow = &shadow;
  }
}

AlphaRange drawn_alpha(const MaterialRecord& material, const AlphaRange& texture) {
  const float a = texture.lowest * material.base_color[3], b = texture.highest * material.base_color[3];
  return a < b ? AlphaRange{a, b} : AlphaRange{b, a};
}

GLenum unseen_faces(const MaterialRecord& material) {
  return (material.flags & kMaterialDoubleSided) != 0 ? GL_NONE : GL_BACK;
}

Pass solid_pass(const MaterialRecord& material) {
  return {.shaded = true,
          .blended = false,
          .writes_depth = true,
          .culled = unseen_faces(material),
          .alpha_min = material.opaque_threshold,
          .alpha_max = kNoAlphaLimit};
}

Pass soft_pass(const MaterialRecord& material) {
  return {.shaded = true,
          .blended = true,
          .writes_depth = false,
          .culled = unseen_faces(material),
          .alpha_min = material.discard_threshold,
          .alpha_max = material.opaque_threshold,
          .solid_from = kNoAlphaLimit};
}

Pass soft_depth_pass(const MaterialRecord& material) {
  const float faintest = material.discard_threshold;
  return {.shaded = false,
          .blended = false,
          .writes_depth = true,
          .culled = unseen_faces(material),
          .alpha_min = faintest > kDepthAlpha ? faintest : kDepthAlpha,
          .alpha_max = material.opaque_threshold};
}

Pass thinned_pass(const MaterialRecord& material, const FragmentCode& code) {
  Pass pass = solid_pass(material);
  pass.alpha_min = material.discard_threshold;
  pass.solid_from = material.opaque_threshold;
  pass.code = &code;
  return pass;
}

void set_draw_state(const GlFunctions& gl) {
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // premultiplied
  gl.FrontFace(GL_CCW);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);  // Among cards in one place the later, outer one wins.
}

void set_pass_state(const GlFunctions& gl, const Pass& pass) {
  set_enabled(gl, GL_BLEND, pass.blended);
  set_enabled(gl, GL_CULL_FACE, pass.culled != GL_NONE);
  if (pass.culled != GL_NONE) gl.CullFace(pass.culled);
  gl.DepthMask(pass.writes_depth ? GL_TRUE : GL_FALSE);
  const GLboolean color = pass.writes_color() ? GL_TRUE : GL_FALSE;
  gl.ColorMask(color, color, color, color);
}

void leave_draw_state(const GlFunctions& gl) {
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ZERO);
  gl.Disable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.Disable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
}

}  // namespace coif
