#pragma once

#include <coif/asset.h>
#include <coif/drawing.h>
#include <coif/export.h>
#include <coif/status.h>
#include <coif/transparency.h>
#include <coif/triangle_order.h>
#include <coif/webgl.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

class HairShadow;
struct ModelState;
struct RendererState;

/// The host's way to find an OpenGL ES function: eglGetProcAddress or the like. Must return null for unknown names, and
/// live as long as what was made with it.
struct GlLoader {
  void* (*get_proc)(const char* name, void* user) = nullptr;
  void* user = nullptr;
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
  /// Makes each head's order of triangles anew, of the model's own asset (BoneOrder); null: the asset's own orders.
  /// Must stay valid during the call.
  TriangleOrder* order = nullptr;
  /// The framebuffer encodes sRGB itself (GL_SRGB8_ALPHA8). Otherwise the shader encodes: solid hair looks the same,
  /// but blending happens between encoded values, which makes soft tips darker. Over an edge whose alpha rises evenly
  /// from 0 to 1 that is an error (PSNR) of 19 dB for light hair before a dark wall, 20 dB for dark hair before a light
  /// one, 42 dB for brown before mid grey and 49 dB for hair over hair of nearly its brightness.
  bool framebuffer_is_srgb = false;
};

/// What the renderer's one buffer for a frame's data is like.
struct RendererDesc {
  /// Bytes, 1 MiB..256 MiB. Holds the bone matrices of all crowds of some three frames: 48 bytes for each bone and
  /// head, and as much again for each time they are drawn; with DrawDesc::order also the indices of each head's level,
  /// of which a quarter of the stream has to hold one head's with a block of matrices. Where it is too small, draw()
  /// waits for the GPU.
  std::uint32_t stream_bytes = 4u << 20;
  /// Most bytes of a uniform block, 16 KiB..64 KiB; less where the driver offers less. A draw call shows as many heads
  /// as have their matrices in one block; an asset with more bones than a block holds is drawn head by head.
  std::uint32_t block_bytes = 64u << 10;
  /// Bytes that kExactMode takes for lists of soft texels where the driver has OpenGL ES 3.1, 64 KiB..1 GiB: 20 for
  /// each that is in front of what is solid. It peels layer by layer where they are too few, which is slower by far.
  std::uint32_t list_bytes = 64u << 20;
  /// Null: the driver has all of OpenGL ES 3.0. &kWebGl for WebGL 2, where kExactMode and DrawDesc::order are not to be
  /// had.
  const WebGlCode* webgl = nullptr;
  /// With `webgl`: at least a quarter of stream_bytes, at a multiple of 4, written before it is sent. Must outlive the
  /// renderer.
  std::span<std::byte> scratch{};
};

class HairModel;

/// Programs shared by all models of one OpenGL context. Each is built when the first model that needs it is uploaded,
/// and does only what that model needs. The context must be current in every call. Allocates nothing itself. The
/// destructor calls no OpenGL function: call destroy() while the context lives.
class COIF_API HairRenderer {
 public:
  HairRenderer() = default;
  HairRenderer(const HairRenderer&) = delete;
  HairRenderer& operator=(const HairRenderer&) = delete;

  /// Finds the functions; OpenGL ES 3.0 or later. kBadArgument without get_proc or for a size out of range; kDriver
  /// when a function is missing or there is no memory, see failure(). A renderer that exists already is destroyed
  /// first.
  Status create(const GlLoader& loader, const RendererDesc& desc = {});

  /// Frees what create() made. Models of this renderer must have been destroyed before.
  void destroy();

  [[nodiscard]] bool is_created() const;

  /// Draws heads of one asset into the bound framebuffer and viewport, which need a depth buffer: those that may be in
  /// view, all that share a level of detail and a draw order at once. kBlendMode takes four passes (thesis 5.3.1), one
  /// draw call each: opaque texels; back faces of the rest, blended; its front faces; depth only. A pass that no texel
  /// of the asset can be in is left out: hair without transparent texels takes one. Without kMaterialDoubleSided in the
  /// material's flags back faces are not drawn at all, which saves the second pass. Colour leaves premultiplied with
  /// alpha. Draw what is opaque before, what is transparent after.
  ///
  /// Heads are drawn in the order given; where transparent strands of two heads overlap, the further one should come
  /// first. Coarser levels are drawn before finer ones. Never waits for the GPU while the stream is large enough, and
  /// never makes or grows an OpenGL object but a missing program. (Neither is true of kExactMode.)
  ///
  /// With DrawDesc::order each head is drawn by itself with its own order, all passes in turn, from indices that are
  /// sent with its matrices: the stream's buffer is then bound as GL_ELEMENT_ARRAY_BUFFER too, which WebGL 2 refuses:
  /// kBadArgument with RendererDesc::webgl.
  ///
  /// kNotCreated without a created renderer and an uploaded model of it; kSizeMismatch when a palette has not one
  /// matrix per bone (hair without SKIN may also have none); kBadPose and kBadScale as check_instance(); kBadArgument
  /// for too many lights, no such level or a number out of its range, an order that was not made of such an asset or
  /// whose indices the stream has no room for. After these no OpenGL function has been called. kDriver when a program
  /// was missing, see prepare(), and is refused; nothing is drawn then.
  ///
  /// Sets, and leaves at OpenGL's initial value: program, vertex array, active texture unit; where the asset has them,
  /// 2D texture and sampler of units 0 (base colour), 1 (shift and mask), 9 (normals) and 10 (strands); uniform buffer
  /// binding and its indices 0 and 1; GL_BLEND, blend function and equation; GL_DEPTH_TEST, depth function and mask;
  /// GL_CULL_FACE, cull face and front face; colour mask. With more bones than a block holds, whose matrices go into a
  /// texture, also 2D texture and sampler of unit 2, pixel unpack buffer, GL_UNPACK parameters; with a shadow 2D
  /// texture and sampler of units 3 to 6. kCoverageMode also GL_SAMPLE_ALPHA_TO_COVERAGE; kExactMode the shader storage
  /// buffer binding and its indices 0 and 1, or 2D texture and sampler of units 7 and 8. Nothing else changes. Scissor,
  /// stencil, polygon offset, alpha to coverage and the like apply as the host left them. Never calls glGetError, but
  /// for kExactMode.
  Status draw(const HairModel& model, std::span<const HairInstance> instances, const DrawDesc& desc);

  /// Builds those programs that draw() with this description would have to build first. An asset drawn with its own
  /// material has them since upload(). Spares a pause in the first frame with Component::kDirection, or with a material
  /// that asks for more than the asset's own (a highlight where that one's is black). Looks at `material`, `component`
  /// and `transparency` alone. Errors as draw()'s; kDriver: see failure().
  Status prepare(const HairModel& model, const DrawDesc& desc);

  /// Programs built so far. Models that need the same share them; they live as long as the renderer.
  [[nodiscard]] std::uint32_t program_count() const;

  /// Why the last call, a model's upload() too, returned kDriver: the missing function's name or the compiler's log,
  /// cut to fit. Never null.
  [[nodiscard]] const char* failure() const;

 private:
  friend struct RendererState;
  static constexpr std::size_t kStateBytes = 5 << 10;

  RendererState* state_ = nullptr;  ///< In room_, from the first create() on.
  alignas(void*) std::byte room_[kStateBytes];
};

/// One asset's buffers and textures on the GPU. Any number of heads may be drawn from one model. The destructor calls
/// no OpenGL function: call destroy() while the context lives.
class COIF_API HairModel {
 public:
  HairModel() = default;
  HairModel(const HairModel&) = delete;
  HairModel& operator=(const HairModel&) = delete;

  /// Copies mesh and textures to the GPU and builds the programs that the asset needs, drawn with its own material in
  /// this way, and that `renderer` lacks; afterwards the asset may go. Absent textures count as white, as shift 0.5 and
  /// as mask 1, an absent material is that of the thesis's Gallery 1, double-sided. Textures repeat only where a
  /// vertex's UV leaves 0..1. `renderer` must outlive this model. kNotCreated, kAssetLacksData (no mesh), kDriver (out
  /// of memory, texture too large, shader refused; see HairRenderer::failure()); a failure leaves what was uploaded
  /// before.
  ///
  /// Clears OpenGL's error flags. Leaves at their initial values: program, vertex array, array buffer, pixel unpack
  /// buffer and the GL_UNPACK parameters, active texture unit, 2D texture of unit 0.
  Status upload(HairRenderer& renderer, const Asset& asset, const TransparencyMode& transparency = kBlendMode);

  /// Frees what upload() made. Harmless when there is nothing.
  void destroy();

  [[nodiscard]] bool is_uploaded() const { return state_ != nullptr; }
  [[nodiscard]] std::uint32_t bone_count() const;
  /// 1 for an asset without levels of detail, 0 before upload().
  [[nodiscard]] std::uint32_t lod_count() const;
  [[nodiscard]] const MaterialRecord& material() const;

 private:
  friend struct ModelState;
  static constexpr std::size_t kStateBytes = 512;

  ModelState* state_ = nullptr;  ///< In room_; null: nothing is uploaded.
  alignas(void*) std::byte room_[kStateBytes];
};

}  // namespace coif
