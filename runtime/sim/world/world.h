#pragma once
// All that a HairWorld keeps in the caller's memory.
//
// A *shape* is what chains have in common that may stand side by side. Its chains' lanes lie in *bundles* of sixteen,
// whatever heads and assets they are of; a bundle is stepped as a row is (row.h). Chains of one shape may be of unlike
// length: longer ones come first, so that hardly any bundle has lanes that end before others. Heads lie in blocks of
// sixteen by their *pace*: what their assets say of how a step is made. A head that sleeps leaves its block and
// bundles, and keeps its numbers itself.

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

/// Sixteen heads of one pace, or that sleep.
struct WorldBlock {
  WorldBlock* previous = nullptr;
  WorldBlock* next = nullptr;
  std::uint32_t count = 0;
  std::uint16_t teleports = 0;  ///< As Block's.
  std::uint16_t is_lost = 0;
  std::uint16_t may_sleep = 0;
  std::uint32_t head[kLanes] = {};
  HeadLanes heads;
  HeadStepLanes step;  ///< Of the present step.
};

/// Heads that are stepped alike.
struct HeadPace {
  StepPace pace;
  std::uint32_t users = 0;  ///< Assets; 0: free.
  DenseList<WorldBlock> blocks;
  StepParts parts;            ///< Of the present step.
  StepTerms terms;            ///< Of the coefficients at hand,
  std::uint32_t version = 0;  ///< which has changed as often as they did; 0: there are none.
};

/// Colliders of several assets in one table, so that a set of bits says which of them a lane may touch.
struct ColliderTable {
  ColliderTable* next = nullptr;
  std::uint32_t taken = 0;  ///< A bit for each; 0: free.
  PlacedColliders placed;
};

/// Sixteen chains of one shape. Arrays have an entry for each bone of the shape; see fill_missing_bones().
struct Bundle {
  Bundle* previous = nullptr;
  Bundle* next = nullptr;
  std::uint32_t count = 0;
  std::uint32_t version = 0;   ///< HeadPace::version of the coefficients of all lanes; 0: of some there are none.
  std::uint32_t longest = 0;   ///< Bones of the longest chain; known unless is_loose.
  bool is_loose = false;       ///< Lanes have come or gone: `bones` is yet to say what those ask for that are there.
  bool has_all_bones = false;  ///< What fill_missing_bones() does has been done.
  std::uint32_t head[kLanes] = {};
  std::uint32_t chain[kLanes] = {};  ///< Of the head's asset.
  RowBone* bones = nullptr;
  BoneLanes* constants = nullptr;
  LimitLanes* limits = nullptr;  ///< Null where nothing is bounded.
  std::byte* coefficients = nullptr;
  std::byte* state = nullptr;
  TwistState* twist = nullptr;   ///< Null where nothing twists.
  std::byte* scratch = nullptr;  ///< Null where it is on the stack.
  Lanes motion{};                ///< See RowStep; of the last part of the step.
};

/// So many lengths there are in one shape, the longest and those that are shorter by one bone, two, and so on.
inline constexpr std::uint32_t kLengths = 8;

/// Chains that may stand side by side.
struct ChainShape {
  ChainShape* next = nullptr;
  const Solver* solver = nullptr;
  RowFunction* steps[kWidths] = {};
  HeadPace* pace = nullptr;
  const ColliderTable* colliders = nullptr;  ///< Of those that touch any.
  bool twists = false, is_bounded = false;
  bool is_uneven = false;          ///< Chains may be shorter than `bones`.
  std::uint32_t users = 0;         ///< Chains of assets,
  std::uint32_t touching = 0;      ///< and those of them that touch colliders.
  std::span<const RowBone> bones;  ///< Without any lane: parents, slots, what all lanes have in common.
  DenseList<Bundle> bundles;
  std::uint32_t counts[kLengths] = {};       ///< Lanes of each length, which lie in this order,
  DenseList<Bundle>::Place first[kLengths];  ///< and where each length begins that has any.
};

struct WornAsset {
  Asset asset;                   ///< A view.
  std::uint32_t generation = 1;  ///< Of the asset that is here, or comes next.
  bool is_there = false;
  std::uint32_t heads = 0;
  HeadPace* pace = nullptr;
  ColliderTable* colliders = nullptr;  ///< Null where the asset has none.
  std::uint32_t first_collider = 0;    ///< Where they begin in the table.
  std::span<std::byte> memory;         ///< Of all that follows.
  std::span<ChainShape*> shapes;       ///< Per chain.
  std::span<std::uint32_t> motion_of;  ///< Per bone: which of the motions it has; of simulated bones.
  std::span<std::uint32_t> motions;    ///< A bone for each kind of motion.
  std::byte* coefficients = nullptr;   ///< Of the motions, sixteen side by side.
  std::size_t coefficient_bytes = 0;   ///< Of sixteen.
  std::uint32_t version = 0;           ///< HeadPace::version of them.
  std::size_t kept_floats = 0;         ///< Of the chains of a head that sleeps.
};

using ChainPlace = DenseList<Bundle>::Place;

struct WornHead {
  std::uint32_t generation = 1;
  std::uint32_t asset = kNone;  ///< kNone: free.
  std::uint32_t next_free = kNone;
  bool is_asleep = false;
  DenseList<WorldBlock>::Place place;
  std::span<std::byte> memory;   ///< Of all that follows.
  std::span<Mat34> palette;      ///< Per bone.
  std::span<ChainPlace> places;  ///< Per chain; while it is awake.
  std::span<float> kept;         ///< The chains' state while it sleeps.
  HeadPose told;                 ///< As CrowdState::told.
};

/// What a step visits.
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
  std::span<WorldBlock> sleeping;  ///< The parts of `asleep`: room for all heads.
  DenseList<WorldBlock> asleep;
  ChainShape* shapes = nullptr;
  ColliderTable* colliders = nullptr;
  std::uint32_t first_free_head = 0;
  std::span<BundleStep> steps;    ///< As many as there can be bundles.
  std::span<std::uint32_t> jobs;  ///< Where in `steps` each begins, and where the last ends.
  std::uint32_t job_count = 0;
  StepSettings settings;  ///< Of the present or last step.
  bool has_stepped = false;
  bool is_in_step = false;  ///< begin_step() has begun one in which time passes.
};

/// 0 is no asset's and no head's.
[[nodiscard]] inline std::uint32_t next_generation(std::uint32_t generation) {
  return generation + 1 == 0 ? 1 : generation + 1;
}

// shared_colliders.cpp

/// Gives the asset's colliders places in a table, those of another asset where that has the same; false where there is
/// no memory.
[[nodiscard]] bool join_colliders(WorldState& world, WornAsset& worn);
void leave_colliders(WorldState& world, WornAsset& worn);

// shapes.cpp

/// Finds or makes the shape of each chain of an asset that knows its pace and colliders; false where there is no
/// memory.
[[nodiscard]] bool join_shapes(WorldState& world, WornAsset& worn);
/// Of those chains that have joined one.
void leave_shapes(WorldState& world, const WornAsset& worn);
/// What the chains of so many heads take at most.
[[nodiscard]] std::size_t bytes_of_chains(const Asset& asset, std::uint32_t heads, const Solver& asked);
/// Numbers that the chains of one head have to keep.
[[nodiscard]] std::size_t kept_floats(const Asset& asset, const Solver& asked);

// worn_asset.cpp

/// What an asset and the chains of so many heads take where they share nothing with others; heads come on top.
[[nodiscard]] std::size_t bytes_alone(const Asset& asset, std::uint32_t heads, const Solver& asked);
/// False where there is no memory.
[[nodiscard]] bool add_asset(WorldState& world, WornAsset& worn, const Asset& asset);
/// No head wears it.
void remove_asset(WorldState& world, WornAsset& worn);
/// Computes the coefficients of all its motions under its pace's terms.
void renew_motions(const WorldState& world, WornAsset& worn);

// bundles.cpp

/// What a bundle of this shape takes.
[[nodiscard]] std::size_t bundle_bytes(const Solver& solver, std::size_t bones, bool twists, bool is_bounded);
/// Makes room for one more chain; false where there is no memory.
[[nodiscard]] bool add_member(WorldState& world, ChainShape& shape);
void remove_member(WorldState& world, ChainShape& shape);
/// A lane for a chain of so many bones, behind those that are no shorter; some of the others move. What it has is yet
/// to be written.
[[nodiscard]] ChainPlace push_lane(WorldState& world, ChainShape& shape, std::uint32_t bones);
/// Takes away the lane of a chain of so many bones; some of the others move.
void pop_lane(WorldState& world, ChainShape& shape, std::uint32_t bones, ChainPlace lane);
/// Lanes compute along where their chain has ended, or there is none: numbers that are none would be slow. There they
/// have those of the first lane, touch nothing, and are at rest and held to their parents as in a level of detail
/// without them.
void fill_missing_bones(const ChainShape& shape, Bundle& bundle);
/// Of a chain of so many bones, and of those after them that compute along: what is nowhere would spread.
[[nodiscard]] ChainLane chain_lane(const ChainShape& shape, const ChainPlace& place, std::uint32_t bones);

// worn_chains.cpp

/// Gives a chain of a head a lane, of which the state is yet to be written.
void push_chain(WorldState& world, std::uint32_t head, std::uint32_t chain);
void pop_chain(WorldState& world, std::uint32_t head, std::uint32_t chain);
/// Makes a loose bundle's bones say what those of its lanes ask for.
void gather_wants(const WorldState& world, const ChainShape& shape, Bundle& bundle);
/// Of lanes that have come, or under other terms.
void renew_coefficients(const WorldState& world, const ChainShape& shape, Bundle& bundle);
[[nodiscard]] std::uint32_t bones_in(const WorldState& world, const Bundle& bundle, std::uint32_t lane);

// world_heads.cpp

/// What so many heads of one pace take besides their chains' lanes.
[[nodiscard]] std::size_t head_bytes(const Asset& asset, std::uint32_t heads, const Solver& asked);
/// False where there is no memory.
[[nodiscard]] bool add_head(WorldState& world, std::uint32_t asset, std::uint32_t head, const HeadPose& unit);
void remove_head(WorldState& world, std::uint32_t head);
/// `velocity` may be null. In a plain FloatEnvironment.
Status move_head(WorldState& world, std::uint32_t head, const HeadPose& pose, const HeadVelocity* velocity);
/// Puts the head at its next pose and the hair into its rest pose there, at rest, and renews its matrices.
void put_to_rest(WorldState& world, WornHead& head);
void fall_asleep(WorldState& world, std::uint32_t head);
void wake(WorldState& world, std::uint32_t head);
/// The hair turned by `by` as if it were rigid.
void turn_hair(WorldState& world, WornHead& head, const Quat& by);
/// As the jump() of a crowd.
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
