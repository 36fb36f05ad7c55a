#pragma once

#include "gl/alpha_range.h"
#include "gl/gl_functions.h"
#include "gl/passes.h"
#include "gl/shadow/shadow_functions.h"
#include "gl/shadow/shadow_lookup.h"

#include <coif/asset_records.h>

#include <cstdint>

namespace coif {

/// What a shadow's textures are for; all of its techniques have the first.
enum ShadowTexture : std::uint32_t { kSolidTexture, kFrontTexture, kLayersTexture, kFarLayersTexture };

/// And its framebuffers.
enum ShadowFramebuffer : std::uint32_t { kSolidFramebuffer, kFrontFramebuffer, kLayersFramebuffer };

/// One drawing of all hair.
struct ShadowStage {
  ShadowFramebuffer framebuffer;
  float slope_bias;  ///< Texels, see set_slope_bias().
  /// Passes over an asset whose texture's alpha lies in this range; one or none.
  PassList (*plan_passes)(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup& lookup);
};

struct ShadowTechnique {
  static constexpr std::uint32_t kMostStages = 2;

  const char* name;
  float caster_slope_bias;  ///< Texels; of what the host draws.
  float texel_bias;         ///< Of a lookup, texels beside ShadowDesc::bias.
  std::uint32_t stage_count;
  ShadowStage stages[kMostStages];
  /// Null for numbers that the technique cannot have.
  const ShadowLookup* (*choose_lookup)(const ShadowDesc& desc);
  /// Makes textures and framebuffers beside those of the solid depth, which are there. False where the driver cannot.
  bool (*make)(const GlFunctions& gl, const ShadowFunctions& functions, HairShadow& shadow);
  /// Metres; 0 without layers.
  float (*first_layer)(const ShadowDesc& desc);
  std::uint32_t (*texel_bytes)(const HairShadow& shadow);

  // For `make`: a shadow's own.
  static std::uint32_t* textures(HairShadow& shadow) { return shadow.textures_; }
  static std::uint32_t* framebuffers(HairShadow& shadow) { return shadow.framebuffers_; }
  static float& opacity_unit(HairShadow& shadow) { return shadow.opacity_unit_; }
  static float opacity_unit(const HairShadow& shadow) { return shadow.opacity_unit_; }
};

/// Read texel by texel. Leaves it bound to the active unit.
[[nodiscard]] GLuint make_depth_texture(const GlFunctions& gl, std::uint32_t size);

/// Depths move away from the light by what they change within a few texels, so that a surface does not shade itself where
/// light grazes it: percentage-closer filtering compares it to its neighbours. 0 turns it off.
void set_slope_bias(const GlFunctions& gl, const ShadowFunctions& functions, float texels);

/// Leaves it bound.
[[nodiscard]] GLuint make_framebuffer(const ShadowFunctions& functions, GLuint depth);

/// HairShadow::uniforms().
[[nodiscard]] ShadowUniforms uniforms_of(const HairShadow& shadow, const Vec3& origin);

}  // namespace coif
