#include "gl/shadow/shadow_state.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr std::uint32_t kSlicesOfTexture = 4, kMostSlices = 12;

std::uint32_t slices_of(const ShadowDesc& desc) { return desc.layers == 0 ? kMostSlices : desc.layers; }

constexpr FragmentCode code_of(std::uint32_t id) { return {id, kShaderKeepRangeGlsl, nullptr, kShaderHairSlicesFrag}; }
const FragmentCode kSliceCodes[] = {code_of(18), code_of(19), code_of(20)};

#define COIF_SLICES(count) \
  { "#define COIF_SHADOW_SLICES " #count "\n", kShaderHairShadowSlicesGlsl }
constexpr ShadowLookup kSliceLookups[] = {
    {5, COIF_SLICES(4), {"hair_shadow_solid", "hair_shadow_slices"}, uniforms_of},
    {6, COIF_SLICES(8), {"hair_shadow_solid", "hair_shadow_slices", "hair_shadow_middle_slices"}, uniforms_of},
    {7,
     COIF_SLICES(12),
     {"hair_shadow_solid", "hair_shadow_slices", "hair_shadow_middle_slices", "hair_shadow_far_slices"},
     uniforms_of}};
#undef COIF_SLICES

const ShadowLookup* choose_slices(const ShadowDesc& desc) {
  const std::uint32_t slices = slices_of(desc);
  if (slices % kSlicesOfTexture != 0 || slices > kMostSlices) return nullptr;
  return &kSliceLookups[slices / kSlicesOfTexture - 1];
}

PassList plan_slices(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup& lookup) {
  Pass pass = soft_caster_pass(material);
  pass.blended = true;
  pass.writes_depth = false;
  pass.code = &kSliceCodes[lookup.id - kSliceLookups[0].id];
  pass.shadow = &lookup;
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), pass);
  return drawn;
}

std::uint32_t slice_textures(const ShadowDesc& desc) { return slices_of(desc) / kSlicesOfTexture; }

bool make_slices(ShadowState& shadow) {
  return make_opacity_layers(shadow, kFrontTexture, slice_textures(shadow.desc));
}

float distance_of_slices(const ShadowState& shadow) {
  return static_cast<float>(2 * shadow.view.radius / slices_of(shadow.desc));
}

std::uint64_t bytes_of_slices(const ShadowState& shadow) {
  return texels_times(shadow.desc, 4 + slice_textures(shadow.desc) * opacity_texel_bytes(shadow));
}

}  // namespace

const ShadowTechnique kOpacityShadow = {
    .name = "opacity",
    .caster_slope_bias = 1,
    .texel_bias = 0.5f,
    .stage_count = 2,
    .stages = {{kSolidFramebuffer, 1, false, plan_solid_hair}, {kLayersFramebuffer, 0, true, plan_slices}},
    .choose_lookup = choose_slices,
    .make = make_slices,
    .first_layer = distance_of_slices,
    .bytes = bytes_of_slices};

}  // namespace coif
