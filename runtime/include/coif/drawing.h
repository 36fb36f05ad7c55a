#pragma once
// What a renderer computes before it calls its graphics interface, whichever that is: what it has to know of an asset,
// which heads are seen and in what order, what its uniform blocks hold. coif::gl stands on this and so can a renderer
// for Vulkan, Direct3D or WebGPU; shaders/README.md says what it has to draw with it. Nothing here allocates or keeps
// what it was given.

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
  Vec3 from;  ///< Where light comes from. kDirectional: the way there, any length > 0. Else the place: world, metres.
  /// Linear; what a white matte surface that faces the light sends out (irradiance over pi). Else than kDirectional: at
  /// one metre, falling with the square of the distance.
  Vec3 color{1, 1, 1};
  Vec3 spot_axis{0, -1, 0};     ///< kSpot: the way it shines, any length > 0.
  float inner_cosine = 0.966f;  ///< kSpot: of the angle to `spot_axis` up to which it has all its light,
  float outer_cosine = 0.866f;  ///< and from which on it has none; -1..1, below the inner one.
  // Between the two it falls with the square of the cosine's way from one to the other, as glTF's KHR_lights_punctual
  // has it.
};

/// What is drawn: parts of the shading, with Algorithm 3 as in the six pictures of the thesis's Gallery 1, or, to check
/// an asset, the strands' direction: green at the root to red at the tip, with arrowheads that point to the tip,
/// without light. With ShadingModel::kMarschner the primary highlight is R and the secondary one TRT; TT is a part of
/// the diffuse light.
enum class Component : std::uint8_t { kAll, kAmbient, kDiffuse, kSpecular, kPrimary, kSecondary, kDirection };

/// One head of a crowd.
struct HairInstance {
  HeadPose head;                   ///< World from head space, its scale included.
  std::span<const Mat34> palette;  ///< From Hair::palette(), head space; as many as the asset has bones.
  /// Level of detail, below the asset's count; only its patches are drawn. See choose_lod() in coif/lod.h.
  std::uint32_t lod = 0;
};

/// Between which values an asset's alpha lies, 0..1, before the material's base colour.
struct AlphaRange {
  float lowest = 1;
  float highest = 1;
};

/// Over all mips of the base texture: what lies between texels, and between mips, lies between their values too. Both 1
/// without that texture. Linear in the texels, ended early where all values occur, as they do in most strand textures.
[[nodiscard]] COIF_API AlphaRange alpha_range_of(const Asset& asset);

/// A ball that hair never leaves, head space, metres.
struct Reach {
  float center[3];
  float radius;
};

/// Bones do not stretch, so however a chain turns, a vertex stays as near to the chain's root as the bones up to it and
/// its own distance from its bone are long. The ball is around the middle of the mesh at rest, of which there must be
/// one.
[[nodiscard]] COIF_API Reach reach_of(const Asset& asset);

/// How vertices hang on bones.
enum class Skinning : std::uint8_t {
  kRigid,    ///< The asset has no chunk SKIN.
  kOneBone,  ///< Every vertex has all its weight on its first bone.
  kFourBones,
};

/// What has to be known of an asset to draw it when it is gone itself: its buffers and textures are on the GPU then.
struct DrawnHair {
  struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  IndexRange lods[kMaxLods];  ///< Each level's indices in the stored order.
  std::uint32_t lod_count = 0;
  std::uint32_t order_count = 0;  ///< Draw orders, one copy of all levels' indices after the other.
  std::uint32_t indices_of_order = 0;
  std::uint32_t index_bytes = 4;  ///< 2 where that is enough, and never the number 0xFFFF, which may restart strips.
  std::uint8_t order_of_view[kViewCells] = {};
  Reach reach{};
  AlphaRange alpha;
  std::uint32_t bone_count = 0;
  Skinning skinning = Skinning::kRigid;
  MaterialRecord material{};  ///< The asset's own, or that of the thesis's Gallery 1 in a brown, double-sided.

  /// The first index of a level in one of the orders.
  [[nodiscard]] std::size_t first_index(std::uint32_t lod, std::uint32_t order) const {
    return std::size_t{order} * indices_of_order + lods[lod].first;
  }
};

/// `asset` is open and has vertices and indices.
[[nodiscard]] COIF_API DrawnHair drawn_hair_of(const Asset& asset);

/// Writes the asset's indices once for each of its draw orders, DrawnHair::index_bytes each: with some orders, indices
/// are most of a mesh. Writes nothing where `out` has not exactly that many bytes.
COIF_API void write_draw_orders(const Asset& asset, const DrawnHair& hair, std::span<std::byte> out);

/// kSizeMismatch when the palette has not one matrix per bone (rigid hair may also have none), kBadArgument for no such
/// level, kBadPose for a NaN, an infinity or a rotation that is no unit quaternion, kBadScale for a scale outside of
/// kSmallestScale..kLargestScale.
[[nodiscard]] COIF_API Status check_instance(const DrawnHair& hair, const HairInstance& instance);

/// Finite, thresholds and shares 0..1, exponents above 0, and what the shading model needs.
[[nodiscard]] COIF_API bool is_valid(const MaterialRecord& material);

/// How the matrices of many heads lie in uniform blocks: PaletteBlock in shaders/README.md.
struct MatrixLayout {
  static constexpr std::uint32_t kRowBytes = 4 * sizeof(float);
  static constexpr std::uint32_t kMatrixRows = 3;

  /// vec4 of each head: its own matrix, then those of its bones; where there are two frames, then the same of the last
  /// frame.
  std::uint32_t rows_of_head = kMatrixRows;
  std::uint32_t frames = 1;          ///< 2: for vectors of motion.
  std::uint32_t heads_of_batch = 1;  ///< Most that one block holds, and so one draw call shows.
  /// The bones are too many for a block: they go into a texture, head by head, and the block has the head's matrix
  /// alone.
  bool bones_in_texture = false;

  [[nodiscard]] std::uint32_t rows_of_frame() const { return rows_of_head / frames; }
  [[nodiscard]] std::uint32_t batch_bytes() const { return heads_of_batch * rows_of_head * kRowBytes; }
};

/// For uniform blocks of so many bytes, 16 KiB or more. `frames`: 1 or 2.
[[nodiscard]] COIF_API MatrixLayout matrix_layout_of(const DrawnHair& hair, std::uint32_t block_bytes,
                                                     std::uint32_t frames = 1);

/// Writes one head's rows_of_frame(), view from head space first, with the head's scale; view space has the world's
/// axes and its origin at the eye.
COIF_API void write_head(const MatrixLayout& layout, const HairInstance& instance, const Vec3& eye, std::byte* to);

/// Where a shader finds its place in a shadow map, beside the textures: for the arguments of hair_light().
struct ShadowUniforms {
  float map_from_origin[16] = {};  ///< Column-major, from world axes around the origin that was asked for.
  float depth[4] = {};
  float map[4] = {};
};

/// The uniform block DrawBlock of the shaders, std140, view space: the world's axes, its origin at the eye.
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
  /// From view space; map[3]: which light it belongs to. For vectors of motion previous_clip_from_view.
  ShadowUniforms shadow;
};
static_assert(sizeof(DrawBlock) == 672);

/// From where and in what light a crowd is seen.
struct DrawView {
  float clip_from_world[16] = {};  ///< Column-major, OpenGL clip space; must not mirror.
  Vec3 eye;                        ///< World, metres.
  std::span<const Light> lights;   ///< At most kMaxLights.
  Component component = Component::kAll;
  bool framebuffer_is_srgb = false;  ///< The target encodes sRGB itself; otherwise the shader does.
};

/// Takes a draw call's world-space values into view space. kBadArgument, with `block` undefined, for values that are
/// not finite or out of their range. `rows_of_head`: MatrixLayout's.
COIF_API Status fill_draw_block(const DrawView& view, const MaterialRecord& material, std::uint32_t rows_of_head,
                                DrawBlock& block);

/// The heads of a crowd that may be in view, in groups of what one draw call can show. Refers to its first two
/// arguments, whose instances have been checked. Heads of a group come in the order given.
class COIF_API VisibleCrowd {
 public:
  struct Group {
    std::uint32_t lod;
    std::uint32_t order;  ///< Which of the draw orders suits the direction that the head is seen from.
    bool operator==(const Group&) const = default;
  };

  /// `clip_from_view` as in DrawBlock.
  VisibleCrowd(const DrawnHair& hair, std::span<const HairInstance> instances, const Vec3& eye,
               const float (&clip_from_view)[16]);

  /// Calls visit(group) for each group that has heads until one returns false, and returns whether none did. Coarse
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

  /// The group's first instance from `first` on; as many as there are instances where there is none.
  [[nodiscard]] std::size_t find(const Group& group, std::size_t first) const;

  /// How many the group has from `first` on; no more than `most` are counted.
  [[nodiscard]] std::uint32_t count(const Group& group, std::size_t first, std::uint32_t most) const;

 private:
  [[nodiscard]] Group group_of(const HairInstance& instance) const;
  [[nodiscard]] bool is_seen(const HairInstance& instance) const;

  const DrawnHair& hair_;
  std::span<const HairInstance> instances_;
  Vec3 eye_;
  float planes_[6][4];  ///< The view's sides. A point p is inside where dot(xyz, p) + w >= 0; xyz unit, or 0 for a
                        ///< plane at infinity.
  std::uint32_t orders_of_lod_[kMaxLods] = {};  ///< Bit k: some head in view is drawn in order k.
};

}  // namespace coif
