#pragma once

#include <coif/asset.h>
#include <coif/coif_step_job.h>
#include <coif/head_track.h>
#include <coif/math.h>
#include <coif/particle.h>
#include <coif/status.h>
#include <coif/thesis_step_job.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

inline constexpr std::uint32_t kMaxInstances = 1'000'000;

inline constexpr std::uint32_t kMaxSubsteps = 64;

enum class Solver : std::uint8_t {
  kThesis = 0,  ///< Algorithm 1 exactly as published (thesis 5.2).
  kCoif = 1,    ///< The model of runtime/docs/MODEL.md: the same at every frame rate, no stretch, no penetration.
};

/// What acts on all instances during a step.
struct Environment {
  Vec3 gravity{0.0f, -9.81f, 0.0f};  ///< World, m/s^2.
  Vec3 wind{};                       ///< Velocity of the air, world, m/s.
  /// Share of the head's own velocity that the air around it takes on, 0..1. At 1 a head that moves steadily leaves
  /// its hair alone; at 0 the air stands still in the world and friction pulls the hair back at speed.
  float air_follow = 1.0f;
};

struct StepSettings {
  float dt = 1.0f / 60.0f;  ///< Seconds, > 0, at most kMaxTimeStep. A paused game does not step.
  Solver solver = Solver::kCoif;
  /// kCoif: equal parts that the step is made of, 1..kMaxSubsteps; 0: as many as the asset was tuned for at this dt.
  std::uint32_t substeps = 0;
  std::uint32_t iterations = 1;  ///< kThesis: passes over the length and collision constraints, 1..kMaxIterations.
  Environment environment{};
  DynamicsScale dynamics{};  ///< kCoif: may change from step to step; the hair goes on from where it is.
  /// Share of the head's motion that the hair feels, 0..1. At 0 hair is carried along rigidly and only gravity, wind and
  /// contacts move it; for acrobatics, vehicles and cut scenes.
  float inertia = 1.0f;
  /// A head that moves further than this in one step has been put there: the hair keeps its shape instead of being
  /// thrown. Metres and radians; infinity to believe in every movement.
  float teleport_distance = 5.0f;
  float teleport_angle = 2.8f;
};

struct HairDesc {
  std::uint32_t instances = 1;  ///< Heads that wear this asset, 1..kMaxInstances.
};

struct MemoryNeed {
  std::size_t bytes = 0;
  std::size_t alignment = 64;
};

class MemoryCarver;

/// A crowd of instances of one asset: state, simulation, bone matrices. Allocates nothing: the caller gives memory
/// once, create() carves it up. Not thread safe; different Hair objects are independent. A thin owner: a game with
/// its own memory and job system can run CoifStepJob or ThesisStepJob, and PaletteJob, itself.
class Hair {
 public:
  Hair() = default;
  Hair(const Hair&) = delete;  ///< Two owners would step the same memory.
  Hair& operator=(const Hair&) = delete;
  Hair(Hair&&) = default;  ///< The source may then only be assigned to, moved into or destroyed.
  Hair& operator=(Hair&&) = default;

  /// Exact need of create() for this asset; zero bytes for arguments that create() refuses.
  [[nodiscard]] static MemoryNeed memory_need(const Asset& asset, const HairDesc& desc);

  /// Every instance starts in its rest pose with the head at the identity pose; call reset() to start elsewhere. The
  /// asset's bytes and `memory` must outlive this object; the Asset itself need not. Errors: kAssetLacksData (not
  /// open), kBadArgument (instances), kMemoryTooSmall (or not aligned).
  Status create(const Asset& asset, const HairDesc& desc, std::span<std::byte> memory);

  [[nodiscard]] std::uint32_t instance_count() const { return instances_; }
  [[nodiscard]] std::uint32_t bone_count() const { return std::uint32_t(bones_.size()); }

  /// Where the head is at the end of the next step. The step moves it there from where it was, and the hair feels
  /// that: call teleport() or reset() for a head that jumps. kBadPose for a NaN, an infinity or a rotation whose length
  /// is off one by more than 1e-3; smaller errors are normalised away.
  Status set_head(std::uint32_t instance, const HeadPose& pose);

  /// Puts the head at `pose` and the hair into its rest pose there, at rest, and renews its matrices.
  Status reset(std::uint32_t instance, const HeadPose& pose);

  /// As set_head(), without a way there: during the next step the head goes on as it did, in its own new directions, and
  /// ends at `pose`. The hair keeps its shape and its motion relative to the head.
  Status teleport(std::uint32_t instance, const HeadPose& pose);

  /// Advances every instance by settings.dt and renews the matrices. An instance whose numbers overflow (a head that
  /// moves by light years, gravity of 1e30) is put back into its rest pose, at rest; the others are not affected.
  Status step(const StepSettings& settings);

  /// Skinning matrices, bone_count() of them: rest pose in head space -> current pose in head space. Draw them under
  /// the head's world transform. Their values change with step() and reset(); empty for a bad index.
  [[nodiscard]] std::span<const Mat34> palette(std::uint32_t instance) const;

  /// Where each bone's particle is (rigid bones: their joint), head space, metres; empty for a bad index.
  [[nodiscard]] std::span<const Vec3> bone_ends(std::uint32_t instance) const;

 private:
  struct Instance {
    HeadTrack head;
    bool teleports = false;     ///< In the next step, as the host says.
    bool swings_known = false;  ///< False where something but kCoif has moved the particles.
  };

  /// What create() carves out of the caller's memory. Arrays "per instance" hold one block for each, in order.
  struct Storage {
    std::span<Instance> instances;      ///< One per instance.
    std::span<Particle> particles;      ///< Simulated bones per instance.
    std::span<BoneSwing> swings;        ///< Simulated bones per instance.
    std::span<Mat34> palettes;          ///< Bones per instance.
    std::span<Vec3> bone_ends;          ///< Bones per instance.
    std::span<float> friction_factors;  ///< Simulated bones, shared by the instances during a step; so are the rest.
    std::span<BoneScratch> scratch;
    std::span<PoseResponse> responses;  ///< For responses_for_.
    std::span<Quat> frames;
    std::span<Quat> world_frames;
    std::span<Vec3> angular_velocities;
    std::span<Vec3> positions_before;
  };

  static Storage carve(MemoryCarver& carver, const SkeletonRecord& skeleton, std::uint32_t instances);
  [[nodiscard]] std::span<Particle> particles_of(std::uint32_t instance) const;
  [[nodiscard]] std::span<BoneSwing> swings_of(std::uint32_t instance) const;
  [[nodiscard]] std::uint32_t substeps_for(const StepSettings& settings) const;
  void prepare(const StepSettings& settings, float substep);
  void advance(std::uint32_t instance, const StepSettings& settings, std::uint32_t substeps);
  [[nodiscard]] Status run_thesis(std::uint32_t instance, const StepSettings& settings, const HeadMove& move, float dt);
  [[nodiscard]] Status run_coif(std::uint32_t instance, const StepSettings& settings, const HeadMove& move, float dt);
  void learn_swings(std::uint32_t instance);
  void carry(std::uint32_t instance, const Quat& turn);
  void put_to_rest(std::uint32_t instance);
  void renew_palette(std::uint32_t instance, bool has_world_frames);

  /// What storage_.responses was computed for.
  struct ResponsesFor {
    float dt = 0;
    DynamicsScale scale;
  };

  std::uint32_t instances_ = 0;
  std::uint32_t simulated_count_ = 0;
  std::span<const BoneRecord> bones_;
  std::span<const DynamicsRecord> dynamics_;
  std::span<const ColliderRecord> colliders_;  ///< Empty where no bone can touch any.
  ResponsesFor responses_for_;
  float substep_rate_ = 0;  ///< Of the asset's tuning, Hz.
  Storage storage_;
};

}  // namespace coif
