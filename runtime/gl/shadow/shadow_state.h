#pragma once
// What a shadow is made of: its technique, what it keeps, and what programs need that look it up.

#include "gl/gl_functions.h"
#include "gl/passes.h"
#include "gl/renderer_state.h"

#include <coif/shadow.h>

#include <cstdint>
#include <span>

// The OpenGL ES 3.0 functions that only shadows need, apart from the renderer's own, so that a game without shadows
// asks its host for none of them.
#define COIF_SHADOW_FUNCTIONS(X) \
  X(BindFramebuffer)             \
  X(CheckFramebufferStatus)      \
  X(ClearBufferfv)               \
  X(DeleteFramebuffers)          \
  X(DrawArrays)                  \
  X(DrawBuffers)                 \
  X(FramebufferTexture2D)        \
  X(GenFramebuffers)             \
  X(PolygonOffset)               \
  X(Uniform4f)                   \
  X(Viewport)

namespace coif {

COIF_GL_TABLE(ShadowFunctions, COIF_SHADOW_FUNCTIONS);

/// What a shadow's textures are for; all of its techniques have the first.
enum ShadowTexture : std::uint32_t { kSolidTexture, kFrontTexture, kLayersTexture, kFarLayersTexture };

/// And its framebuffers.
enum ShadowFramebuffer : std::uint32_t {
  kSolidFramebuffer,
  kFrontFramebuffer,
  kLayersFramebuffer,
  kShadowFramebuffers
};

/// From where the light looks.
struct ShadowView {
  double axes[3][3] = {};  ///< Rows: to the map's right and top, and towards the light.
  double eye[3] = {};      ///< Directional: the ball's centre. Else the light's place.
  double radius = 0;
  double distance = 0;  ///< From the light to the ball's centre; 0: directional.
};

/// What a program needs that looks shadows up. The renderer reaches all of a shadow through this, so that it holds none
/// of it where no shadow is named.
struct ShadowLookup {
  std::uint32_t id;       ///< Of the programs that it is part of, 1..15; no two lookups share one.
  const char* pieces[2];  ///< GLSL: a line that defines what the other depends on; hair_light().
  const char* samplers[HairShadow::kTextures];
  ShadowUniforms (*uniforms)(const ShadowState& shadow, const Vec3& origin);
};

/// One drawing of all hair.
struct ShadowStage {
  ShadowFramebuffer framebuffer;
  float slope_bias;  ///< Texels, see set_slope_bias().
  bool adds;         ///< What is drawn adds up, whatever its order.
  /// Passes over an asset whose texture's alpha lies in this range; one or none.
  PassList (*plan_passes)(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup& lookup);
  void (*before)(const ShadowState& shadow) = nullptr;  ///< Binds what the passes read beside the hair's own textures.
};

struct ShadowTechnique {
  static constexpr std::uint32_t kMostStages = 3;

  const char* name;
  float caster_slope_bias;                     ///< Texels; of what the host draws.
  float texel_bias;                            ///< Of a lookup, texels beside ShadowDesc::bias.
  GLenum depth_format = GL_DEPTH_COMPONENT24;  ///< Of make_depth_texture().
  std::uint32_t stage_count;
  ShadowStage stages[kMostStages];
  /// Null for numbers that the technique cannot have.
  const ShadowLookup* (*choose_lookup)(const ShadowDesc& desc);
  /// Makes textures and framebuffers beside those of the solid depth, which are there. False where the driver cannot.
  bool (*make)(ShadowState& shadow);
  /// Metres, of the map's last view. Null: without layers.
  float (*first_layer)(const ShadowState& shadow) = nullptr;
  /// Of all textures.
  std::uint64_t (*bytes)(const ShadowState& shadow);
  /// Draws the stages, in other ways than one after the other. Null: so. kDriver where the driver refuses.
  Status (*draw)(const ShadowState& shadow, std::span<const ShadowCrowd> crowds) = nullptr;
};

/// Each of the map's texels takes so many.
[[nodiscard]] inline std::uint64_t texels_times(const ShadowDesc& desc, std::uint32_t bytes) {
  return std::uint64_t{desc.size} * desc.size * bytes;
}

/// A square part of the map that is drawn as if it were all of it.
struct MapPart {
  std::uint32_t left = 0, bottom = 0;  ///< Texels.
  std::uint32_t size = 0;              ///< 0: all of the map.
};

/// What HairShadow keeps in the room that its public header gives it.
struct ShadowState {
  static constexpr std::uint32_t kMostScratch = 13;

  /// Null before the first create().
  [[nodiscard]] static const ShadowState* of(const HairShadow& shadow) { return shadow.state_; }

  [[nodiscard]] const GlFunctions& gl() const { return renderer->gl; }
  /// Homogeneous, to 0..1 within the map; from world axes around `origin`.
  void map_from_origin(const Vec3& origin, double (&rows)[4][4]) const;
  /// HairShadow's functions of these names.
  void clip_from_origin(const Vec3& origin, float (&clip)[16]) const;
  [[nodiscard]] ShadowUniforms uniforms(const Vec3& origin) const;
  [[nodiscard]] std::span<const ShadowStage> stages() const {
    return std::span(desc.technique->stages).first(desc.technique->stage_count);
  }

  ShadowFunctions functions;
  RendererState* renderer = nullptr;  ///< Null: nothing has been made.
  const ShadowLookup* lookup = nullptr;
  ShadowDesc desc{.technique = nullptr};  // a default would hold a technique that nobody named
  GLuint textures[HairShadow::kTextures] = {};
  GLuint framebuffers[kShadowFramebuffers] = {};
  GLuint scratch[kMostScratch] = {};  ///< Textures that nothing looks up.
  GLuint program = 0;                 ///< The technique's own, beside those that draw hair.
  float opacity_unit = 1;             ///< What 1 in a texel of the layers stands for.
  GLint layer_targets = 0;            ///< Textures that kLayersFramebuffer adds to.
  ShadowView view;
  bool is_begun = false;
};

/// False for a light or a ball that there is no view for; `size`: texels each way.
[[nodiscard]] bool aim(const Light& light, const ShadowBall& ball, std::uint32_t size, ShadowView& view);

/// All texels from `alpha_min` on, depth only.
[[nodiscard]] Pass caster_pass(const MaterialRecord& material, float alpha_min);

/// Read texel by texel. Leaves it bound to the active unit.
[[nodiscard]] GLuint make_depth_texture(const ShadowState& shadow);

/// Textures for what fades light, four values to a texel, in halves or else in bytes, which ShadowState::opacity_unit
/// tells then: OpenGL ES 3.0 draws into half floats only with GL_EXT_color_buffer_half_float or _float; nearly all
/// devices have one. False where the driver cannot. `first`, and as many as `count` from there on.
bool make_opacity_layers(ShadowState& shadow, ShadowTexture first, std::uint32_t count);
[[nodiscard]] std::uint32_t opacity_texel_bytes(const ShadowState& shadow);
/// Hair that goes into the map of solid things instead, and the rest.
[[nodiscard]] PassList plan_solid_hair(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup&);
[[nodiscard]] Pass soft_caster_pass(const MaterialRecord& material);

/// Draws all crowds into the framebuffer that is bound.
Status draw_hair(const ShadowState& shadow, const ShadowStage& stage, std::span<const ShadowCrowd> crowds,
                 const MapPart& part = {});

/// Depths move away from the light by what they change within a few texels, so that a surface does not shade itself
/// where light grazes it: percentage-closer filtering compares it to its neighbours. 0 turns it off.
void set_slope_bias(const ShadowState& shadow, float texels);

/// Leaves it bound.
[[nodiscard]] GLuint make_framebuffer(const ShadowFunctions& functions, GLuint depth);

/// ShadowState::uniforms().
[[nodiscard]] ShadowUniforms uniforms_of(const ShadowState& shadow, const Vec3& origin);

}  // namespace coif
