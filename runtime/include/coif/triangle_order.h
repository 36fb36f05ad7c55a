#pragma once
// Orders of triangles that are made anew for each head and frame. The asset's own orders (Asset::orders()) were made
// once, by the cook, for hair at rest and some movements.

#include <coif/asset.h>
#include <coif/drawing.h>
#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>
#include <coif/view_cells.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// Sorts a head's triangles for drawing (DrawDesc::order). There is one kind, BoneOrder; a program that does not name
/// it does not link it. Any number of heads and models of one asset may share an order, in one thread at a time: it has
/// room for one head's sorting. The asset's own orders need no such object.
class COIF_API TriangleOrder {
 public:
  TriangleOrder(const TriangleOrder&) = delete;
  TriangleOrder& operator=(const TriangleOrder&) = delete;

  [[nodiscard]] bool is_created() const { return write_ != nullptr; }
  /// It was made of an asset with as many bones and indices. For another asset's heads it would draw nonsense.
  [[nodiscard]] bool fits(const DrawnHair& hair) const {
    return is_created() && bone_count_ == hair.bone_count && indices_of_order_ == hair.indices_of_order;
  }
  /// Writes the triangles of the head's level in the order in which they are to be drawn, seen from `eye` (world,
  /// metres): as many indices as the level has, DrawnHair::index_bytes each. Needs a created order and a head that
  /// passes check_instance(). Allocates nothing.
  void write(const HairInstance& head, const Vec3& eye, std::byte* out) { write_(*this, head, eye, out); }

 protected:
  using Write = void (*)(TriangleOrder& order, const HairInstance& head, const Vec3& eye, std::byte* out);

  TriangleOrder() = default;
  ~TriangleOrder() = default;

  Write write_ = nullptr;
  std::uint32_t bone_count_ = 0;
  std::uint32_t indices_of_order_ = 0;
};

/// Sorts bones while the hair moves. The thesis (8.1) names it as future work: "the bones could be sorted to give a
/// primary render order of the patches. Each bone could then have a set of patches associated to it, with a static
/// render order." The furthest bone's triangles come first.
///
/// coif decides what the thesis leaves open. A triangle belongs to the bone that moves its corners most, so a patch
/// along a chain is divided at its joints. A bone's place is the middle of its triangles' corners at rest, moved by its
/// matrix. Within a bone triangles are in the cooked order for the side that the head is seen from. The error of this
/// order beside cooked orders: `coif report FILE order`.
///
/// Cost per head: sorting as many numbers as bones have triangles, and copying the level's indices to the GPU. Heads
/// share no draw calls.
class COIF_API BoneOrder final : public TriangleOrder {
 public:
  BoneOrder() = default;

  /// Bytes that create() needs; 0 for an asset that it refuses. Alignment: kAlignment.
  [[nodiscard]] static std::size_t memory_bytes(const Asset& asset);
  static constexpr std::size_t kAlignment = 16;

  /// Uses only `memory`, which must stay as long as the order; the asset may go. kAssetLacksData without mesh, bones or
  /// SKIN (rigid hair never changes its order); kMemoryTooSmall also for a wrong alignment. After a failure the order
  /// created before is still there.
  Status create(const Asset& asset, std::span<std::byte> memory);

  /// The number of bones that have triangles of this level, which must be below the asset's count of levels; 0 before
  /// create().
  [[nodiscard]] std::uint32_t bones_of(std::uint32_t lod) const { return levels_[lod].count; }

 private:
  /// A bone's triangles of one level, which are stored together.
  struct Group {
    Vec3 middle;  ///< At rest.
    std::uint32_t bone;
    std::uint32_t first, count;  ///< Indices.
  };
  struct Key {
    float distance;  ///< Square, metres.
    std::uint32_t group;
  };
  struct Level {
    std::uint32_t first = 0, count = 0;  ///< Groups.
  };
  struct Builder;

  static void write_far_to_near(TriangleOrder& order, const HairInstance& head, const Vec3& eye, std::byte* out);

  Level levels_[kMaxLods];
  Group* groups_ = nullptr;
  Key* keys_ = nullptr;           ///< Room for the keys of one level.
  std::byte* indices_ = nullptr;  ///< Bone by bone, once for each of the asset's orders.
  std::uint8_t order_of_view_[kViewCells] = {};
  std::uint32_t index_bytes_ = 0;
};

}  // namespace coif
