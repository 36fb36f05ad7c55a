#pragma once

#include <coif/asset.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>
#include <coif/transparency.h>
#include <coif/view_cells.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

class CrowdDraw;
class HairShadow;
class PassList;
struct GlFunctions;

/// The host's way to find an OpenGL ES function: eglGetProcAddress or the like. Must return null for unknown names, and
/// live as long as what was made with it.
struct GlLoader {
  void* (*get_proc)(const char* name, void* user) = nullptr;
  void* user = nullptr;
};

inline constexpr std::uint32_t kMaxLights = 8;

struct Light {
  enum class Kind : std::uint8_t { kDirectional, kPoint, kSpot } kind = Kind::kDirectional;
  Vec3 position;             ///< kDirectional: towards the light, any length > 0. Else: world, metres.
  /// Linear; what a white matte surface that faces the light sends out (irradiance over pi). Else than kDirectional: at
  /// one metre, falling with the square of the distance.
  Vec3 color{1, 1, 1};
  Vec3 direction{0, -1, 0};  ///< kSpot: the way it shines, any length > 0.
  float inner_cosine = 0.966f;  ///< kSpot: of the angle to `direction` up to which it has all its light,
  float outer_cosine = 0.866f;  ///< and from which on it has none; -1..1, below the inner one.
  // Between the two it falls with the square of the cosine's way from one to the other, as glTF's KHR_lights_punctual has it.
};

/// What is drawn: parts of the shading, with Algorithm 3 as in the six pictures of the thesis's Gallery 1, or, to check an
/// asset, the strands' direction: green at the root to red at the tip, with arrowheads that point to the tip, without light.
/// With ShadingModel::kMarschner the primary highlight is R and the secondary one TRT; TT is a part of the diffuse light.
enum class Component : std::uint8_t { kAll, kAmbient, kDiffuse, kSpecular, kPrimary, kSecondary, kDirection };

/// One head of a crowd.
struct HairInstance {
  HeadPose head;                   ///< World from head space.
  std::span<const Mat34> palette;  ///< From Hair::palette(); as many as the asset has bones.
  /// Level of detail, below HairModel::lod_count(); only its patches are drawn. See choose_lod() in coif/lod.h.
  std::uint32_t lod = 0;
};

/// From where, in what light and how a crowd is drawn.
struct DrawDesc {
  float clip_from_world[16] = {};  ///< Column-major, OpenGL clip space; must not mirror (front faces stay front).
  Vec3 eye;                        ///< World, metres.
  std::span<const Light> lights;   ///< At most kMaxLights.
  Component component = Component::kAll;
  /// Replaces the asset's material when not null; must stay valid during the call.
  const MaterialRecord* material = nullptr;
  const TransparencyMode* transparency = &kBlendMode;
  const HairShadow* shadow = nullptr;  ///< Drawn for one of the lights, see coif/shadow.h; null: none.
  std::uint32_t shadowed_light = 0;    ///< Which of `lights` that is.
  /// The framebuffer encodes sRGB itself (GL_SRGB8_ALPHA8). Otherwise the shader encodes: solid hair looks the same, but
  /// blending happens between encoded values, which makes soft tips darker. Over an edge whose alpha rises evenly from 0
  /// to 1 that is an error (PSNR) of 19 dB for light hair before a dark wall, 20 dB for dark hair before a light one, 42 dB
  /// for brown before mid grey and 49 dB for hair over hair of nearly its brightness.
  bool framebuffer_is_srgb = false;
};

/// What the renderer's one buffer for a frame's data is like.
struct RendererDesc {
  /// Bytes, 1 MiB..256 MiB. Holds the bone matrices of all crowds of some three frames: 48 bytes for each bone and head,
  /// and as much again for each time they are drawn. Where it is too small, draw() waits for the GPU.
  std::uint32_t stream_bytes = 4u << 20;
  /// Most bytes of a uniform block, 16 KiB..64 KiB; less where the driver offers less. A draw call shows as many heads as
  /// have their matrices in one block; an asset with more bones than a block holds is drawn head by head.
  std::uint32_t block_bytes = 64u << 10;
  /// Bytes that kExactMode takes for lists of soft texels where the driver has OpenGL ES 3.1, 64 KiB..1 GiB: 20 for each
  /// that is in front of what is solid. It peels layer by layer where they are too few, which is slower by far.
  std::uint32_t list_bytes = 64u << 20;
};

class HairModel;

/// A renderer's own: the buffer that it writes round and round, so that nothing the GPU still reads is overwritten.
struct StreamState {
  static constexpr std::uint32_t kParts = 4;
  std::uint32_t buffer = 0;
  std::uint32_t bytes = 0;
  std::uint32_t cursor = 0;
  std::uint32_t alignment = 1;  ///< Of what a uniform block may be bound to.
  void* fences[kParts] = {};    ///< Behind the last use of each part, until it is written again.
};

/// A renderer's own: objects of the way to draw that needs some, kExactMode, from its first draw on.
struct ModeMemory {
  alignas(void*) std::byte bytes[512] = {};
  void (*release)(const GlFunctions& gl, ModeMemory& memory) = nullptr;  ///< Null: there is nothing.
};

/// Programs shared by all models of one OpenGL context. Each is built when the first model that needs it is uploaded,
/// and does only what that model needs. The context must be current in every call. Allocates nothing itself. The
/// destructor calls no OpenGL function: call destroy() while the context lives.
class COIF_API HairRenderer {
 public:
  HairRenderer() = default;
  HairRenderer(const HairRenderer&) = delete;
  HairRenderer& operator=(const HairRenderer&) = delete;

  /// Finds the functions; OpenGL ES 3.0 or later. kBadArgument without get_proc or for a size out of range; kDriver when
  /// a function is missing or there is no memory, see failure(). A renderer that exists already is destroyed first.
  Status create(const GlLoader& loader, const RendererDesc& desc = {});

  /// Frees what create() made. Models of this renderer must have been destroyed before.
  void destroy();

  [[nodiscard]] bool is_created() const { return created_; }

  /// Draws heads of one asset into the bound framebuffer and viewport, which need a depth buffer: those that may be in
  /// view, all that share a level of detail and a draw order at once. kBlendMode takes four passes (thesis 5.3.1), one draw
  /// call each: opaque texels; back faces of the rest, blended; its front faces; depth only. A pass that no texel of the
  /// asset can be in is left out: hair without transparent texels takes one. Without kMaterialDoubleSided in the
  /// material's flags back faces are not drawn at all, which saves the second pass. Colour leaves premultiplied with
  /// alpha. Draw what is opaque before, what is transparent after.
  ///
  /// Heads are drawn in the order given; where transparent strands of two heads overlap, the further one should come
  /// first. Coarser levels are drawn before finer ones. Never waits for the GPU while the stream is large enough, and
  /// never makes or grows an OpenGL object but a missing program. (Neither is true of kExactMode.)
  ///
  /// kNotCreated without a created renderer and an uploaded model of it; kSizeMismatch when a palette has not one
  /// matrix per bone (hair without SKIN may also have none); kBadPose; kBadArgument for too many lights, no such level
  /// or a number out of its range. After these no OpenGL function has been called. kDriver when a program was missing,
  /// see prepare(), and is refused; nothing is drawn then.
  ///
  /// Sets, and leaves at OpenGL's initial value: program, vertex array, active texture unit; where the asset has them,
  /// 2D texture and sampler of units 0 (base colour) and 1 (shift and mask); uniform buffer binding and its indices 0
  /// and 1; GL_BLEND, blend function and equation; GL_DEPTH_TEST, depth function and mask; GL_CULL_FACE, cull face and
  /// front face; colour mask. With more bones than a block holds, whose matrices go into a texture, also 2D texture and
  /// sampler of unit 2, pixel unpack buffer, GL_UNPACK parameters; with a shadow 2D texture and sampler of units 3 to 6.
  /// kCoverageMode also GL_SAMPLE_ALPHA_TO_COVERAGE; kExactMode the shader storage buffer binding and its indices 0 and 1,
  /// or 2D texture and sampler of units 7 and 8. Nothing else changes. Scissor, stencil, polygon offset, alpha to coverage
  /// and the like apply as the host left them. Never calls glGetError, but for kExactMode.
  Status draw(const HairModel& model, std::span<const HairInstance> instances, const DrawDesc& desc);

  /// Builds those programs that draw() with this description would have to build first. An asset drawn with its own
  /// material has them since upload(). Spares a pause in the first frame with Component::kDirection, or with a material
  /// that asks for more than the asset's own (a highlight where that one's is black). Looks at `material`, `component`
  /// and `transparency` alone. Errors as draw()'s; kDriver: see failure().
  Status prepare(const HairModel& model, const DrawDesc& desc);

  /// Programs built so far. Models that need the same share them; they live as long as the renderer.
  [[nodiscard]] std::uint32_t program_count() const { return program_count_; }

  /// Why the last call, a model's upload() too, returned kDriver: the missing function's name or the compiler's log,
  /// cut to fit. Never null.
  [[nodiscard]] const char* failure() const { return failure_; }

 private:
  friend class HairModel;
  friend class HairShadow;
  friend class CrowdDraw;
  static constexpr std::size_t kFunctionBytes = 128 * sizeof(void*);
  static constexpr std::size_t kFailureBytes = 512;
  static constexpr std::uint32_t kMaxPrograms = 256;  ///< A game has some dozens.

  struct Program {
    std::uint32_t variant = 0;
    std::uint32_t name = 0;
    std::int32_t alpha_range = -1;  ///< Uniform location.
  };

  [[nodiscard]] const GlFunctions& functions() const;
  [[nodiscard]] const Program* find_program(std::uint32_t variant) const;
  Status build_missing(const PassList& passes, std::uint32_t needs, const MaterialRecord& material,
                       Component component);
  void bind(const HairModel& model, const HairShadow* shadow) const;
  void unbind(const HairModel& model, const HairShadow* shadow) const;

  /// A GlFunctions; its type would bring OpenGL's header to whoever includes this one.
  alignas(void*) std::byte functions_[kFunctionBytes] = {};
  char failure_[kFailureBytes] = {};
  Program programs_[kMaxPrograms];
  std::uint32_t program_count_ = 0;
  StreamState stream_;
  GlLoader loader_;
  ModeMemory mode_memory_;
  std::uint32_t storage_blocks_ = 0;  ///< That fragment shaders may write to.
  std::uint32_t list_bytes_ = 0;
  std::uint32_t block_bytes_ = 0;  ///< Of the matrices' uniform block.
  bool created_ = false;
};

/// One asset's buffers and textures on the GPU. Any number of heads may be drawn from one model. The destructor calls
/// no OpenGL function: call destroy() while the context lives.
class COIF_API HairModel {
 public:
  HairModel() = default;
  HairModel(const HairModel&) = delete;
  HairModel& operator=(const HairModel&) = delete;

  /// Copies mesh and textures to the GPU and builds the programs that the asset needs, drawn with its own material in
  /// this way, and that `renderer` lacks; afterwards the asset may go. Absent textures count as white, as shift 0.5 and as mask 1, an absent material is
  /// that of the thesis's Gallery 1, double-sided. Textures repeat only where a vertex's UV leaves 0..1. `renderer`
  /// must outlive this model. kNotCreated, kAssetLacksData (no mesh), kDriver (out of memory, texture too large, shader
  /// refused; see HairRenderer::failure()); a failure leaves what was uploaded before.
  ///
  /// Clears OpenGL's error flags. Leaves at their initial values: program, vertex array, array buffer, pixel unpack
  /// buffer and the GL_UNPACK parameters, active texture unit, 2D texture of unit 0.
  Status upload(HairRenderer& renderer, const Asset& asset, const TransparencyMode& transparency = kBlendMode);

  /// Frees what upload() made. Harmless when there is nothing.
  void destroy();

  [[nodiscard]] bool is_uploaded() const { return renderer_ != nullptr; }
  [[nodiscard]] std::uint32_t bone_count() const { return bone_count_; }
  /// 1 for an asset without levels of detail, 0 before upload().
  [[nodiscard]] std::uint32_t lod_count() const { return lod_count_; }
  [[nodiscard]] const MaterialRecord& material() const { return material_; }

 private:
  friend class HairRenderer;
  friend class HairShadow;
  friend class CrowdDraw;

  struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  HairModel& operator=(HairModel&&) = default;
  [[nodiscard]] Status check(const HairInstance& instance) const;
  void learn(const Asset& asset, std::uint32_t block_bytes);
  void upload_mesh(const GlFunctions& gl, const Asset& asset);
  bool upload_indices(const GlFunctions& gl, const Asset& asset);
  void release(const GlFunctions& gl);

  const HairRenderer* renderer_ = nullptr;
  std::uint32_t vertex_array_ = 0;
  std::uint32_t vertex_buffer_ = 0;
  std::uint32_t index_buffer_ = 0;
  std::uint32_t base_texture_ = 0;
  std::uint32_t shift_mask_texture_ = 0;
  std::uint32_t palette_texture_ = 0;  ///< 0: matrices fit into a block.
  std::uint32_t index_type_ = 0;
  std::uint32_t index_bytes_ = 0;
  IndexRange lods_[kMaxLods];  ///< Of the stored order.
  std::uint32_t lod_count_ = 0;
  std::uint32_t order_count_ = 0;  ///< Draw orders, one copy of all levels' indices after the other.
  std::uint32_t indices_of_order_ = 0;
  std::uint8_t order_of_view_[kViewCells] = {};
  float reach_center_[3] = {};  ///< Head space, metres: no vertex is ever further from here
  float reach_ = 0;             ///< than this, however bones turn.
  std::uint32_t bone_count_ = 0;
  std::uint32_t needs_ = 0;  ///< What programs must do for this asset, whatever its material: bits of `variant`.
  float lowest_alpha_ = 0;   ///< Of the base texture.
  float highest_alpha_ = 1;
  MaterialRecord material_{};
};

}  // namespace coif
