#include "gl/shadow/shadow_state.h"
#include "gl/textures.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr std::uint32_t kLayersOfTexture = 4;
// Sums of the layers' thickness in shaders/hair_shadow.glsl, in units of the first.
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

PassList plan_front(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup&) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), caster_pass(material, material.discard_threshold));
  return drawn;
}

PassList plan_layers(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup& lookup) {
  Pass pass = caster_pass(material, material.discard_threshold);
  pass.blended = true;
  pass.writes_depth = false;
  pass.code = lookup.id == kEightLookup.id ? &kEightCode : &kFourCode;
  pass.shadow = &lookup;
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), pass);
  return drawn;
}

bool make_layers(GLenum format, ShadowState& shadow) {
  constexpr GLenum kTargets[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  const ShadowFunctions& functions = shadow.functions;
  const auto size = static_cast<GLsizei>(shadow.desc.size);
  const GLsizei count = has_far_layers(shadow.desc) ? 2 : 1;
  shadow.framebuffers[kLayersFramebuffer] = make_framebuffer(functions, shadow.textures[kSolidTexture]);
  for (GLsizei i = 0; i < count; ++i) {
    GLuint& texture = shadow.textures[kLayersTexture + std::uint32_t(i)];
    texture = make_texture(shadow.gl(), format, size, size);
    functions.FramebufferTexture2D(GL_FRAMEBUFFER, kTargets[i], GL_TEXTURE_2D, texture, 0);
  }
  functions.DrawBuffers(count, kTargets);
  return functions.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

/// OpenGL ES 3.0 draws into half floats only with GL_EXT_color_buffer_half_float or _float; nearly all devices have one.
bool make(ShadowState& shadow) {
  const GlFunctions& gl = shadow.gl();
  const ShadowFunctions& functions = shadow.functions;
  shadow.textures[kFrontTexture] = make_depth_texture(shadow);
  shadow.framebuffers[kFrontFramebuffer] = make_framebuffer(functions, shadow.textures[kFrontTexture]);
  if (functions.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
  shadow.opacity_unit = 1;
  if (make_layers(GL_RGBA16F, shadow)) return true;
  functions.DeleteFramebuffers(1, &shadow.framebuffers[kLayersFramebuffer]);
  gl.DeleteTextures(2, &shadow.textures[kLayersTexture]);
  shadow.textures[kFarLayersTexture] = 0;
  clear_errors(gl);
  shadow.opacity_unit = kByteUnit;
  return make_layers(GL_RGBA8, shadow);
}

float first_layer(const ShadowDesc& desc) { return desc.depth / (has_far_layers(desc) ? kEightLayers : kFourLayers); }

std::uint32_t texel_bytes(const ShadowState& shadow) {
  const std::uint32_t layers = shadow.opacity_unit == kByteUnit ? 4 : 8;
  return 8 + (has_far_layers(shadow.desc) ? 2 : 1) * layers;
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
