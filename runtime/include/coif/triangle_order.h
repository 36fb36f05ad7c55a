#pragma once
// Orders of triangles that are made anew for each head and frame, while the asset's own orders (Asset::orders()) were
// made once, by the cooker, for hair at rest and some movements.

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

/// Says in which order a head's triangles are drawn (DrawDesc::order). A program holds the orders that it names, of
/// which there is one: BoneOrder. Any number of heads and models of one asset may share it, in one thread at a time: it
/// has room for one head's sorting. The asset's own orders take no such object.
class COIF_API TriangleOrder {
 public:
  TriangleOrder(const TriangleOrder&) = delete;
  TriangleOrder& operator=(const TriangleOrder&) = delete;

  [[nodiscard]] bool is_created() const { return write_ != nullptr; }
  /// It was made of an asset with as many bones and indices. Of another asset's heads it would draw nonsense.
  [[nodiscard]] bool fits(const DrawnHair& hair) const {
    return is_created() && bone_count_ == hair.bone_count && indices_of_order_ == hair.indices_of_order;
  }
  /// Writes the triangles of the head's level in the order in which they are to be drawn, seen from `eye` (world,
  /// metres): as many indices as the level has, DrawnHair::index_bytes each. Call it after create(), with a head that
  /// check_instance() lets pass. Allocates nothing.
  void write(const HairInstance& head, const Vec3& eye, std::byte* out) { write_(*this, head, eye, out); }

 protected:
  using Write = void (*)(TriangleOrder& order, const HairInstance& head, const Vec3& eye, std::byte* out);

  TriangleOrder() = default;
  ~TriangleOrder() = default;

  Write write_ = nullptr;
  std::uint32_t bone_count_ = 0;
  std::uint32_t indices_of_order_ = 0;
};

/// Bones sorted while the hair moves (thesis, 8.1, which has it as future work): "the bones could be sorted to give a
/// primary render order of the patches. Each bone could then have a set of patches associated to it, with a static
/// render order." The furthest bone's triangles come first.
///
/// What the thesis leaves open is coif's: a triangle belongs to the bone that moves its corners most, so that a patch
/// along a chain is taken apart at its joints; a bone is where the middle of its triangles' corners at rest is moved by
/// its matrix; within a bone triangles are in the cooked order for the side that the head is seen from. How wrong that
/// is, beside cooked orders: `coif report FILE order`.
///
/// Costs per head: sorting as many numbers as bones have triangles, and copying the level's indices to the GPU. Heads
/// share no draw calls.
class COIF_API BoneOrder final : public TriangleOrder {
 public:
  BoneOrder() = default;

  /// Bytes that create() takes; 0 for an asset that it refuses. Alignment: kAlignment.
  [[nodiscard]] static std::size_t memory_bytes(const Asset& asset);
  static constexpr std::size_t kAlignment = 16;

  /// Takes all it needs from `memory`, which must stay as long as the order; the asset may go. kAssetLacksData without
  /// mesh, bones or SKIN: rigid hair never changes its order; kMemoryTooSmall also for wrong alignment. A failure
  /// leaves what was created before.
  Status create(const Asset& asset, std::span<std::byte> memory);

  /// Bones that have triangles of this level, below the asset's count of levels; 0 before create().
  [[nodiscard]] std::uint32_t bones_of(std::uint32_t lod) const { return levels_[lod].count; }

 private:
  /// A bone's triangles in one level, which lie together.
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
  Key* keys_ = nullptr;           ///< Room for those of one level.
  std::byte* indices_ = nullptr;  ///< Bone by bone, once for each of the asset's orders.
  std::uint8_t order_of_view_[kViewCells] = {};
  std::uint32_t index_bytes_ = 0;
};

}  // namespace coif
