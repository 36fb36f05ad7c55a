#pragma once
// The data of a HairWorld in the caller's memory.
//
// A *shape* describes chains that may stand side by side. The lanes of its chains lie in *bundles* of sixteen, whatever
// their heads and assets; a bundle is stepped like a row (row.h). Chains of one shape may differ in length: longer ones
// come first, so that hardly any bundle has lanes that end before others. Heads lie in blocks of sixteen by their
// *pace*, the settings of their assets for a step. A head that sleeps leaves its block and bundles, and keeps its
// numbers itself.

#include "../placed_colliders.h"
#include "../rows.h"
#include "../solver.h"
#include "../step_settings.h"
#include "dense_list.h"

#include <coif/hair_world.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// Sixteen heads of one pace, or sixteen sleeping heads.
struct WorldBlock {
  WorldBlock* previous = nullptr;
  WorldBlock* next = nullptr;
  std::uint32_t count = 0;
  std::uint16_t teleports = 0;  ///< As Block::teleports.
  std::uint16_t is_lost = 0;
  std::uint16_t may_sleep = 0;
  std::uint32_t head[kLanes] = {};
  HeadLanes heads;
  HeadStepLanes step;  ///< In the present step.
};

/// Heads that are stepped with the same settings.
struct HeadPace {
  StepPace pace;
  std::uint32_t users = 0;  ///< Number of assets; 0: free.
  DenseList<WorldBlock> blocks;
  StepParts parts;            ///< In the present step.
  StepTerms terms;            ///< The terms of the present coefficients.
  std::uint32_t version = 0;  ///< Counts the changes of `terms`; 0: there are no coefficients.
};

/// Colliders of several assets in one table, so that a set of bits can tell which of them a lane may touch.
struct ColliderTable {
  ColliderTable* next = nullptr;
  std::uint32_t taken = 0;  ///< A bit for each place in use; 0: the table is free.
  PlacedColliders placed;
};

/// Sixteen chains of one shape. Arrays have an entry for each bone of the shape; see fill_missing_bones().
struct Bundle {
  Bundle* previous = nullptr;
  Bundle* next = nullptr;
  std::uint32_t count = 0;
  std::uint32_t version = 0;  ///< HeadPace::version of the coefficients of all lanes; 0: some are missing.
  std::uint32_t longest = 0;  ///< Bones of the longest chain; valid unless is_loose is set.
  bool is_loose = false;  ///< Lanes have come or gone: `bones` must be updated to the features of the present lanes.
  bool has_all_bones = false;  ///< fill_missing_bones() has run.
  std::uint32_t head[kLanes] = {};
  std::uint32_t chain[kLanes] = {};  ///< Chain number in the head's asset.
  RowBone* bones = nullptr;
  BoneLanes* constants = nullptr;
  LimitLanes* limits = nullptr;  ///< Null where no bone has a limit.
  std::byte* coefficients = nullptr;
  std::byte* state = nullptr;
  TwistState* twist = nullptr;   ///< Null where nothing twists.
  std::byte* scratch = nullptr;  ///< Null where it is on the stack.
  Lanes motion{};                ///< See RowStep; in the last part of the step.
};

/// Number of lengths in one shape: the longest, one bone shorter, and so on.
inline constexpr std::uint32_t kLengths = 8;

/// Chains that may stand side by side.
struct ChainShape {
  ChainShape* next = nullptr;
  const Solver* solver = nullptr;
  RowFunction* steps[kWidths] = {};
  HeadPace* pace = nullptr;
  const ColliderTable* colliders = nullptr;  ///< Table of the chains that touch colliders.
  bool twists = false, is_bounded = false;
  bool is_uneven = false;          ///< Chains may be shorter than `bones`.
  std::uint32_t users = 0;         ///< Number of chains of assets.
  std::uint32_t touching = 0;      ///< Number of those chains that touch colliders.
  std::span<const RowBone> bones;  ///< Independent of lanes: parents, slots, shared features.
  DenseList<Bundle> bundles;
  std::uint32_t counts[kLengths] = {};       ///< Number of lanes of each length; lanes lie in this order.
  DenseList<Bundle>::Place first[kLengths];  ///< Where each length that occurs begins.
};

struct WornAsset {
  Asset asset;                   ///< A view.
  std::uint32_t generation = 1;  ///< Generation of the present or next asset here.
  bool is_there = false;
  std::uint32_t heads = 0;
  HeadPace* pace = nullptr;
  ColliderTable* colliders = nullptr;  ///< Null where the asset has none.
  std::uint32_t first_collider = 0;    ///< Where the asset's colliders begin in the table.
  std::span<std::byte> memory;         ///< Memory of all that follows.
  std::span<ChainShape*> shapes;       ///< Per chain.
  std::span<std::uint32_t> motion_of;  ///< Per bone: index of its motion; valid for simulated bones.
  std::span<std::uint32_t> motions;    ///< One bone for each distinct motion.
  std::byte* coefficients = nullptr;   ///< Coefficients of the motions, sixteen side by side.
  std::size_t coefficient_bytes = 0;   ///< Bytes of sixteen coefficients.
  std::uint32_t version = 0;           ///< HeadPace::version of the coefficients.
  std::size_t kept_floats = 0;         ///< Floats that a sleeping head's chains need.
};

using ChainPlace = DenseList<Bundle>::Place;

struct WornHead {
  std::uint32_t generation = 1;
  std::uint32_t asset = kNone;  ///< kNone: free.
  std::uint32_t next_free = kNone;
  bool is_asleep = false;
  DenseList<WorldBlock>::Place place;
  std::span<std::byte> memory;   ///< Memory of all that follows.
  std::span<Mat34> palette;      ///< Per bone.
  std::span<ChainPlace> places;  ///< Per chain; valid while it is awake.
  std::span<float> kept;         ///< The state of the chains while it sleeps.
  HeadPose told;                 ///< As CrowdState::told.
};

/// A bundle that a step visits.
struct BundleStep {
  const ChainShape* shape = nullptr;
  Bundle* bundle = nullptr;
};

struct WorldState {
  const Solver* solver = nullptr;
  InstructionSet widest = {};
  HeadCode head_codes[kWidths];
  LimitFunction* keep_in_limit[kWidths] = {};
  WorldHeap heap;
  std::span<WornAsset> assets;
  std::span<HeadPace> paces;
  std::span<WornHead> heads;
  std::span<WorldBlock> sleeping;  ///< The parts of `asleep`; room for all heads.
  DenseList<WorldBlock> asleep;
  ChainShape* shapes = nullptr;
  ColliderTable* colliders = nullptr;
  std::uint32_t first_free_head = 0;
  std::span<BundleStep> steps;    ///< Room for all bundles.
  std::span<std::uint32_t> jobs;  ///< Where each job begins in `steps`, and where the last ends.
  std::uint32_t job_count = 0;
  StepSettings settings;  ///< Settings of the present or last step.
  bool has_stepped = false;
  bool is_in_step = false;  ///< begin_step() has begun a step with dt > 0.
};

/// Never 0, which no asset and no head has.
[[nodiscard]] inline std::uint32_t next_generation(std::uint32_t generation) {
  return generation + 1 == 0 ? 1 : generation + 1;
}

// shared_colliders.cpp

/// Gives the asset's colliders places in a table, or shares those of an asset with the same colliders. False where
/// there is no memory.
[[nodiscard]] bool join_colliders(WorldState& world, WornAsset& worn);
void leave_colliders(WorldState& world, WornAsset& worn);

// shapes.cpp

/// Finds or makes the shape of each chain of an asset whose pace and colliders are known. False where there is no
/// memory.
[[nodiscard]] bool join_shapes(WorldState& world, WornAsset& worn);
/// Takes the asset's chains out of the shapes that they have joined.
void leave_shapes(WorldState& world, const WornAsset& worn);
/// Upper bound of the bytes of the chains of so many heads.
[[nodiscard]] std::size_t bytes_of_chains(const Asset& asset, std::uint32_t heads, const Solver& asked);
/// Number of floats that the chains of one head keep.
[[nodiscard]] std::size_t kept_floats(const Asset& asset, const Solver& asked);

// worn_asset.cpp

/// Bytes of an asset and the chains of so many heads where nothing is shared with others; the heads come on top.
[[nodiscard]] std::size_t bytes_alone(const Asset& asset, std::uint32_t heads, const Solver& asked);
/// False where there is no memory.
[[nodiscard]] bool add_asset(WorldState& world, WornAsset& worn, const Asset& asset);
/// No head may wear it.
void remove_asset(WorldState& world, WornAsset& worn);
/// Computes the coefficients of all its motions with its pace's terms.
void renew_motions(const WorldState& world, WornAsset& worn);

// bundles.cpp

/// Bytes of a bundle of this shape.
[[nodiscard]] std::size_t bundle_bytes(const Solver& solver, std::size_t bones, bool twists, bool is_bounded);
/// Makes room for one more chain; false where there is no memory.
[[nodiscard]] bool add_member(WorldState& world, ChainShape& shape);
void remove_member(WorldState& world, ChainShape& shape);
/// Gives a lane to a chain of so many bones, behind those that are not shorter; some of the others move. Its content
/// must still be written.
[[nodiscard]] ChainPlace push_lane(WorldState& world, ChainShape& shape, std::uint32_t bones);
/// Removes the lane of a chain of so many bones; some of the others move.
void pop_lane(WorldState& world, ChainShape& shape, std::uint32_t bones, ChainPlace lane);
/// Fills bones that a lane lacks because its chain has ended or it has none: they are computed too, and NaNs and
/// subnormals would be slow. They get the values of the first lane, touch nothing, are at rest and are held to their
/// parents, as in a level of detail without them.
void fill_missing_bones(const ChainShape& shape, Bundle& bundle);
/// The lane of a chain of so many bones, and of the missing bones after them, since a NaN there would spread.
[[nodiscard]] ChainLane chain_lane(const ChainShape& shape, const ChainPlace& place, std::uint32_t bones);

// worn_chains.cpp

/// Gives a lane to a chain of a head; its state must still be written.
void push_chain(WorldState& world, std::uint32_t head, std::uint32_t chain);
void pop_chain(WorldState& world, std::uint32_t head, std::uint32_t chain);
/// Sets the features of a loose bundle's bones to those that its lanes need.
void gather_wants(const WorldState& world, const ChainShape& shape, Bundle& bundle);
/// Renews the coefficients of new lanes, or after a change of terms.
void renew_coefficients(const WorldState& world, const ChainShape& shape, Bundle& bundle);
[[nodiscard]] std::uint32_t bones_in(const WorldState& world, const Bundle& bundle, std::uint32_t lane);

// world_heads.cpp

/// Bytes of so many heads of one pace, without their chains' lanes.
[[nodiscard]] std::size_t head_bytes(const Asset& asset, std::uint32_t heads, const Solver& asked);
/// False where there is no memory.
[[nodiscard]] bool add_head(WorldState& world, std::uint32_t asset, std::uint32_t head, const HeadPose& unit);
void remove_head(WorldState& world, std::uint32_t head);
/// `velocity` may be null. Needs a plain FloatEnvironment.
Status move_head(WorldState& world, std::uint32_t head, const HeadPose& pose, const HeadVelocity* velocity);
/// Puts the head at its next pose and the hair into its rest pose there, at rest, and updates its matrices.
void put_to_rest(WorldState& world, WornHead& head);
void fall_asleep(WorldState& world, std::uint32_t head);
void wake(WorldState& world, std::uint32_t head);
/// Turns the hair by `by` as if it were rigid.
void turn_hair(WorldState& world, WornHead& head, const Quat& by);
/// As jump() of a crowd.
void jump(WorldState& world, WornHead& head, float dt);

/// Calls visit(shape, ChainLane) for each chain of a head that is awake.
template <typename Visit>
void for_each_chain(const WorldState& world, const WornHead& head, const Visit& visit) {
  const WornAsset& worn = world.assets[head.asset];
  for (std::size_t c = 0; c < worn.shapes.size(); ++c) {
    visit(*worn.shapes[c], chain_lane(*worn.shapes[c], head.places[c], worn.asset.chains()[c].bone_count));
  }
}

// world_step.cpp

void begin_step(WorldState& world, const StepSettings& settings);
void run_job(const WorldState& world, std::uint32_t job);
void finish_step(WorldState& world);

}  // namespace coif
