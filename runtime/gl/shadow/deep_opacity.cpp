#include "gl/shadow/shadow_state.h"
#include "gl/textures.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr std::uint32_t kLayersOfTexture = 4;
// Sum of the layers' thicknesses in shaders/hair_shadow.glsl, where the first layer's is 1.
constexpr float kFourLayers = 15.0f, kEightLayers = 49.2578125f;

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
  if (desc.layers != 0 && desc.layers != kLayersOfTexture && desc.layers != 2 * kLayersOfTexture) return nullptr;
  return has_far_layers(desc) ? &kEightLookup : &kFourLookup;
}

PassList plan_front(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup&) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), soft_caster_pass(material));
  return drawn;
}

PassList plan_layers(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup& lookup) {
  Pass pass = soft_caster_pass(material);
  pass.blended = true;
  pass.writes_depth = false;
  pass.code = lookup.id == kEightLookup.id ? &kEightCode : &kFourCode;
  pass.shadow = &lookup;
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), pass);
  return drawn;
}

bool make(ShadowState& shadow) {
  shadow.textures[kFrontTexture] = make_depth_texture(shadow);
  shadow.framebuffers[kFrontFramebuffer] = make_framebuffer(shadow.functions, shadow.textures[kFrontTexture]);
  if (shadow.functions.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
  return make_opacity_layers(shadow, kLayersTexture, has_far_layers(shadow.desc) ? 2 : 1);
}

void bind_front(const ShadowState& shadow) {
  bind_texture(shadow.gl(), kShadowUnit + kFrontTexture, shadow.textures[kFrontTexture]);
}

float first_layer(const ShadowState& shadow) {
  return shadow.desc.depth / (has_far_layers(shadow.desc) ? kEightLayers : kFourLayers);
}

std::uint64_t bytes(const ShadowState& shadow) {
  return texels_times(shadow.desc, 8 + (has_far_layers(shadow.desc) ? 2 : 1) * opacity_texel_bytes(shadow));
}

}  // namespace

// Within a layer a card shades itself by the share of the layer that lies before it, so layers need little bias.
const ShadowTechnique kDeepOpacityShadow = {.name = "deep",
                                            .caster_slope_bias = 2,
                                            .texel_bias = 0.25f,
                                            .stage_count = 3,
                                            .stages = {{kSolidFramebuffer, 1, false, plan_solid_hair},
                                                       {kFrontFramebuffer, 0.5f, false, plan_front},
                                                       {kLayersFramebuffer, 0, true, plan_layers, bind_front}},
                                            .choose_lookup = choose_lookup,
                                            .make = make,
                                            .first_layer = first_layer,
                                            .bytes = bytes};

}  // namespace coif
