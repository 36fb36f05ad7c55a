#pragma once

#include <coif/export.h>
#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

struct ShadowState;
struct ShadowTechnique;

/// A depth map: hair from alpha 0.5 on casts a shadow as if it were solid, with soft edges of about two texels by
/// percentage-closer filtering (Reeves et al. 1987). 4 bytes per texel, one pass over the hair.
extern COIF_API const ShadowTechnique kPlainShadow;

/// Deep opacity maps (Yuksel and Keyser 2008): layers that begin where the light first meets hair, and how much hair
/// lies in each. Light fades on its way through the hair by each strand's alpha; hair from alpha 0.9 on is solid. Three
/// passes over the hair; 16 bytes per texel with four layers, 24 with eight, 12 and 16 where the driver cannot draw
/// into half floats. The errors of all techniques: `coif report FILE shadows`.
extern COIF_API const ShadowTechnique kDeepOpacityShadow;

/// Opacity shadow maps (Kim and Neumann, "Opacity shadow maps", EGWR 2001; thesis, section 4.2.2): planes across the
/// light, at equal distances over the ball, and how much hair lies before each; light between two planes is
/// interpolated. Two passes over the hair; 12 bytes per texel with 4 planes, 20 with 8, 28 with 12, where the planes
/// beyond 4 take half as much if the driver cannot draw into half floats. Planes are centimetres apart, so hair is
/// shaded like fog; deep opacity maps put their layers where the hair is.
extern COIF_API const ShadowTechnique kOpacityShadow;

/// Deep shadow maps (Lokovic and Veach, "Deep shadow maps", SIGGRAPH 2000; thesis, section 4.2.1): for each texel a
/// function of depth says how much light passes its hair, here compressed to the two steps that fit best. The hair's
/// nearest layers towards the light, as many as ShadowDesc::layers, are peeled off one by one, in each of 16 parts of
/// the map: one pass over the hair for each layer and one for the rest. 6 bytes per texel; while drawing also 13 to 20
/// bytes for each of a 16th of the texels. The steps need no bias. The most exact technique, and the slowest to draw.
extern COIF_API const ShadowTechnique kDeepShadow;

/// The name on the command line: "plain", "opacity", "deep", "deep-shadow".
[[nodiscard]] COIF_API const char* name_of(const ShadowTechnique& technique);

struct ShadowDesc {
  const ShadowTechnique* technique = &kDeepShadow;
  std::uint32_t size = 512;  ///< Texels each way, 16..4096.
  /// kOpacityShadow: planes, 4, 8 or 12; kDeepOpacityShadow: 4 or 8; kDeepShadow: 2 to 6. 0 means 12, 4, and 6.
  std::uint32_t layers = 0;
  /// kDeepOpacityShadow: metres from the first layer's front to the last one's end, > 0. Deeper hair counts as the last
  /// layer's.
  float depth = 0.08f;
  /// Metres, >= 0: hair that is nearer to a surface does not shade it. A part of a texel's width is added.
  float bias = 0;
};

/// A ball around everything that casts shadows or catches them; world, metres.
struct ShadowBall {
  double center[3] = {};
  /// > 0. The smaller, the finer the shadow; one head with long hair needs about 0.4 times its scale.
  float radius = 0.5f;
};

/// One asset's heads among those that cast shadows.
struct ShadowCrowd {
  const HairModel* model = nullptr;
  std::span<const HairInstance> instances;
  const MaterialRecord* material = nullptr;  ///< As in DrawDesc.
};

/// The shadow of one light: hair shades hair, heads and bodies; the host's solid things shade hair. In each frame:
/// begin(); the host draws its shadow casters, depth only; draw() adds the hair. Then HairRenderer::draw() shades hair
/// by DrawDesc::shadow, and the host's own shaders look shadows up with code(), uniforms() and the textures. create()
/// makes all OpenGL objects. The renderer's context must be current in every call. The destructor calls no OpenGL
/// function: call destroy() while the context lives.
class COIF_API HairShadow {
 public:
  static constexpr std::uint32_t kTextures = 4;

  HairShadow() = default;
  HairShadow(const HairShadow&) = delete;
  HairShadow& operator=(const HairShadow&) = delete;

  /// `renderer` must be created and outlive this object. kNotCreated, kBadArgument; kDriver where a function is missing
  /// or there is no memory: see HairRenderer::failure(). Destroys an existing shadow first. Clears OpenGL's error
  /// flags. Leaves the framebuffer binding and the 2D texture of unit 0 empty, and that unit active.
  Status create(HairRenderer& renderer, const GlLoader& loader, const ShadowDesc& desc = {});
  void destroy();
  [[nodiscard]] bool is_created() const;

  /// Aims the map from the light at the ball and clears it. kNotCreated; kBadArgument for a light or a ball out of
  /// range, or for a point or spot light within 1.05 radii of the ball's centre, which gives no direction. After these
  /// errors no OpenGL function has been called and the last map stays.
  ///
  /// Sets for the host's casters: draw and read framebuffer, to one with only a depth buffer; the viewport, to all of
  /// it; scissor test and blending off; depth test on with GL_LEQUAL, depth and colour mask on, no face culled; a
  /// polygon offset that grows with the slope.
  Status begin(const Light& light, const ShadowBall& ball);

  /// The transform for the host's casters between begin() and draw(): column-major, to OpenGL clip space, from world
  /// axes around `origin` (world, metres). Does not mirror.
  void clip_from_origin(const Vec3& origin, float (&clip)[16]) const;

  /// Draws the hair that casts shadows, once after begin(). kNotCreated; kBadArgument without a begin() before, or for
  /// a material out of range; the errors of HairRenderer::draw() for models and instances. After an error nothing has
  /// been drawn.
  ///
  /// OpenGL state as after HairRenderer::draw(). It also leaves the framebuffer bindings empty, the viewport as begin()
  /// sets it, scissor test and polygon offset off, 2D texture and sampler of units 0 to 13 empty. The host binds its
  /// own framebuffer next.
  Status draw(std::span<const ShadowCrowd> crowds);

  /// Builds the programs that draw() would build first for this asset, with its own or another material.
  Status prepare(const HairModel& model, const MaterialRecord* material = nullptr);

  /// GLSL ES 3.00 for a host's own fragment shader. It defines
  /// - `vec2 hair_slope(vec4 place)`: the slope of the surface in the map, where `place` is map_from_origin times the
  ///   point. Uses the neighbours' values: call it before any discard.
  /// - `float hair_light(vec4 place, vec2 slope, vec4 depth, vec4 map)`: the share 0..1 of the light that reaches the
  ///   point.
  ///
  /// Put both pieces before the first use, in their order. They are shaders/hair_shadow.glsl, for maps with layers
  /// after a line with the number of layers. Null before create().
  [[nodiscard]] std::span<const char* const, 2> code() const;

  /// The sampler's name in code() for each texture; null where the technique does not use it. All textures are 2D.
  [[nodiscard]] const char* sampler(std::uint32_t texture) const;
  [[nodiscard]] std::uint32_t texture(std::uint32_t texture) const;
  [[nodiscard]] ShadowUniforms uniforms(const Vec3& origin) const;

  /// The bytes of all textures together, without padding.
  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] const ShadowDesc& desc() const;

 private:
  friend struct ShadowState;
  static constexpr std::size_t kStateBytes = 512;

  ShadowState* state_ = nullptr;  ///< In room_, from the first create() on.
  alignas(double) std::byte room_[kStateBytes];
};

}  // namespace coif
