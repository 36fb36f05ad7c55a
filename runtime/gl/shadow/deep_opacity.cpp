#include "gl/shadow/shadow_technique.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr std::uint32_t kLayersOfTexture = 4;
// Sums of the layers' thickness in shaders/hair_shadow_deep.glsl, in units of the first.
constexpr float kFourLayers = 15.0f, kEightLayers = 49.2578125f;
// Bytes hold opacities up to this, where a fiftieth of the light is left, in steps of a sixtieth.
constexpr float kByteUnit = 4.0f;

bool has_far_layers(const ShadowDesc& desc) { return desc.layers > kLayersOfTexture; }

const FragmentCode kFourCode = {14, kShaderKeepRangeGlsl, nullptr, kShaderHairLayersFrag};
const FragmentCode kEightCode = {15, kShaderKeepRangeGlsl, nullptr, kShaderHairLayersFrag};

constexpr ShadowLookup kFourLookup = {2,
                                      {"#define COIF_SHADOW_LAYERS 4\n", kShaderHairShadowDeepGlsl},
                                      {"hair_shadow_solid", "hair_shadow_front", "hair_shadow_layers"},
                                      uniforms_of};
constexpr ShadowLookup kEightLookup = {
    3,
    {"#define COIF_SHADOW_LAYERS 8\n", kShaderHairShadowDeepGlsl},
    {"hair_shadow_solid", "hair_shadow_front", "hair_shadow_layers", "hair_shadow_far_layers"},
    uniforms_of};

const ShadowLookup* choose_lookup(const ShadowDesc& desc) {
  if (desc.layers != kLayersOfTexture && desc.layers != 2 * kLayersOfTexture) return nullptr;
  return has_far_layers(desc) ? &kEightLookup : &kFourLookup;
}

/// All that is drawn at all.
Pass whole_pass(const MaterialRecord& material) {
  return {.shaded = false,
          .blended = false,
          .writes_depth = true,
          .culled = unseen_faces(material),
          .alpha_min = material.discard_threshold,
          .alpha_max = kNoAlphaLimit};
}

PassList plan_front(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup&) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), whole_pass(material));
  return drawn;
}

PassList plan_layers(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup& lookup) {
  Pass pass = whole_pass(material);
  pass.blended = true;
  pass.writes_depth = false;
  pass.code = lookup.id == kEightLookup.id ? &kEightCode : &kFourCode;
  pass.shadow = &lookup;
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), pass);
  return drawn;
}

GLuint make_layers_texture(const GlFunctions& gl, GLenum format, GLsizei size) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexStorage2D(GL_TEXTURE_2D, 1, format, size, size);
  return texture;
}

bool make_layers(const GlFunctions& gl, const ShadowFunctions& functions, GLenum format, HairShadow& shadow) {
  constexpr GLenum kTargets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  GLuint* const textures = ShadowTechnique::textures(shadow);
  const GLsizei count = has_far_layers(shadow.desc()) ? 2 : 1;
  ShadowTechnique::framebuffers(shadow)[kLayersFramebuffer] = make_framebuffer(functions, textures[kSolidTexture]);
  for (GLsizei i = 0; i < count; ++i) {
    textures[kLayersTexture + std::uint32_t(i)] = make_layers_texture(gl, format, GLsizei(shadow.desc().size));
    functions.FramebufferTexture2D(GL_FRAMEBUFFER, kTargets[i], GL_TEXTURE_2D,
                                   textures[kLayersTexture + std::uint32_t(i)], 0);
  }
  functions.DrawBuffers(count, kTargets);
  return functions.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

/// OpenGL ES 3.0 draws into half floats only with GL_EXT_color_buffer_half_float or _float; nearly all devices have one.
bool make(const GlFunctions& gl, const ShadowFunctions& functions, HairShadow& shadow) {
  GLuint* const textures = ShadowTechnique::textures(shadow);
  GLuint* const framebuffers = ShadowTechnique::framebuffers(shadow);
  textures[kFrontTexture] = make_depth_texture(gl, shadow.desc().size);
  framebuffers[kFrontFramebuffer] = make_framebuffer(functions, textures[kFrontTexture]);
  if (functions.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
  ShadowTechnique::opacity_unit(shadow) = 1;
  if (make_layers(gl, functions, GL_RGBA16F, shadow)) return true;
  functions.DeleteFramebuffers(1, &framebuffers[kLayersFramebuffer]);
  gl.DeleteTextures(2, &textures[kLayersTexture]);
  textures[kFarLayersTexture] = 0;
  clear_errors(gl);
  ShadowTechnique::opacity_unit(shadow) = kByteUnit;
  return make_layers(gl, functions, GL_RGBA8, shadow);
}

float first_layer(const ShadowDesc& desc) { return desc.depth / (has_far_layers(desc) ? kEightLayers : kFourLayers); }

std::uint32_t texel_bytes(const HairShadow& shadow) {
  const std::uint32_t layers = ShadowTechnique::opacity_unit(shadow) == kByteUnit ? 4 : 8;
  return 8 + (has_far_layers(shadow.desc()) ? 2 : 1) * layers;
}

}  // namespace

// Within a layer a card shades itself by the share of the layer that lies before it, so little bias is needed.
const ShadowTechnique kDeepOpacityShadow = {
    .name = "deep",
    .caster_slope_bias = 2,
    .texel_bias = 0.25f,
    .stage_count = 2,
    .stages = {{kFrontFramebuffer, 0.5f, plan_front}, {kLayersFramebuffer, 0, plan_layers}},
    .choose_lookup = choose_lookup,
    .make = make,
    .first_layer = first_layer,
    .texel_bytes = texel_bytes};

}  // namespace coif
