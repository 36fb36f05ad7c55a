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

inline constexpr std::uint32_t kMaxInstances = 1'000'000;
inline constexpr std::uint32_t kMaxInterval = 4;
inline constexpr float kLongestSettling = 600.0f;  ///< Seconds, of Hair::settle().

/// How bones are moved. A program links only those that it names.
struct Solver;
/// Algorithm 1 as published (thesis 5.2), on the artist's resistances and friction (Asset::asked()). What surrounds it
/// is this library's, as for all: air that goes along with the head, teleports, sleep, hitches; published_step() is the
/// step without any of that.
extern COIF_API const Solver kThesisSolver;
/// Which of the next two moves a chain, the asset says. The models are in runtime/docs/MODEL.md: the same at every
/// frame rate, no stretch, no penetration.
extern COIF_API const Solver kCoifSolver;
extern COIF_API const Solver
    kCascadeSolver;  ///< Bones do not hold back their parents: cheap, for stiff and well damped hair.
/// Bones hold back their parents, so that soft hair swings and comes to rest. Two to three times the work. Bones never
/// twist.
extern COIF_API const Solver kPassiveSolver;
/// kCoifSolver for hair on a character: with what HairDesc asks for of colliders that move, a body and poses to follow.
/// What it was not asked for is not stored; a program that does not name it holds nothing of all that.
extern COIF_API const Solver kCharacterSolver;
extern COIF_API const Solver kCharacterCascadeSolver;  ///< The same for kCascadeSolver.

struct LinkCode;

struct HairDesc {
  std::uint32_t instances = 1;  ///< Heads that wear this asset, 1..kMaxInstances.
  const Solver* solver = &kCoifSolver;
  /// Changes the speed and nothing else. kBadArgument for one that can_run() denies.
  InstructionSet instruction_set = InstructionSet::kBest;
  std::uint32_t longest_interval = 1;  ///< The largest Detail::interval that will be asked for: 1, 2 or 4.
  std::uint32_t dynamics_sets =
      1;  ///< That heads choose from, 1..kMaxDynamicsSets; each more up to 1 KB for each bone.
  const LinkCode* links =
      nullptr;  ///< coif/links.h: what the asset links stays together. Null: chains know nothing of each other.
  // For kCharacterSolver alone; with other solvers they are kBadArgument.
  std::uint32_t moving_colliders =
      0;  ///< Most that set_colliders() will give one head, up to kMaxMovingColliders; 300 bytes each.
  bool follows_body = false;   ///< The asset's body colliders take part, as set_body() moves them.
  bool follows_poses = false;  ///< set_pose() will be called; 60 bytes for each simulated bone.
  bool has_own_air = false;    ///< set_air() will be called; 16 bytes for each head.
  bool feels_gusts = false;    ///< set_gusts() will be called; 36 bytes for each head.
};

/// How much of the hair on one head is simulated. May change between any two steps. A finer level begins where the
/// coarser one left its bones; bones that a coarser level makes rigid take their rest pose at once, so choose levels by
/// sizes at which that is not seen.
struct Detail {
  /// The head's level among Asset::stored_lods(), as choose_lod() gives it: bones that it lacks are rigid to their
  /// parents. kThesisSolver moves all.
  std::uint32_t level = 0;
  /// Stepped every 1st, 2nd or 4th step, by what passed since; up to HairDesc::longest_interval.
  std::uint32_t interval = 1;
  /// False for a head that nobody sees: nothing is stepped, and when it is seen again the hair goes on with the shape
  /// that it had, at rest, without catching up.
  bool simulated = true;
};

struct MemoryNeed {
  std::size_t bytes = 0;
  std::size_t alignment = 64;
};

/// Sub-steps that the asset was tuned for at this dt (seconds), 1..kMaxSubsteps: what StepSettings::substeps = 0 means.
[[nodiscard]] COIF_API std::uint32_t tuned_substeps(const Asset& asset, float dt);

struct CrowdState;

/// A crowd of instances of one asset: state, simulation, bone matrices. Allocates nothing: the caller gives memory
/// once, create() carves it up. Not thread safe but for run_job(); different Hair objects are independent.
///
/// Results do not depend on the instruction set, on how many instances there are and in which order they were touched,
/// nor on which thread runs which job, and how that thread rounds: the same bits everywhere. Where floating-point
/// exceptions trap, nothing here does.
class COIF_API Hair {
 public:
  Hair() = default;
  Hair(const Hair&) = delete;  ///< Two owners would step the same memory.
  Hair& operator=(const Hair&) = delete;
  Hair(Hair&& other) noexcept : crowd_(other.crowd_) { other.crowd_ = nullptr; }
  Hair& operator=(Hair&& other) noexcept {
    crowd_ = other.crowd_;
    if (&other != this) other.crowd_ = nullptr;
    return *this;
  }

  /// Exact need of create() for this asset; zero bytes for arguments that create() refuses.
  [[nodiscard]] static MemoryNeed memory_need(const Asset& asset, const HairDesc& desc);

  /// Every instance starts in its rest pose with the head at the identity pose, until its first pose puts it elsewhere,
  /// see set_head(). The asset's bytes and `memory` must outlive this object; the Asset itself need not. Errors:
  /// kAssetLacksData (not open), kBadArgument (desc), kMemoryTooSmall (or not aligned).
  Status create(const Asset& asset, const HairDesc& desc, std::span<std::byte> memory);

  [[nodiscard]] std::uint32_t instance_count() const;
  [[nodiscard]] std::uint32_t bone_count() const;

  /// Where the head is at the end of the next step. The step moves it there from where it was, and the hair feels that:
  /// call teleport() or reset() for a head that jumps. The first pose that an instance is told after create() puts the
  /// head there, as teleport() does, and so do all others before the next step. kBadPose for a NaN, an infinity or a
  /// rotation whose length is off one by more than 1e-3 (smaller errors are normalised away), kBadScale for a scale out
  /// of its range.
  ///
  /// Scale: all that is in the asset, lengths and colliders, and all that comes out, matrices and bone ends, is in
  /// metres of the hair itself, of which a metre is `scale` of the world's. Places and ways in the world (the head's
  /// way, wind, gusts, moving colliders, pushes) are divided by the scale that the head has at the end of the step.
  /// Gravity is not, unless Environment::true_gravity says so, and time constants stay. So hair of every scale hangs as
  /// it was modelled: a head that stands or turns in place in still air moves its hair alike, to the bit, whatever its
  /// scale; and a head twice as large on ways twice as long, in wind twice as fast, does so too. One that grows takes
  /// its hair's shape and motion along. Of the settings, teleport_distance is the world's, sleep_speed the hair's.
  Status set_head(std::uint32_t instance, const HeadPose& pose);

  /// The same for a host that knows how fast the head moves when it arrives, which otherwise is taken from its last
  /// three poses: the path is then exact to one order more, at sharp turns above all. A head that is put somewhere, by
  /// its first pose or by teleport(), has this velocity from the step's start on, and its hair with it. kBadPose for
  /// what is not finite, too.
  Status set_head(std::uint32_t instance, const HeadPose& pose, const HeadVelocity& velocity);

  /// The first set_head() of every instance at once, instance_count() poses: for crowds of which most stand. A pose
  /// with the same bits as the last one costs a comparison. kSizeMismatch, and nothing is set; kBadPose or kBadScale
  /// where one or more are bad: those heads stay where they were told to be, the others are set.
  Status set_heads(std::span<const HeadPose> poses);

  /// Puts the head at `pose` and the hair into its rest pose there, at rest, and renews its matrices.
  Status reset(std::uint32_t instance, const HeadPose& pose);

  /// As set_head(), without a way there: during the next step the head goes on as it did, in its own new directions,
  /// and ends at `pose`. The hair keeps its shape and its motion relative to the head.
  Status teleport(std::uint32_t instance, const HeadPose& pose);

  /// kBadArgument for a level that the asset does not have or an interval that was not asked for in the description.
  Status set_detail(std::uint32_t instance, const Detail& detail);

  /// True while the instance costs nothing because nothing moves.
  [[nodiscard]] bool is_asleep(std::uint32_t instance) const;

  /// Advances every instance by settings.dt and renews the matrices. An instance whose numbers overflow (a head that
  /// moves by light years, gravity of 1e30) is put back into its rest pose, at rest; the others are not affected.
  Status step(const StepSettings& settings);

  /// The same in parts, for a host's own scheduler: begin_step(), then run_job() once for each of job_count() jobs, in
  /// any order, on any threads, at the same time; then finish_step(). Nothing else may be called in between. After an
  /// error there are no jobs. A job is sixteen heads. One that stays on its thread from step to step finds its numbers
  /// in that core's cache: give each thread its own share first, and let it take from the others' only then.
  Status begin_step(const StepSettings& settings);
  [[nodiscard]] std::uint32_t job_count() const;
  void run_job(std::uint32_t job);
  void finish_step();

  // On a character (kCharacterSolver). Each may be called between any two steps, holds until it is called again, and
  // costs nothing where it says again, to the bit, what it said before. A sleeping head wakes when what it says is
  // another and near enough to matter.

  /// What the hair of this head has to keep out of besides its asset's own colliders, in place of what was said before:
  /// the game's hands, shoulders, chairs. Those are the same in two steps that have the same place in `colliders`; see
  /// MovingCollider on how they get from one pose to the next. However fast they go through hair within that bound,
  /// hair stays on the side that they come to. No bone is deeper in than a ten-thousandth of the radius where it can
  /// help it: one that starts inside has its end outside, and between two that leave it no room it goes out sideways.
  /// kNotAsked for more than HairDesc::moving_colliders, kBadArgument for numbers that are not finite or out of their
  /// range.
  Status set_colliders(std::uint32_t instance, std::span<const MovingCollider> colliders);

  /// Where the body's bones are, as many as Asset::body_bones() and in their order, at the end of the coming step; to
  /// be said after the head's pose, whose scale is theirs. kNotAsked without HairDesc::follows_body, kSizeMismatch,
  /// kBadPose.
  Status set_body(std::uint32_t instance, std::span<const BodyPose> bones);

  /// The pose that the hair follows, in place of the rest pose: for each bone how it is turned in its parent's frame,
  /// from rest (rigid bones' are not read). `weights`, one for each chain or one for all: at 1 the pose is what pulls,
  /// at 0 the hair is the pose and nothing else moves it, in between it is in between; let them fade, as a weight that
  /// falls at once puts hair where the pose is. Back at 1 the hair goes on as fast as the pose went. A pose gets from
  /// one step's to the next at an even rate; the first one is there at once. No rotations and no weights: the rest pose
  /// again. kNotAsked without HairDesc::follows_poses, kSizeMismatch, kBadPose for what is no rotation, kBadArgument
  /// for weights beyond 0..1.
  Status set_pose(std::uint32_t instance, std::span<const Quat> rotations, std::span<const float> weights);

  // Air. Heads that sleep wake where it changes.

  /// The air around one head, until it is said again: what blows there besides StepSettings' wind, and how much of that
  /// and of the gusts reaches it. kNotAsked without HairDesc::has_own_air (kCharacterSolver), kBadArgument for numbers
  /// that are not finite or out of their range.
  Status set_air(std::uint32_t instance, const HeadAir& air);

  /// Gusts for the whole crowd, until they are said again, besides the wind; each bone feels them where it starts.
  /// Another amplitude or speed only changes that; another length, direction or seed are other gusts, which come at
  /// once, so fade `amplitude`. As long as they blow, no head that they reach falls asleep. kNotAsked without
  /// HairDesc::feels_gusts (kCharacterSolver), kBadArgument for numbers that are not finite or out of their range.
  Status set_gusts(const Gusts& gusts);

  [[nodiscard]] double gusts_way() const;  ///< How far the gusts' air has come in all steps so far, metres.

  /// What a set of dynamics multiplies the asset's by, besides StepSettings::dynamics; wet, frozen, calm. Sets begin
  /// with factors of 1. kThesisSolver, which has no such factors, takes no notice. kNotAsked for a set beyond
  /// HairDesc::dynamics_sets, kBadArgument.
  Status set_dynamics(std::uint32_t set, const DynamicsScale& scale);

  /// From the next step on the head's hair has this set's dynamics; heads begin with set 0. kNotAsked as
  /// set_dynamics().
  Status choose_dynamics(std::uint32_t instance, std::uint32_t set);

  /// Changes the hair's speed at once, between two steps, where it is now: an explosion, a blow, a hand. No bone is
  /// stretched or put elsewhere. A head that it reaches wakes. kBadArgument for numbers that are not finite or a radius
  /// that is not above 0.
  Status push(std::uint32_t instance, const Impulse& impulse);

  /// Lets the hair of these heads, which stand where they were last told to be, come to rest for up to `seconds`
  /// (0..kLongestSettling) in steps of 1/60 s, whatever settings.dt is: for the start of a scene. It ends before where
  /// all of them have come to rest. For everything else no time passes: other heads, the gusts and the turns of
  /// intervals are as before, to the bit. Settle many heads at once: each call costs about as much as a copy of the
  /// others' state. Hair that comes to rest under other gravity, wind or sleep settings than the last step's, or before
  /// the first step, stays awake until the next step. kBadIndex, kBadTimeStep for the seconds, or as step().
  Status settle(std::span<const std::uint32_t> instances, float seconds, const StepSettings& settings);
  Status settle(std::uint32_t instance, float seconds, const StepSettings& settings) {
    return settle(std::span(&instance, 1), seconds, settings);
  }

  /// The whole crowd's state as bytes, to go back to: for rollback and replays. Two crowds of the same asset, solver
  /// and number of heads that are in the same state save the same bytes, and go on to the same bits after restore(),
  /// whatever the instruction set. Asset and description are not in it. Not between begin_step() and finish_step().
  [[nodiscard]] std::size_t saved_bytes() const;
  /// kSizeMismatch unless there is room for exactly saved_bytes().
  Status save(std::span<std::byte> bytes) const;
  /// kForeignState or kDamagedState for what this crowd could not have saved, in every number and part: then it stays
  /// as it is.
  Status restore(std::span<const std::byte> bytes);

  /// Skinning matrices, bone_count() of them: rest pose in head space -> current pose in head space. Draw them under
  /// the head's world transform. Their values change with step() and reset(); empty for a bad index.
  [[nodiscard]] std::span<const Mat34> palette(std::uint32_t instance) const;

  /// Where each bone's particle is (rigid bones: their joint), head space, metres. kBadIndex, or kSizeMismatch unless
  /// there is room for exactly bone_count() of them.
  Status bone_ends(std::uint32_t instance, std::span<Vec3> ends) const;

 private:
  CrowdState* crowd_ = nullptr;  ///< In the caller's memory.
};

/// Steps several crowds alike; stops at the first error.
Status step_all(std::span<Hair* const> crowds, const StepSettings& settings);

}  // namespace coif
