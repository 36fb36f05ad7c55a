#pragma once
// The parts of a shadow: its technique, its state, and what programs need that look it up.

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

/// The purposes of a shadow's textures. All techniques have the first.
enum ShadowTexture : std::uint32_t { kSolidTexture, kFrontTexture, kLayersTexture, kFarLayersTexture };

/// The framebuffers of a shadow.
enum ShadowFramebuffer : std::uint32_t {
  kSolidFramebuffer,
  kFrontFramebuffer,
  kLayersFramebuffer,
  kShadowFramebuffers
};

/// The light's view.
struct ShadowView {
  double axes[3][3] = {};  ///< Rows: to the map's right and top, and towards the light.
  double eye[3] = {};      ///< Directional: the ball's centre. Else the light's position.
  double radius = 0;
  double distance = 0;  ///< From the light to the ball's centre, metres; 0: directional.
};

/// What a program needs that looks shadows up. The renderer uses shadows only through this, so a program that names no
/// shadow links none of their code.
struct ShadowLookup {
  std::uint32_t id;       ///< Marks the programs that contain the lookup; 1..15, no two lookups share one.
  const char* pieces[2];  ///< GLSL: a line of definitions for the second piece; hair_light().
  const char* samplers[HairShadow::kTextures];
  ShadowUniforms (*uniforms)(const ShadowState& shadow, const Vec3& origin);
};

/// One pass over all hair.
struct ShadowStage {
  ShadowFramebuffer framebuffer;
  float slope_bias;  ///< Texels, see set_slope_bias().
  bool adds;         ///< Colours add up, in any order.
  /// The passes over an asset whose texture's alpha lies in this range; one or none.
  PassList (*plan_passes)(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup& lookup);
  /// Binds the textures that the passes read besides the hair's own.
  void (*before)(const ShadowState& shadow) = nullptr;
};

struct ShadowTechnique {
  static constexpr std::uint32_t kMostStages = 3;

  const char* name;
  float caster_slope_bias;                     ///< In texels, for things that the host draws.
  float texel_bias;                            ///< Added to ShadowDesc::bias at a lookup, texels.
  GLenum depth_format = GL_DEPTH_COMPONENT24;  ///< Used by make_depth_texture().
  std::uint32_t stage_count;
  ShadowStage stages[kMostStages];
  /// Null for a description that the technique does not support.
  const ShadowLookup* (*choose_lookup)(const ShadowDesc& desc);
  /// Makes the textures and framebuffers besides those of the solid depth, which exist. False where the driver cannot.
  bool (*make)(ShadowState& shadow);
  /// Depth of the first layer in the map's last view, metres. Null: a technique without layers.
  float (*first_layer)(const ShadowState& shadow) = nullptr;
  /// Bytes of all textures.
  std::uint64_t (*bytes)(const ShadowState& shadow);
  /// Draws the stages in a way of its own. Null: one after the other. kDriver where the driver refuses.
  Status (*draw)(const ShadowState& shadow, std::span<const ShadowCrowd> crowds) = nullptr;
};

/// Bytes of a map that has so many for each texel.
[[nodiscard]] inline std::uint64_t texels_times(const ShadowDesc& desc, std::uint32_t bytes) {
  return std::uint64_t{desc.size} * desc.size * bytes;
}

/// A square part of the map that is drawn as if it were the whole map.
struct MapPart {
  std::uint32_t left = 0, bottom = 0;  ///< Texels.
  std::uint32_t size = 0;              ///< 0: all of the map.
};

/// The state of HairShadow, in the room that its public header reserves.
struct ShadowState {
  static constexpr std::uint32_t kMostScratch = 13;

  /// Null before the first create().
  [[nodiscard]] static const ShadowState* of(const HairShadow& shadow) { return shadow.state_; }

  [[nodiscard]] const GlFunctions& gl() const { return renderer->gl; }
  /// Rows of the homogeneous transform from world axes around `origin` to 0..1 within the map.
  void map_from_origin(const Vec3& origin, double (&rows)[4][4]) const;
  /// These two implement HairShadow's functions of the same names.
  void clip_from_origin(const Vec3& origin, float (&clip)[16]) const;
  [[nodiscard]] ShadowUniforms uniforms(const Vec3& origin) const;
  [[nodiscard]] std::span<const ShadowStage> stages() const {
    return std::span(desc.technique->stages).first(desc.technique->stage_count);
  }

  ShadowFunctions functions;
  RendererState* renderer = nullptr;  ///< Null: nothing has been made.
  const ShadowLookup* lookup = nullptr;
  ShadowDesc desc{.technique = nullptr};  // The default would link a technique that nobody named.
  GLuint textures[HairShadow::kTextures] = {};
  GLuint framebuffers[kShadowFramebuffers] = {};
  GLuint scratch[kMostScratch] = {};  ///< Textures that no shader of the host looks up.
  GLuint program = 0;                 ///< The technique's own program, besides those that draw hair.
  float opacity_unit = 1;             ///< The opacity that a value of 1 in a texel of the layers stands for.
  GLint layer_targets = 0;            ///< Textures that kLayersFramebuffer adds to.
  ShadowView view;
  bool is_begun = false;
};

/// False for a light or a ball that gives no view. `size`: texels each way.
[[nodiscard]] bool aim(const Light& light, const ShadowBall& ball, std::uint32_t size, ShadowView& view);

/// A pass over all texels from `alpha_min` on, depth only.
[[nodiscard]] Pass caster_pass(const MaterialRecord& material, float alpha_min);

/// Makes a texture for lookups without filtering. Leaves it bound to the active unit.
[[nodiscard]] GLuint make_depth_texture(const ShadowState& shadow);

/// Makes textures for the opacity of hair, four values per texel, as half floats or else as bytes;
/// ShadowState::opacity_unit then gives the scale. OpenGL ES 3.0 draws into half floats only with
/// GL_EXT_color_buffer_half_float or _float, which nearly all devices have. Makes `count` textures, `first` and those
/// after it. False where the driver cannot.
bool make_opacity_layers(ShadowState& shadow, ShadowTexture first, std::uint32_t count);
[[nodiscard]] std::uint32_t opacity_texel_bytes(const ShadowState& shadow);
/// Separates hair that goes into the map of solid things from the rest.
[[nodiscard]] PassList plan_solid_hair(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup&);
[[nodiscard]] Pass soft_caster_pass(const MaterialRecord& material);

/// Draws all crowds into the framebuffer that is bound.
Status draw_hair(const ShadowState& shadow, const ShadowStage& stage, std::span<const ShadowCrowd> crowds,
                 const MapPart& part = {});

/// Moves depths away from the light by their change within a few texels, so that a surface at a grazing angle does not
/// shade itself: percentage-closer filtering compares it with its neighbours. 0 turns it off.
void set_slope_bias(const ShadowState& shadow, float texels);

/// Makes a framebuffer and leaves it bound.
[[nodiscard]] GLuint make_framebuffer(const ShadowFunctions& functions, GLuint depth);

/// Implements ShadowState::uniforms().
[[nodiscard]] ShadowUniforms uniforms_of(const ShadowState& shadow, const Vec3& origin);

}  // namespace coif
