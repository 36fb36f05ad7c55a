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

/// The host's function that finds OpenGL ES functions: eglGetProcAddress or the like. Must return null for unknown
/// names, and live as long as the object that was made with it.
struct GlLoader {
  void* (*get_proc)(const char* name, void* user) = nullptr;
  void* user = nullptr;
};

/// The view, the lights and the way in which a crowd is drawn.
struct DrawDesc {
  float clip_from_world[16] = {};  ///< Column-major, OpenGL clip space; must not mirror (front faces stay front).
  Vec3 eye;                        ///< World, metres.
  std::span<const Light> lights;   ///< At most kMaxLights.
  const SkyLight* sky = nullptr;   ///< Besides the material's own light from everywhere; null: none.
  Component component = Component::kAll;
  /// Replaces the asset's material when not null; must stay valid during the call.
  const MaterialRecord* material = nullptr;
  const TransparencyMode* transparency = &kBlendMode;
  const HairShadow* shadow = nullptr;  ///< Shadow of one of the lights, see coif/shadow.h; null: none.
  std::uint32_t shadowed_light = 0;    ///< Which of `lights` casts `shadow`.
  /// Sorts each head's triangles in each frame (BoneOrder of the model's own asset); null: the asset's own orders. Must
  /// stay valid during the call.
  TriangleOrder* order = nullptr;
  /// The framebuffer encodes sRGB itself (GL_SRGB8_ALPHA8). Otherwise the shader encodes: solid hair looks the same,
  /// but encoded values are blended, which makes soft tips darker. Over an edge whose alpha rises evenly from 0 to 1
  /// the error (PSNR) is 19 dB for light hair before a dark wall, 20 dB for dark hair before a light one, 42 dB for
  /// brown before mid grey and 49 dB for hair over hair of nearly its brightness.
  bool framebuffer_is_srgb = false;
};

/// Sizes of the renderer's buffers, and its variant of OpenGL.
struct RendererDesc {
  /// Size of the stream, the renderer's one buffer for a frame's data, in bytes, 1 MiB..256 MiB. It holds the bone
  /// matrices of all crowds for about three frames: 48 bytes for each bone and head, once for each time that they are
  /// drawn. With DrawDesc::order it also holds the indices of each head's level; a quarter of the stream must have room
  /// for one head's indices and a block of matrices. Where it is too small, draw() waits for the GPU.
  std::uint32_t stream_bytes = 4u << 20;
  /// Most bytes of a uniform block, 16 KiB..64 KiB; less where the driver offers less. A draw call shows as many heads
  /// as have their matrices in one block. An asset with more bones than a block holds is drawn head by head.
  std::uint32_t block_bytes = 64u << 10;
  /// Bytes of kExactMode's lists of soft texels, used where the driver has OpenGL ES 3.1, 64 KiB..1 GiB: 20 for each
  /// soft texel in front of the solid ones. If they do not suffice, kExactMode peels layer by layer, which is far
  /// slower.
  std::uint32_t list_bytes = 64u << 20;
  /// Null: the driver has all of OpenGL ES 3.0. &kWebGl: WebGL 2, without kExactMode and DrawDesc::order.
  const WebGlCode* webgl = nullptr;
  /// With `webgl`: memory in which data is written before it is sent, at least a quarter of stream_bytes, at a multiple
  /// of 4. Must outlive the renderer.
  std::span<std::byte> scratch{};
};

class HairModel;

/// Programs shared by all models of one OpenGL context. Each program is built when the first model that needs it is
/// uploaded, and has only what that model needs. The context must be current in every call. Allocates nothing itself.
/// The destructor calls no OpenGL function: call destroy() while the context lives.
class COIF_API HairRenderer {
 public:
  HairRenderer() = default;
  HairRenderer(const HairRenderer&) = delete;
  HairRenderer& operator=(const HairRenderer&) = delete;

  /// Finds the functions of OpenGL ES 3.0 or later. kBadArgument without get_proc or for a size out of range; kDriver
  /// when a function is missing or there is no memory, see failure(). Destroys an existing renderer first.
  Status create(const GlLoader& loader, const RendererDesc& desc = {});

  /// Frees what create() made. Models of this renderer must have been destroyed before.
  void destroy();

  [[nodiscard]] bool is_created() const;

  /// Draws heads of one asset into the bound framebuffer and viewport, which need a depth buffer. Heads out of view are
  /// left out; all heads with the same level of detail and draw order are drawn together. kBlendMode takes four passes
  /// (thesis 5.3.1), one draw call each: opaque texels; back faces of the rest, blended; its front faces; depth only. A
  /// pass that no texel of the asset can need is left out: hair without transparent texels takes one. Without
  /// kMaterialDoubleSided in the material's flags back faces are not drawn at all, which saves the second pass. The
  /// colour written is premultiplied with alpha. Draw opaque things before, transparent things after.
  ///
  /// Heads are drawn in the order given; where transparent strands of two heads overlap, the further head should come
  /// first. Coarser levels are drawn before finer ones. Except in kExactMode, draw() never waits for the GPU while the
  /// stream is large enough, and never makes or grows an OpenGL object except a missing program.
  ///
  /// With DrawDesc::order each head is drawn by itself in its own order, all passes in turn, from indices that are sent
  /// with its matrices. This binds the stream's buffer as GL_ELEMENT_ARRAY_BUFFER too, which WebGL 2 refuses:
  /// kBadArgument with RendererDesc::webgl.
  ///
  /// kNotCreated without a created renderer and a model uploaded by it; kSizeMismatch unless a palette has one matrix
  /// per bone (hair without SKIN may also have none); kBadPose and kBadScale as check_instance(); kBadArgument for too
  /// many lights, a level that does not exist, a number out of its range, or an order that was made of another asset or
  /// whose indices do not fit into the stream. These errors come before any OpenGL call. kDriver when a missing program
  /// (see prepare()) cannot be built; nothing is drawn then.
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

  /// Builds the programs that draw() with this description would build first. upload() has built those for the asset's
  /// own material. Avoids a pause in the first frame with Component::kDirection, or with a material that needs more
  /// than the asset's own (for example a highlight where the asset's is black). Reads only `material`, `component` and
  /// `transparency`. Errors as draw(); kDriver: see failure().
  Status prepare(const HairModel& model, const DrawDesc& desc);

  /// The number of programs built so far. Models with the same needs share them; they live as long as the renderer.
  [[nodiscard]] std::uint32_t program_count() const;

  /// Why the last call (upload() of a model included) returned kDriver: the missing function's name or the compiler's
  /// log, cut to fit. Never null.
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

  /// Copies mesh and textures to the GPU and builds the programs that the asset needs with its own material and
  /// `transparency`, unless `renderer` has them. The asset may go afterwards. Absent textures count as white, as shift
  /// 0.5 and as mask 1; an absent material is that of the thesis's Gallery 1, double-sided. Textures repeat only where
  /// a vertex's UV leaves 0..1. `renderer` must outlive this model. kNotCreated, kAssetLacksData (no mesh), kDriver
  /// (out of memory, texture too large, shader refused; see HairRenderer::failure()). After a failure the model
  /// uploaded before is still there.
  ///
  /// Clears OpenGL's error flags. Leaves at their initial values: program, vertex array, array buffer, pixel unpack
  /// buffer and the GL_UNPACK parameters, active texture unit, 2D texture of unit 0.
  Status upload(HairRenderer& renderer, const Asset& asset, const TransparencyMode& transparency = kBlendMode);

  /// Frees what upload() made. Does nothing without it.
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
