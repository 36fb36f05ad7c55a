#pragma once
// Chains of several heads side by side, whatever their assets: the order kShared.
//
// A *shape* describes chains that may stand side by side. The lanes of its chains lie in *bundles* of sixteen; a bundle
// is stepped like a row (row.h). Chains of one shape may differ in length: longer ones come first, so that hardly any
// bundle has lanes that end before others. Each treatment has bundles of its own. A head that is idle keeps its numbers
// itself.

#include "../world_heads.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// Sixteen chains of one shape. Arrays have an entry for each bone of the shape; see fill_missing_bones().
struct Bundle {
  Bundle* previous = nullptr;
  Bundle* next = nullptr;
  std::uint32_t count = 0;
  std::uint32_t version = 0;  ///< Crowd::versions of the coefficients of all lanes; 0: some are missing.
  std::uint32_t longest = 0;  ///< Bones of the longest chain; valid unless is_loose is set.
  bool is_loose = false;  ///< Lanes have come or gone: `bones` must be updated to the features of the present lanes.
  bool has_all_bones = false;  ///< fill_missing_bones() has run.
  Treatment treatment;         ///< In the present step.
  std::uint32_t head[kLanes] = {};
  std::uint32_t chain[kLanes] = {};  ///< Chain number in the head's asset.
  RowBone* bones = nullptr;
  BoneLanes* constants = nullptr;
  LimitLanes* limits = nullptr;  ///< Null where no bone has a limit.
  std::byte* coefficients = nullptr;
  std::byte* state = nullptr;
  TwistState* twist = nullptr;         ///< Null where nothing twists.
  PoseLanes* poses = nullptr;          ///< Null where no poses are followed.
  std::uint32_t* body_sets = nullptr;  ///< Per lane too; null where no body is followed.
  std::byte* scratch = nullptr;        ///< Null where it is on the stack.
  Lanes motion{};                      ///< See RowStep; in the last part of the step.
};

/// Number of lengths in one shape: the longest, one bone shorter, and so on.
inline constexpr std::uint32_t kLengths = 8;

/// The chains of one shape and treatment.
struct BundleList {
  DenseList<Bundle> bundles;
  std::uint32_t counts[kLengths] = {};  ///< Number of lanes of each length; lanes lie in this order.
  ChainPlace first[kLengths];           ///< Where each length that occurs begins.
};

/// What chains must have in common to stand side by side.
struct ShapeKind {
  bool twists = false, is_bounded = false;
  bool has_poses = false, has_body = false;
};

/// Chains that may stand side by side.
struct ChainShape {
  ChainShape* next = nullptr;
  const Solver* solver = nullptr;
  RowFunction* steps[kWidths] = {};
  Crowd* crowd = nullptr;
  const ColliderTable* colliders = nullptr;  ///< Table of the chains that touch colliders.
  ShapeKind kind;
  bool is_uneven = false;          ///< Chains may be shorter than `bones`.
  std::uint32_t users = 0;         ///< Number of chains of assets.
  std::uint32_t touching = 0;      ///< Number of those chains that touch colliders.
  std::span<const RowBone> bones;  ///< Independent of lanes: parents, slots, shared features.
  PartPool<Bundle> pool;
  std::span<BundleList> lists;  ///< Per treatment other than kIdle.
};

// shapes.cpp

[[nodiscard]] bool join_shapes(WorldState& world, WornAsset& worn);
void leave_shapes(WorldState& world, WornAsset& worn);
[[nodiscard]] std::uint64_t bytes_of_chains(const Asset& asset, std::uint32_t heads, const WorldRules& rules);
[[nodiscard]] std::size_t kept_floats(const Asset& asset, const WorldRules& rules);

// motions.cpp: coefficients

void carve_motions(MemoryCarver& carver, const WorldRules& rules, WornAsset& worn);
void number_motions(const WorldRules& rules, WornAsset& worn);
void set_motions(const WorldState& world, WornAsset& worn, const StepTerms& terms, std::byte* table);

// bundles.cpp

/// Bytes of a bundle.
[[nodiscard]] std::size_t bundle_bytes(const Solver& solver, std::size_t bones, const ShapeKind& kind);
/// Makes room for one more chain; false where there is no memory.
[[nodiscard]] bool add_member(WorldState& world, ChainShape& shape);
void remove_member(WorldState& world, ChainShape& shape);
/// Gives a lane of a list to a chain of so many bones, behind those that are not shorter; some of the others move. Its
/// content must still be written. `version`: that of a bundle in which it is the first.
[[nodiscard]] ChainPlace push_lane(WorldState& world, ChainShape& shape, BundleList& list, std::uint32_t bones,
                                   std::uint32_t version);
/// Removes the lane of a chain of so many bones; some of the others move.
void pop_lane(WorldState& world, ChainShape& shape, BundleList& list, std::uint32_t bones, ChainPlace lane);
/// Fills bones that a lane lacks because its chain has ended or it has none: they are computed too, and NaNs and
/// subnormals would be slow. They get the values of the first lane, touch nothing, are at rest and are held to their
/// parents, as in a level of detail without them.
void fill_missing_bones(const ChainShape& shape, Bundle& bundle);
/// The lane of the first `bones` bones of a chain.
[[nodiscard]] ChainLane chain_lane(const ChainShape& shape, const ChainPlace& place, std::size_t bones);

// bundle_chains.cpp

void enter_lanes(WorldState& world, std::uint32_t head);
void leave_lanes(WorldState& world, std::uint32_t head);
/// Sets the features of a loose bundle's bones to those that its lanes need.
void gather_wants(const WorldState& world, const ChainShape& shape, Bundle& bundle);
/// Renews the coefficients of new lanes, or after a change of terms.
void renew_coefficients(const WorldState& world, const ChainShape& shape, Bundle& bundle);
[[nodiscard]] inline const WornAsset& worn_in(const WorldState& world, const Bundle& bundle, std::uint32_t lane) {
  return world.worn_by(world.heads[bundle.head[lane]]);
}
[[nodiscard]] inline std::uint32_t bones_in(const WorldState& world, const Bundle& bundle, std::uint32_t lane) {
  return worn_in(world, bundle, lane).asset.chains()[bundle.chain[lane]].bone_count;
}

// step_bundles.cpp

void share_out(WorldState& world, const Crowd& crowd);
void run_bundles(const WorldState& world, std::uint32_t first, std::uint32_t end);

}  // namespace coif
