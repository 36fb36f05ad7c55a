#include "gl/draw_state.h"

namespace coif {
namespace {

void set_enabled(const GlFunctions& gl, GLenum capability, bool enabled) {
  enabled ? gl.Enable(capability) : gl.Disable(capability);
}

}  // namespace

void set_draw_state(const GlFunctions& gl) {
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // premultiplied
  gl.FrontFace(GL_CCW);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);  // of cards in one place the later, outer one wins
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

void bind_texture(const GlFunctions& gl, GLint unit, GLuint texture) {
  if (texture == 0) return;
  const auto place = static_cast<GLuint>(unit);
  gl.BindSampler(place, 0);  // one of the host's would override the texture's own filters
  gl.ActiveTexture(GL_TEXTURE0 + place);
  gl.BindTexture(GL_TEXTURE_2D, texture);
}

void unbind_texture(const GlFunctions& gl, GLint unit) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(unit));
  gl.BindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace coif
