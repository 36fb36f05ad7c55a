#include "gl/shadow/shadow_state.h"

#include <hair_shaders.h>

namespace coif {
namespace {

// At an alpha of one half either choice makes the shadow wrong by half.
constexpr float kSolidFrom = 0.5f;

PassList plan(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup&) {
  const float threshold = material.opaque_threshold < kSolidFrom ? material.opaque_threshold : kSolidFrom;
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), caster_pass(material, threshold));
  return drawn;
}

constexpr ShadowLookup kLookup = {1, {"", kShaderHairShadowPlainGlsl}, {"hair_shadow_solid"}, uniforms_of};

const ShadowLookup* choose_lookup(const ShadowDesc&) { return &kLookup; }
bool make(ShadowState&) { return true; }
std::uint64_t bytes(const ShadowState& shadow) { return texels_times(shadow.desc, 4); }

}  // namespace

// The biases here and of the deep map have the least error over several real haircuts, see `coif report FILE shadows`.
// With smaller ones cards shade themselves; with larger ones cards close beneath others are lit.
const ShadowTechnique kPlainShadow = {.name = "plain",
                                      .caster_slope_bias = 1,
                                      .texel_bias = 0.5f,
                                      .stage_count = 1,
                                      .stages = {{kSolidFramebuffer, 1, false, plan}},
                                      .choose_lookup = choose_lookup,
                                      .make = make,
                                      .bytes = bytes};

}  // namespace coif
