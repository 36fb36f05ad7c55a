#pragma once
// The data of a HairWorld in the caller's memory; a Hair is a world with one asset.

#include "block.h"
#include "heap.h"
#include "moving_colliders.h"
#include "placed_colliders.h"

#include <coif/hair_world.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

class ChainVisit;
struct Bundle;
struct SharedCode;
struct WorldState;

using ChainPlace = DenseList<Bundle>::Place;

inline constexpr std::size_t kSmallestUnit = sizeof(BoneLanes);  ///< No block and no bundle has fewer bytes.

/// Colliders of several assets in one table, so that a set of bits can tell which of them a lane may touch.
struct ColliderTable {
  ColliderTable* next = nullptr;
  std::uint32_t taken = 0;  ///< A bit for each place in use; 0: the table is free.
  PlacedColliders placed;
};

/// Where the numbers of one head lie in its memory, bytes. The matrices are at 0.
struct HeadLayout {
  std::size_t bytes = 0;
  std::size_t alignment = 0;
  std::size_t state = 0;      ///< kChains: per bone of the rows.
  std::size_t twists = 0;     ///< kChains: per bone of the rows.
  std::size_t poses = 0;      ///< kChains: per bone of the rows.
  std::size_t places = 0;     ///< kShared: per chain.
  std::size_t kept = 0;       ///< kShared: floats.
  std::size_t colliders = 0;  ///< One HeadColliders, then a ToldCollider and a ColliderWay per place.
  std::size_t told = 0, ways = 0;
};

/// The moving colliders of one head.
struct HeadColliders {
  std::uint64_t there = 0;      ///< A bit for each place that has a collider.
  std::uint32_t way_count = 0;  ///< How many it may touch in this step.
};

/// An asset that is worn, as its heads need it. "Per bone" is per bone of the rows.
struct WornAsset {
  Asset asset;                   ///< A view.
  std::uint32_t generation = 1;  ///< Generation of the present or next asset here.
  bool is_there = false;
  std::uint32_t heads = 0;
  Crowd* crowd = nullptr;
  ColliderTable* colliders = nullptr;  ///< Null where the asset has none.
  std::uint32_t first_collider = 0;    ///< Where the asset's colliders begin in the table.
  HeadLayout layout;
  std::span<std::byte> memory;  ///< Memory of all that follows.
  std::span<StepTerms> terms;   ///< Per set of dynamics, per interval: those of the present coefficients; dt 0: none.
  std::size_t coefficient_bytes = 0;
  std::size_t table_bytes = 0;  ///< Bytes of one set's coefficients for one interval.
  std::byte* coefficients = nullptr;

  // For kHeads and kChains.
  RowCount count;
  bool twists = false;
  std::span<Row> rows;
  std::span<RowBone> row_bones;
  std::span<BoneLanes> constants;      ///< Per bone.
  std::span<LimitLanes> limits;        ///< Per bone; empty where the asset has none.
  std::span<std::uint32_t> body_sets;  ///< Per bone, per lane; empty where no body is followed.
  LinkState links;

  // For kShared.
  std::span<ChainShape*> shapes;       ///< Per chain.
  std::span<std::uint32_t> motion_of;  ///< Per bone of the asset: index of its motion; valid for simulated bones.
  std::span<std::uint32_t> motions;    ///< One bone for each distinct motion; the coefficients are theirs.
  std::size_t kept_floats = 0;         ///< Floats that the chains of a head without lanes need.

  // On a character.
  std::uint32_t body_colliders = 0;
  std::uint32_t places = 0;  ///< Collider places per head: the body's first, then the game's.
  float reach = 0;           ///< Largest distance of a bone from its head's position, in the hair's metres.

  [[nodiscard]] std::uint32_t bone_count() const { return std::uint32_t(asset.bones().size()); }
  /// The coefficients of a set of dynamics for an interval.
  [[nodiscard]] std::byte* table(std::uint32_t index) const { return coefficients + index * table_bytes; }
};

struct WornHead {
  Block* block = nullptr;
  std::byte* memory = nullptr;
  std::uint32_t generation = 1;
  std::uint32_t asset = kNone;  ///< For a free place, the next free one.
  HeadDetail detail;
  std::uint8_t lane = 0;  ///< In the block.
  std::uint8_t set = 0;   ///< Its set of dynamics.
  bool is_there : 1 = false;
  bool is_posed : 1 = false;
  bool has_lanes : 1 = false;  ///< kShared: its chains have lanes; else their numbers are kept.
};

/// Never 0, which no asset and no head has.
[[nodiscard]] inline std::uint32_t next_generation(std::uint32_t generation) {
  return generation + 1 == 0 ? 1 : generation + 1;
}

/// What a step visits: a block, or a bundle of chains of several heads.
struct StepUnit {
  const ChainShape* shape = nullptr;  ///< Null for a block.
  void* part = nullptr;               ///< A Block or a Bundle.
};

/// What the description of a world says about all its heads.
struct WorldRules {
  const Solver* solver = nullptr;
  const CharacterCode* character = nullptr;  ///< Null for hair that is not on a character.
  const LinkCode* links = nullptr;
  std::uint32_t intervals = 1;  ///< Number of intervals: 1, 2 or 3.
  std::uint32_t sets = 1;       ///< Number of sets of dynamics.
  std::uint32_t moving_colliders = 0;
  bool follows_body = false, follows_poses = false, has_own_air = false, feels_gusts = false;
};

struct WorldState {
  WorldRules rules;
  const SharedCode* shared = nullptr;  ///< Null where no chains of several heads stand side by side.
  HeadCode head_codes[kWidths];
  LimitFunction* keep_in_limit[kWidths] = {};
  InstructionSet widest = {};

  WorldHeap heap;
  std::span<WornAsset> assets;
  std::span<Crowd> crowds;
  std::span<WornHead> heads;
  std::span<HeadPose> told;                ///< Per head: the last pose that the host set; forget_told() invalidates it.
  std::span<HeadAir> airs;                 ///< Per head; empty where no head has its own.
  std::span<GustField> gusts;              ///< One, or none.
  std::span<DynamicsScale> dynamics_sets;  ///< One at least.
  ColliderTable* colliders = nullptr;
  std::uint32_t first_free_head = 0;

  std::span<StepUnit> units;      ///< Room for all.
  std::span<std::uint32_t> jobs;  ///< Where each job begins in `units`, and where the last ends.
  std::uint32_t unit_count = 0, job_count = 0;
  StepSettings settings;              ///< Settings of the present or last step.
  float last_dts[kMaxInterval] = {};  ///< The dt of the last steps, newest first.
  std::uint32_t step_index = 0;
  bool is_in_step = false;  ///< begin_step() has begun a step with dt > 0.
  /// Some head's interval differs from the requested one; the change takes effect at a later step.
  bool has_asked = false;

  [[nodiscard]] WornAsset& worn_by(const WornHead& head) const { return assets[head.asset]; }
  [[nodiscard]] Crowd& crowd_of(const WornHead& head) const { return *worn_by(head).crowd; }
  [[nodiscard]] std::span<Mat34> palette(const WornHead& head) const {
    return {reinterpret_cast<Mat34*>(head.memory), worn_by(head).bone_count()};
  }
  /// kShared: the place of each chain of a head that has lanes.
  [[nodiscard]] ChainPlace* places(const WornHead& head) const {
    return reinterpret_cast<ChainPlace*>(head.memory + worn_by(head).layout.places);
  }
  [[nodiscard]] HeadColliders& colliders_of(const WornHead& head) const {
    return *reinterpret_cast<HeadColliders*>(head.memory + worn_by(head).layout.colliders);
  }
  [[nodiscard]] ToldCollider* told_colliders(const WornHead& head) const {
    return reinterpret_cast<ToldCollider*>(head.memory + worn_by(head).layout.told);
  }
  [[nodiscard]] ColliderWay* ways(const WornHead& head) const {
    return reinterpret_cast<ColliderWay*>(head.memory + worn_by(head).layout.ways);
  }
};

/// How chains of several heads, whatever their assets, are kept and stepped side by side. Behind pointers, so that
/// programs with crowds of one asset alone do not link it. See bundles/bundles.h.
struct SharedCode {
  /// Upper bound of the bytes of the chains of so many heads.
  std::uint64_t (*bytes_of_chains)(const Asset& asset, std::uint32_t heads, const WorldRules& rules) = nullptr;
  /// Number of floats that the chains of one head keep.
  std::size_t (*kept_floats)(const Asset& asset, const WorldRules& rules) = nullptr;
  /// Adds the arrays of an asset; while counting they are empty.
  void (*carve)(MemoryCarver& carver, const WorldRules& rules, WornAsset& worn) = nullptr;
  /// Finds or makes the shape of each chain. False where there is no memory.
  bool (*join)(WorldState& world, WornAsset& worn) = nullptr;
  void (*leave)(WorldState& world, WornAsset& worn) = nullptr;
  /// Makes room for the chains of one more head; false where there is no memory.
  bool (*add_members)(WorldState& world, WornAsset& worn) = nullptr;
  void (*remove_members)(WorldState& world, WornAsset& worn) = nullptr;
  /// Gives lanes to the chains of a head, with the numbers that it kept.
  void (*enter)(WorldState& world, std::uint32_t head) = nullptr;
  /// Keeps the numbers of its chains and takes them out of their lanes.
  void (*leave_lanes)(WorldState& world, std::uint32_t head) = nullptr;
  /// Calls visit() for each chain of a head, even if it is idle.
  void (*visit)(WorldState& world, std::uint32_t head, const ChainVisit& visit) = nullptr;
  /// Computes the coefficients of an asset's motions with these terms.
  void (*set_coefficients)(const WorldState& world, WornAsset& worn, const StepTerms& terms,
                           std::byte* table) = nullptr;
  /// Shares the bundles of a crowd out among jobs.
  void (*share_out)(WorldState& world, const Crowd& crowd) = nullptr;
  void (*run)(const WorldState& world, std::uint32_t first, std::uint32_t end) = nullptr;
  /// Sum of the squared speeds of a head's tips, in the order of its chains.
  float (*motion)(const WorldState& world, const WornHead& head) = nullptr;
};

extern const SharedCode kSharedCode;

}  // namespace coif
