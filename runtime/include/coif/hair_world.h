#pragma once

#include <coif/air.h>
#include <coif/asset.h>
#include <coif/character.h>
#include <coif/export.h>
#include <coif/instruction_set.h>
#include <coif/math.h>
#include <coif/status.h>
#include <coif/step_settings.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

inline constexpr std::uint32_t kMaxWorldAssets = 4096;
inline constexpr std::uint32_t kMaxInstances = 1'000'000;
inline constexpr std::uint32_t kMaxInterval = 4;
inline constexpr float kLongestSettling = 600.0f;  ///< Seconds that HairWorld::settle() may take at most.

/// A way to move bones. A program links only the solvers that it names.
struct Solver;
/// Algorithm 1 as published (thesis 5.2), with the artist's resistances and friction (Asset::asked()). This library
/// adds what all its solvers have: air that goes along with the head, teleports, sleep, hitches. published_step() turns
/// all of that off.
extern COIF_API const Solver kThesisSolver;
/// Moves each chain by one of the next two, as the asset says. The models are in runtime/docs/MODEL.md: the same at
/// every frame rate, no stretch, no penetration.
extern COIF_API const Solver kCoifSolver;
extern COIF_API const Solver
    kCascadeSolver;  ///< Bones do not hold back their parents: cheap, for stiff and well damped hair.
/// Bones hold back their parents, so that soft hair swings and comes to rest. Bones never twist. Two to three times the
/// work of kCascadeSolver.
extern COIF_API const Solver kPassiveSolver;
/// kCoifSolver for hair on a character, which may have moving colliders, a body and poses to follow. Only the features
/// that the description enables are stored. A program that does not name this solver does not link its code.
extern COIF_API const Solver kCharacterSolver;
extern COIF_API const Solver kCharacterCascadeSolver;  ///< The same for kCascadeSolver.

struct LinkCode;

/// A handle of an asset in a HairWorld, valid until the asset is removed; the default names none. The generation tells
/// a removed asset from a later one at the same index.
struct WorldAsset {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;
};

/// A handle of a head, as WorldAsset.
struct WorldHead {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;
};

struct WorldDesc {
  std::uint32_t assets = 32;  ///< Most assets at one time, 1..kMaxWorldAssets.
  std::uint32_t heads = 128;  ///< Most heads at one time, of all assets together, 1..kMaxInstances.
  /// Memory for the data of assets and heads, up to SIZE_MAX / 4; HairWorld::bytes_for() says how much they need. Where
  /// assets of many sizes come and go all the time, free memory becomes fragmented: give more than the sum, and handle
  /// kMemoryTooSmall.
  std::size_t hair_bytes = std::size_t{4} << 20;
  const Solver* solver = &kCoifSolver;  ///< Moves all heads.
  /// Changes the speed and nothing else; a few lanes left over run on a narrower set. kBadArgument for a set that
  /// can_run() denies.
  InstructionSet instruction_set = InstructionSet::kBest;
  std::uint32_t longest_interval = 1;  ///< The largest Detail::interval that will be set: 1, 2 or 4.
  /// How many sets of dynamics heads can choose from, 1..kMaxDynamicsSets. Each further set takes up to 1 KB per bone
  /// of an asset.
  std::uint32_t dynamics_sets = 1;
  /// kLinks or kCharacterLinks (coif/links.h) keeps linked chains together. Null: chains ignore the asset's links.
  const LinkCode* links = nullptr;
  // The members below are for kCharacterSolver and kCharacterCascadeSolver; with other solvers they are kBadArgument.
  /// Most colliders that set_colliders() will give one head, up to kMaxMovingColliders; 300 bytes each.
  std::uint32_t moving_colliders = 0;
  bool follows_body = false;   ///< The assets' body colliders take part, as set_body() moves them.
  bool follows_poses = false;  ///< set_pose() will be called; 60 bytes for each simulated bone.
  bool has_own_air = false;    ///< set_air() will be called; 16 bytes for each head.
  bool feels_gusts = false;    ///< set_gusts() will be called; 36 bytes for each head.
};

/// How much of the hair on one head is simulated. May change between any two steps. A finer level starts from the bones
/// as the coarser one left them. Bones that a coarser level makes rigid take their rest pose at once, so choose levels
/// at sizes at which nobody sees that.
struct Detail {
  /// The head's level among Asset::stored_lods(), as choose_lod() returns it. Bones that the level lacks are rigid to
  /// their parents. kThesisSolver moves all bones.
  std::uint32_t level = 0;
  /// The head is stepped every 1st, 2nd or 4th step, over the time since its last one; up to
  /// the description's longest_interval.
  std::uint32_t interval = 1;
  /// False for a head that nobody sees: it is not stepped. When it is simulated again, the hair goes on from the same
  /// shape, at rest, without catching up.
  bool simulated = true;
};

struct MemoryNeed {
  std::size_t bytes = 0;
  std::size_t alignment = 64;
};

/// Sub-steps that the asset was tuned for at this dt (seconds), 1..kMaxSubsteps; StepSettings::substeps = 0 uses them.
[[nodiscard]] COIF_API std::uint32_t tuned_substeps(const Asset& asset, float dt);

struct WorldState;

/// Heads with hair of many assets, which come and go while a game runs and are stepped together: state, simulation,
/// bone matrices. Allocates nothing: the caller gives memory once, and create() divides it. Not thread safe except
/// run_job(); different worlds are independent.
///
/// Each head has the same bits in every step in any company. Other heads and assets, the instruction set, the order in
/// which things were changed, the thread that runs a job and its rounding mode change nothing. Where floating-point
/// exceptions trap, no call here traps.
class COIF_API HairWorld {
 public:
  HairWorld() = default;
  HairWorld(const HairWorld&) = delete;  ///< Two owners would step the same memory.
  HairWorld& operator=(const HairWorld&) = delete;
  HairWorld(HairWorld&& other) noexcept : world_(other.world_) { other.world_ = nullptr; }
  HairWorld& operator=(HairWorld&& other) noexcept {
    world_ = other.world_;
    if (&other != this) other.world_ = nullptr;
    return *this;
  }

  /// Exactly the memory that create() needs; zero bytes for a description that it refuses.
  [[nodiscard]] static MemoryNeed memory_need(const WorldDesc& desc);
  /// The part of WorldDesc::hair_bytes that an asset takes with so many heads when nothing is shared with other assets;
  /// several together take less. `crowd` as in add_asset(). 0 for an asset that is not open or a description that
  /// create() refuses.
  [[nodiscard]] static std::size_t bytes_for(const Asset& asset, std::uint32_t heads, const WorldDesc& desc = {},
                                             std::uint32_t crowd = 0);

  /// Creates an empty world. `memory` must outlive this object. kBadArgument (desc), kMemoryTooSmall (or not aligned).
  Status create(const WorldDesc& desc, std::span<std::byte> memory);

  // These four may be called between any two steps. They take microseconds (add_asset() a few more, for each chain),
  // and change no bit of any other head's hair. On failure nothing changes.

  /// The asset's bytes must stay until it is removed; the Asset itself need not. `crowd` says about how many heads will
  /// wear it at a time, and changes speed and memory alone. 0: few; their chains are computed side by side with those
  /// of other assets, if their shapes are equal. From some ten on: the same chain of sixteen heads at a time, which
  /// costs least for many. kAssetLacksData for an asset that is not open, kMemoryTooSmall where WorldDesc::assets or
  /// hair_bytes are used up.
  Status add_asset(const Asset& asset, WorldAsset& added, std::uint32_t crowd = 0);
  /// kBadArgument while the asset has heads; kBadIndex.
  Status remove_asset(WorldAsset asset);
  /// Adds a head at `pose`, with its hair in the rest pose there, at rest. kBadIndex, kBadPose, kBadScale,
  /// kMemoryTooSmall.
  Status add_head(WorldAsset asset, const HeadPose& pose, WorldHead& added);
  Status remove_head(WorldHead head);  ///< kBadIndex.

  [[nodiscard]] bool has(WorldAsset asset) const;
  [[nodiscard]] bool has(WorldHead head) const;

  // The functions for single heads give kBadIndex for a head that does not exist, and then nothing changes.

  /// Sets where the head is at the end of the next step. The step moves it there from where it was, and the hair feels
  /// that motion: call teleport() or reset() for a head that jumps. kBadPose for a NaN, an infinity or a
  /// rotation whose length is off one by more than 1e-3 (smaller errors are normalised away), kBadScale for a scale out
  /// of its range.
  ///
  /// Scale: all lengths of the asset (colliders too) and of the results (matrices, bone ends) are in the hair's own
  /// metres; one of them is `scale` world metres. World quantities (the head's path, wind, gusts, moving colliders,
  /// pushes) are divided by the head's scale at the end of the step. Gravity is not divided, unless
  /// Environment::true_gravity says so; time constants stay the same. So hair hangs as it was modelled at every scale.
  /// A head that stands or turns in place in still air moves its hair in the same way at every scale, to the bit; so
  /// does a head of twice the scale on a path twice as long in wind twice as fast. When a head grows, its hair keeps
  /// its shape and motion relative to it. Of the settings, teleport_distance is in world metres, sleep_speed in the
  /// hair's.
  Status set_head(WorldHead head, const HeadPose& pose);

  /// As set_head(), for a host that knows how fast the head moves at the end of the step. Without it the velocity is
  /// taken from the head's last three poses; with it the path is exact to one order more, above all at sharp turns. A
  /// head that is put in place, by its first pose or by teleport(), and its hair have this velocity from the step's
  /// start on. kBadPose also for a velocity that is not finite.
  Status set_head(WorldHead head, const HeadPose& pose, const HeadVelocity& velocity);

  /// Puts the head at `pose` and the hair into its rest pose there, at rest, and updates its matrices.
  Status reset(WorldHead head, const HeadPose& pose);

  /// As set_head(), without a path: during the next step the head goes on as it did, in its own new directions, and
  /// ends at `pose`. The hair keeps its shape and its motion relative to the head.
  Status teleport(WorldHead head, const HeadPose& pose);

  /// kBadArgument for a level that the asset does not have or an interval above WorldDesc::longest_interval.
  Status set_detail(WorldHead head, const Detail& detail);

  /// True while the head costs nothing, because nothing moves.
  [[nodiscard]] bool is_asleep(WorldHead head) const;

  /// Advances every head by settings.dt and updates the matrices. Each asset has its own tuned sub-steps. A head whose
  /// numbers overflow (it moves by light years, gravity is 1e30) is put back into its rest pose, at rest; the others
  /// are not affected.
  Status step(const StepSettings& settings);

  /// step() in parts, for a host's own scheduler: begin_step(), then run_job() once for each of job_count() jobs, in
  /// any order, on any threads, at the same time; then finish_step(). Call nothing else in between. After an error
  /// there are no jobs. A job is sixteen heads of one crowd, or some chains of any heads. A job that runs on the same
  /// thread in every step finds its data in that core's cache: give each thread the same share first, and let it take
  /// from the others' only then.
  Status begin_step(const StepSettings& settings);
  [[nodiscard]] std::uint32_t job_count() const;
  void run_job(std::uint32_t job);
  void finish_step();

  // On a character (kCharacterSolver). Each function may be called between any two steps and holds until its next call.
  // A call with the same values, to the bit, costs nothing. A sleeping head wakes when the values change and are near
  // enough to matter.

  /// Sets the colliders that this head's hair keeps out of besides its asset's own, in place of those set before: the
  /// game's hands, shoulders, chairs. A collider at the same index in two steps is the same one; MovingCollider says
  /// how it moves from one pose to the next. Hair stays on the side that a collider comes to, at any speed within
  /// MovingCollider's limit. No bone is deeper inside than a ten-thousandth of the radius where it can avoid it: a bone
  /// that starts inside has its end outside, and between two colliders that leave it no room it goes out sideways.
  /// kNotAsked for more than WorldDesc::moving_colliders, kBadArgument for numbers that are not finite or out of their
  /// range.
  Status set_colliders(WorldHead head, std::span<const MovingCollider> colliders);

  /// Sets the poses of the body's bones at the end of the next step, in the order of Asset::body_bones(), one for each.
  /// Call it after set_head(): the head's scale is theirs too. kNotAsked without WorldDesc::follows_body,
  /// kSizeMismatch, kBadPose.
  Status set_body(WorldHead head, std::span<const BodyPose> bones);

  /// Sets the pose that the hair follows in place of the rest pose: for each bone its rotation from rest in its
  /// parent's frame (those of rigid bones are not read). `weights` has one for each chain or one for all. At 1 the pose
  /// is what the hair is pulled to; at 0 the hair is the pose and nothing else moves it; in between it is blended.
  /// Change weights slowly: one that falls at once puts the hair into the pose. Back at 1 the hair goes on as fast as
  /// the pose moved. During a step the pose changes at an even rate; the first pose holds at once. Without rotations
  /// and weights the rest pose returns. kNotAsked without WorldDesc::follows_poses, kSizeMismatch, kBadPose for a value
  /// that is not a rotation, kBadArgument for weights outside 0..1.
  Status set_pose(WorldHead head, std::span<const Quat> rotations, std::span<const float> weights);

  // Air. Sleeping heads wake where it changes.

  /// Sets the air around one head until the next call: its own wind besides StepSettings' wind, and the share of that
  /// wind and of the gusts that reaches the head. kNotAsked without WorldDesc::has_own_air (kCharacterSolver),
  /// kBadArgument for numbers that are not finite or out of their range.
  Status set_air(WorldHead head, const HeadAir& air);

  /// Sets gusts for the whole world, besides the wind, until the next call; each bone feels the gust at its start. A
  /// change of amplitude or speed keeps the pattern. Another length, direction or seed gives another pattern at once,
  /// so fade `amplitude` first. While gusts blow, no head that they reach falls asleep. kNotAsked without
  /// WorldDesc::feels_gusts (kCharacterSolver), kBadArgument for numbers that are not finite or out of their range.
  Status set_gusts(const Gusts& gusts);

  [[nodiscard]] double gusts_way() const;  ///< How far the gusts' air has come in all steps so far, metres.

  /// Sets the factors of one set of dynamics, applied on top of StepSettings::dynamics: wet, frozen, calm hair. Every
  /// set starts with factors of 1. kThesisSolver ignores them. kNotAsked for a set beyond WorldDesc::dynamics_sets,
  /// kBadArgument.
  Status set_dynamics(std::uint32_t set, const DynamicsScale& scale);

  /// From the next step on the head's hair uses this set of dynamics; heads start with set 0. kNotAsked as
  /// set_dynamics().
  Status choose_dynamics(WorldHead head, std::uint32_t set);

  /// Changes the hair's speed at once, between two steps, at its present place: an explosion, a blow, a hand. No bone
  /// is stretched or moved. A head that the impulse reaches wakes. kBadArgument for numbers that are not finite or a
  /// radius that is not above 0.
  Status push(WorldHead head, const Impulse& impulse);

  /// Lets the hair of these heads come to rest, for the start of a scene. The heads stand at their last pose. Takes up
  /// to `seconds` (0..kLongestSettling) in steps of 1/60 s, whatever settings.dt is, and ends earlier when all of them
  /// are at rest. No time passes for anything else: other heads, the gusts and the turns of intervals stay the same, to
  /// the bit. Settle many heads in one call: each call costs about a copy of the others' state. Hair that comes to rest
  /// before the first step, or with other gravity, wind or sleep settings than the last step's, stays awake until the
  /// next step. kBadIndex, kBadTimeStep for the seconds, or the errors of step().
  Status settle(std::span<const WorldHead> heads, float seconds, const StepSettings& settings);

  /// The size of the whole world's state, for rollback and replays. Two worlds with the same assets, solver and heads
  /// in the same state save the same bytes, and compute the same bits after restore(), on every instruction set. Assets
  /// and description are not saved. Not between begin_step() and finish_step().
  [[nodiscard]] std::size_t saved_bytes() const;
  /// Writes the state. kSizeMismatch unless `bytes` has exactly saved_bytes() bytes.
  Status save(std::span<std::byte> bytes) const;
  /// Returns to a saved state. kForeignState or kDamagedState for bytes that this world could not have saved with its
  /// present heads; every number is checked. Then the world stays as it is.
  Status restore(std::span<const std::byte> bytes);

  /// Skinning matrices, one for each bone of the head's asset: rest pose in head space -> current pose in head space.
  /// Draw the hair under the head's world transform. The values change with step() and reset(), the address never.
  [[nodiscard]] std::span<const Mat34> palette(WorldHead head) const;

  /// Writes the place of each bone's particle (rigid bones: their joint), head space, metres. kBadIndex, or
  /// kSizeMismatch unless `ends` has exactly one element for each bone.
  Status bone_ends(WorldHead head, std::span<Vec3> ends) const;

 private:
  friend class Hair;
  WorldState* world_ = nullptr;  ///< In the caller's memory.
};

}  // namespace coif
