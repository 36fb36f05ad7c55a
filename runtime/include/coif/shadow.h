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
/// percentage-closer filtering (Reeves et al. 1987). 4 bytes a texel, one pass over the hair.
extern COIF_API const ShadowTechnique kPlainShadow;

/// Deep opacity maps (Yuksel and Keyser 2008): layers that begin where the light first meets hair, and how much hair
/// lies in each. Light fades as it goes in, by each strand's alpha; hair from alpha 0.9 on is solid. Three passes over
/// the hair; 16 bytes a texel with four layers, 24 with eight, 12 and 16 where the driver cannot draw into half floats.
/// The errors of all techniques: `coif report FILE shadows`.
extern COIF_API const ShadowTechnique kDeepOpacityShadow;

/// Opacity shadow maps (Kim and Neumann, "Opacity shadow maps", EGWR 2001; thesis, section 4.2.2): planes across the
/// light, equally far apart over the ball, and how much hair lies before each; light between two planes is
/// interpolated. Two passes over the hair; 12 bytes a texel with 4 planes, 20 with 8, 28 with 12, half of what is
/// beyond 4 where the driver cannot draw into half floats. Planes are centimetres apart, so hair is shaded as if it
/// were fog: deep opacity maps put the layers where the hair is.
extern COIF_API const ShadowTechnique kOpacityShadow;

/// Deep shadow maps (Lokovic and Veach, "Deep shadow maps", SIGGRAPH 2000; thesis, section 4.2.1): of each texel how
/// much light passes its hair is a function of depth, here compressed to the two steps that come nearest to it. The
/// hair's nearest layers towards the light, as many as ShadowDesc::layers, are peeled off one by one, with a pass over
/// the hair for each and one for what is left, in each of 16 parts of the map. 6 bytes a texel, and 13 to 20 bytes for
/// each of a 16th of the texels, which nothing looks up. Its steps need no bias. Nearest to the truth, and dearest to
/// draw.
extern COIF_API const ShadowTechnique kDeepShadow;

/// As the command line calls it: "plain", "opacity", "deep", "deep-shadow".
[[nodiscard]] COIF_API const char* name_of(const ShadowTechnique& technique);

struct ShadowDesc {
  const ShadowTechnique* technique = &kDeepShadow;
  std::uint32_t size = 512;  ///< Texels each way, 16..4096.
  /// kOpacityShadow: planes, 4, 8 or 12; kDeepOpacityShadow: 4 or 8; kDeepShadow: 2 to 6. 0: 12, 4, and 6.
  std::uint32_t layers = 0;
  /// kDeepOpacityShadow: metres from the first layer's front to the last one's end, > 0. What lies deeper counts to the
  /// last.
  float depth = 0.08f;
  float bias =
      0;  ///< Metres, >= 0: what is nearer to a surface does not shade it. Some of a texel's width comes on top.
};

/// A ball, world, metres: what casts shadows and what may catch them.
struct ShadowBall {
  double center[3] = {};
  /// > 0. The smaller, the finer the shadow; one head with long hair wants some 0.4 times its scale.
  float radius = 0.5f;
};

/// One asset's heads among those that cast shadows.
struct ShadowCrowd {
  const HairModel* model = nullptr;
  std::span<const HairInstance> instances;
  const MaterialRecord* material = nullptr;  ///< As in DrawDesc.
};

/// What one light's way to hair and heads is like: hair shades hair, heads and bodies; the host's solid things shade
/// hair. Each frame: begin(); the host draws what it wants to cast shadows, depth only; draw() adds the hair. Then
/// HairRenderer::draw() shades hair by DrawDesc::shadow, and the host's own shaders look shadows up with code(),
/// uniforms() and the textures. All OpenGL objects are made by create(). The renderer's context must be current in
/// every call. The destructor calls no OpenGL function: call destroy() while the context lives.
class COIF_API HairShadow {
 public:
  static constexpr std::uint32_t kTextures = 4;

  HairShadow() = default;
  HairShadow(const HairShadow&) = delete;
  HairShadow& operator=(const HairShadow&) = delete;

  /// `renderer` must be created and outlive this object. kNotCreated, kBadArgument; kDriver where a function is missing
  /// or there is no memory: see HairRenderer::failure(). A shadow that exists already is destroyed first. Clears
  /// OpenGL's error flags. Leaves the framebuffer binding and the 2D texture of unit 0 empty, and that unit active.
  Status create(HairRenderer& renderer, const GlLoader& loader, const ShadowDesc& desc = {});
  void destroy();
  [[nodiscard]] bool is_created() const;

  /// Aims the map from the light at the ball and clears it. kNotCreated; kBadArgument for a light or a ball out of
  /// range, or a point or spot light within 1.05 radii of the ball's centre: it has no direction then. After these no
  /// OpenGL function has been called and the last map stays.
  ///
  /// Sets, for the host's casters: draw and read framebuffer, to one with a depth buffer alone; the viewport, to all of
  /// it; scissor test and blending off, depth test on with GL_LEQUAL, depth and colour mask on, no face culled; a
  /// polygon offset that grows with the slope.
  Status begin(const Light& light, const ShadowBall& ball);

  /// For the host's casters between begin() and draw(): column-major, OpenGL clip space, from world axes around
  /// `origin` (world, metres). Does not mirror.
  void clip_from_origin(const Vec3& origin, float (&clip)[16]) const;

  /// Draws the hair that casts shadows, once after begin(). kNotCreated; kBadArgument without a begin() before, or for
  /// a material out of range; the errors of HairRenderer::draw() for models and instances. After these nothing has been
  /// drawn.
  ///
  /// State as after HairRenderer::draw(); beside it leaves the framebuffer bindings empty, the viewport as begin() sets
  /// it, scissor test and polygon offset off, 2D texture and sampler of units 0 to 13 empty. The host binds its own
  /// framebuffer next.
  Status draw(std::span<const ShadowCrowd> crowds);

  /// Builds the programs that draw() would have to build first for this asset, drawn with its own or another material.
  Status prepare(const HairModel& model, const MaterialRecord* material = nullptr);

  /// For a host's own fragment shader, GLSL ES 3.00 that defines
  /// - `vec2 hair_slope(vec4 place)`: how the surface lies in the map, `place` being map_from_origin times the point.
  /// By the
  ///   neighbours' values: call it before any discard.
  /// - `float hair_light(vec4 place, vec2 slope, vec4 depth, vec4 map)`: the share 0..1 of the light that reaches the
  /// point.
  ///
  /// The two pieces belong together, before the first use; they are of shaders/hair_shadow.glsl, for maps with
  /// layers after a line with their number. Null before create().
  [[nodiscard]] std::span<const char* const, 2> code() const;

  /// The sampler's name in code() of each of the textures; null where the technique has none. All are 2D.
  [[nodiscard]] const char* sampler(std::uint32_t texture) const;
  [[nodiscard]] std::uint32_t texture(std::uint32_t texture) const;
  [[nodiscard]] ShadowUniforms uniforms(const Vec3& origin) const;

  /// The bytes of all textures together, as they are laid out without padding.
  [[nodiscard]] std::uint64_t bytes() const;
  [[nodiscard]] const ShadowDesc& desc() const;

 private:
  friend struct ShadowState;
  static constexpr std::size_t kStateBytes = 512;

  ShadowState* state_ = nullptr;  ///< In room_, from the first create() on.
  alignas(double) std::byte room_[kStateBytes];
};

}  // namespace coif
