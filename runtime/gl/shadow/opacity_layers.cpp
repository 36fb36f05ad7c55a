// Maps that add up the amount of hair: their textures, and the solid hair that they leave out.

#include "gl/shadow/shadow_state.h"
#include "gl/textures.h"

namespace coif {
namespace {

// The largest opacity that bytes hold, in steps of a sixtieth. It leaves a fiftieth of the light.
constexpr float kByteUnit = 4.0f;
// From this alpha on less than a tenth of the light passes, so hair counts as solid: a layer would smear it over its
// thickness.
constexpr float kSolidHairFrom = 0.9f;
constexpr GLenum kTargets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};

bool make_layers(ShadowState& shadow, GLenum format, ShadowTexture first) {
  const ShadowFunctions& functions = shadow.functions;
  const auto size = static_cast<GLsizei>(shadow.desc.size);
  shadow.framebuffers[kLayersFramebuffer] = make_framebuffer(functions, shadow.textures[kSolidTexture]);
  for (GLint i = 0; i < shadow.layer_targets; ++i) {
    GLuint& texture = shadow.textures[first + std::uint32_t(i)];
    texture = make_texture(shadow.gl(), format, size, size);
    functions.FramebufferTexture2D(GL_FRAMEBUFFER, kTargets[i], GL_TEXTURE_2D, texture, 0);
  }
  functions.DrawBuffers(shadow.layer_targets, kTargets);
  return functions.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

bool make_opacity_layers(ShadowState& shadow, ShadowTexture first, std::uint32_t count) {
  const GlFunctions& gl = shadow.gl();
  shadow.layer_targets = static_cast<GLint>(count);
  shadow.opacity_unit = 1;
  if (make_layers(shadow, GL_RGBA16F, first)) return true;
  shadow.functions.DeleteFramebuffers(1, &shadow.framebuffers[kLayersFramebuffer]);
  gl.DeleteTextures(shadow.layer_targets, &shadow.textures[first]);
  clear_errors(gl);
  shadow.opacity_unit = kByteUnit;
  return make_layers(shadow, GL_RGBA8, first);
}

PassList plan_solid_hair(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup&) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), caster_pass(material, kSolidHairFrom));
  return drawn;
}

Pass soft_caster_pass(const MaterialRecord& material) {
  Pass pass = caster_pass(material, material.discard_threshold);
  pass.alpha_max = kSolidHairFrom;
  return pass;
}

std::uint32_t opacity_texel_bytes(const ShadowState& shadow) { return shadow.opacity_unit == kByteUnit ? 4 : 8; }

}  // namespace coif
