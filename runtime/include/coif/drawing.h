#pragma once
// What a renderer computes before it calls its graphics interface, whichever that is: the facts of an asset that
// drawing needs, which heads are seen and in what order, and the contents of its uniform blocks. coif::gl is built on
// this, and a renderer for Vulkan, Direct3D or WebGPU can be; shaders/README.md says what to draw with it. Nothing here
// allocates or keeps its arguments.

#include <coif/asset.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>
#include <coif/view_cells.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

inline constexpr std::uint32_t kMaxLights = 8;

struct Light {
  enum class Kind : std::uint8_t { kDirectional, kPoint, kSpot } kind = Kind::kDirectional;
  Vec3 from;  ///< kDirectional: direction towards the light, any length > 0. Else the light's position: world, metres.
  /// Linear; the radiance of a white matte surface that faces the light (irradiance over pi). For point and spot lights
  /// at one metre, falling with the square of the distance.
  Vec3 color{1, 1, 1};
  Vec3 spot_axis{0, -1, 0};  ///< kSpot: the direction in which it shines, any length > 0.
  /// kSpot: cosine of the angle to `spot_axis` up to which the light is full. Up to outer_cosine it falls with the
  /// square of the linear interpolation between the two cosines, as in glTF's KHR_lights_punctual.
  float inner_cosine = 0.966f;
  float outer_cosine = 0.866f;  ///< kSpot: cosine from which on there is no light; -1..1, below inner_cosine.
};

/// Light from everywhere, from each direction another: spherical harmonics of its radiance (linear; world axes) up to
/// degree two, in the order 1, y, z, x, xy, yz, 3zz - 1, xz, xx - yy, orthonormal, with positive factors: as three.js's
/// LightProbe has them. What a sky needs to light matte things (Ramamoorthi and Hanrahan 2001), and hair nearly so.
struct SkyLight {
  static constexpr std::uint32_t kHarmonics = 9;
  Vec3 harmonics[kHarmonics];
};

/// The part of the shading that is drawn. The parts of Algorithm 3 are as in the six pictures of the thesis's Gallery
/// 1. With ShadingModel::kMarschner and kVolume the primary highlight is R and the secondary one TRT; TT is a part of
/// the diffuse light. kDirection draws the strands' direction without light, to check an asset: green at the root to
/// red at the tip, with arrowheads that point to the tip.
enum class Component : std::uint8_t { kAll, kAmbient, kDiffuse, kSpecular, kPrimary, kSecondary, kDirection };

/// One head of a crowd.
struct HairInstance {
  HeadPose head;                   ///< World from head space, its scale included.
  std::span<const Mat34> palette;  ///< From Hair::palette(), head space; one matrix for each of the asset's bones.
  /// Level of detail, below the asset's count; only its patches are drawn. See choose_lod() in coif/lod.h.
  std::uint32_t lod = 0;
};

/// The range of an asset's alpha, 0..1, before the material's base colour.
struct AlphaRange {
  float lowest = 1;
  float highest = 1;
};

/// The range over all mips of the base texture; filtered values lie between these values too. Both are 1 without that
/// texture. Linear in the texels, but ends as soon as all values have occurred, as in most strand textures.
[[nodiscard]] COIF_API AlphaRange alpha_range_of(const Asset& asset);

/// A ball that hair never leaves, head space, metres.
struct Reach {
  float center[3];
  float radius;
};

/// Bones do not stretch. So however a chain turns, a vertex's distance from the chain's root is at most the length of
/// the bones up to it plus its own distance from its bone. The ball is around the middle of the mesh at rest; the asset
/// must have a mesh.
[[nodiscard]] COIF_API Reach reach_of(const Asset& asset);

/// How vertices hang on bones.
enum class Skinning : std::uint8_t {
  kRigid,    ///< The asset has no chunk SKIN.
  kOneBone,  ///< Every vertex has all its weight on its first bone.
  kFourBones,
};

/// Everything that drawing needs of an asset once its buffers and textures are on the GPU; the asset may go then.
struct DrawnHair {
  struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  IndexRange lods[kMaxLods];  ///< Each level's indices in the stored order.
  std::uint32_t lod_count = 0;
  std::uint32_t order_count = 0;  ///< Draw orders: each has a copy of all levels' indices.
  std::uint32_t indices_of_order = 0;
  /// 2 where that suffices, else 4. With 2 the number 0xFFFF never occurs, since it may restart strips.
  std::uint32_t index_bytes = 4;
  std::uint8_t order_of_view[kViewCells] = {};
  Reach reach{};
  AlphaRange alpha;
  std::uint32_t bone_count = 0;
  Skinning skinning = Skinning::kRigid;
  /// The asset's own. Without one: that of the thesis's Gallery 1 in a brown, double-sided.
  MaterialRecord material{};

  /// The first index of a level in one of the orders.
  [[nodiscard]] std::size_t first_index(std::uint32_t lod, std::uint32_t order) const {
    return std::size_t{order} * indices_of_order + lods[lod].first;
  }
};

/// `asset` must be open and have vertices and indices.
[[nodiscard]] COIF_API DrawnHair drawn_hair_of(const Asset& asset);

/// Writes the asset's indices once for each of its draw orders, DrawnHair::index_bytes each. With several orders
/// indices are most of a mesh. Writes nothing unless `out` has exactly that many bytes.
COIF_API void write_draw_orders(const Asset& asset, const DrawnHair& hair, std::span<std::byte> out);

/// kSizeMismatch unless the palette has one matrix per bone (rigid hair may also have none), kBadArgument for a level
/// that the asset does not have, kBadPose for a NaN, an infinity or a rotation that is not a unit quaternion, kBadScale
/// for a scale outside kSmallestScale..kLargestScale.
[[nodiscard]] COIF_API Status check_instance(const DrawnHair& hair, const HairInstance& instance);

/// All values are finite, thresholds and shares 0..1, exponents above 0, and the shading model's numbers in their
/// ranges.
[[nodiscard]] COIF_API bool is_valid(const MaterialRecord& material);

/// How the matrices of many heads are arranged in uniform blocks: PaletteBlock in shaders/README.md.
struct MatrixLayout {
  static constexpr std::uint32_t kRowBytes = 4 * sizeof(float);
  static constexpr std::uint32_t kMatrixRows = 3;

  /// The vec4 of each head: its own matrix, then those of its bones; with two frames, then the same of the last frame.
  std::uint32_t rows_of_head = kMatrixRows;
  std::uint32_t frames = 1;          ///< 2: for motion vectors.
  std::uint32_t heads_of_batch = 1;  ///< The most heads that one block holds, and so that one draw call shows.
  /// The bones do not fit into a block. They go into a texture, head by head, and the block has the head's matrix
  /// alone.
  bool bones_in_texture = false;

  [[nodiscard]] std::uint32_t rows_of_frame() const { return rows_of_head / frames; }
  [[nodiscard]] std::uint32_t batch_bytes() const { return heads_of_batch * rows_of_head * kRowBytes; }
};

/// `block_bytes`: bytes of a uniform block, 16 KiB or more. `frames`: 1 or 2.
[[nodiscard]] COIF_API MatrixLayout matrix_layout_of(const DrawnHair& hair, std::uint32_t block_bytes,
                                                     std::uint32_t frames = 1);

/// Writes one head's rows_of_frame() rows, first the transform from head space to view space with the head's scale.
/// View space has the world's axes and its origin at the eye.
COIF_API void write_head(const MatrixLayout& layout, const HairInstance& instance, const Vec3& eye, std::byte* to);

/// Uniforms by which a shader finds its place in a shadow map, the arguments of hair_light(). The textures come
/// separately.
struct ShadowUniforms {
  float map_from_origin[16] = {};  ///< Column-major, from world axes around the origin given to HairShadow::uniforms().
  float depth[4] = {};
  float map[4] = {};
};

/// The uniform block DrawBlock of the shaders, std140. View space has the world's axes and its origin at the eye.
struct alignas(16) DrawBlock {
  float clip_from_view[16];
  float base_color[4];
  float ambient[4];
  float primary[4];
  float secondary[4];
  float shift[4];
  float component[4];
  float fiber[4];
  float strands[4];
  float light_position[kMaxLights][4];
  float light_color[kMaxLights][4];
  float light_spot[kMaxLights][4];
  /// By which powers of a normal are multiplied for the radiance of a white matte surface; [0][3]: 1 if there is a sky.
  float sky[SkyLight::kHarmonics][4];
  /// From view space; map[3]: the index of its light. For motion vectors previous_clip_from_view.
  ShadowUniforms shadow;
};
static_assert(sizeof(DrawBlock) == 816);

/// The view and the lights of a crowd.
struct DrawView {
  float clip_from_world[16] = {};  ///< Column-major, OpenGL clip space; must not mirror.
  Vec3 eye;                        ///< World, metres.
  std::span<const Light> lights;   ///< At most kMaxLights.
  const SkyLight* sky = nullptr;   ///< Besides the material's own light from everywhere; null: none.
  Component component = Component::kAll;
  bool framebuffer_is_srgb = false;  ///< The target encodes sRGB itself; otherwise the shader does.
};

/// Takes a draw call's world-space values into view space. kBadArgument, with `block` undefined, for values that are
/// not finite or out of their range. `rows_of_head` as in MatrixLayout.
COIF_API Status fill_draw_block(const DrawView& view, const MaterialRecord& material, std::uint32_t rows_of_head,
                                DrawBlock& block);

/// Groups the heads of a crowd that may be in view, so that one draw call can show a group. Keeps references to `hair`
/// and `instances`, which must have passed check_instance(). Heads of a group keep their order.
class COIF_API VisibleCrowd {
 public:
  struct Group {
    std::uint32_t lod;
    std::uint32_t order;  ///< The draw order that suits the direction that the head is seen from.
    bool operator==(const Group&) const = default;
  };

  /// `clip_from_view` as in DrawBlock.
  VisibleCrowd(const DrawnHair& hair, std::span<const HairInstance> instances, const Vec3& eye,
               const float (&clip_from_view)[16]);

  /// Calls visit(group) for each group that has heads until one call returns false; returns whether none did. Coarse
  /// levels come first, since they are far away.
  template <typename Visit>
  bool for_each_group(const Visit& visit) const {
    for (std::uint32_t lod = kMaxLods; lod-- > 0;) {
      for (std::uint32_t orders = orders_of_lod_[lod]; orders != 0; orders &= orders - 1) {
        if (!visit(Group{lod, std::uint32_t(std::countr_zero(orders))})) return false;
      }
    }
    return true;
  }

  /// The index of the group's first instance from `first` on; the number of instances where there is none.
  [[nodiscard]] std::size_t find(const Group& group, std::size_t first) const;

  /// How many instances the group has from `first` on; counts up to `most`.
  [[nodiscard]] std::uint32_t count(const Group& group, std::size_t first, std::uint32_t most) const;

 private:
  [[nodiscard]] Group group_of(const HairInstance& instance) const;
  [[nodiscard]] bool is_seen(const HairInstance& instance) const;

  const DrawnHair& hair_;
  std::span<const HairInstance> instances_;
  Vec3 eye_;
  /// The sides of the view. A point p is inside where dot(xyz, p) + w >= 0; xyz is unit, or 0 for a plane at infinity.
  float planes_[6][4];
  std::uint32_t orders_of_lod_[kMaxLods] = {};  ///< Bit k: some head in view is drawn in order k.
};

}  // namespace coif
