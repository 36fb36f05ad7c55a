#pragma once

#include <coif/hair_world.h>

namespace coif {

struct HairDesc {
  std::uint32_t instances = 1;  ///< Heads that wear this asset, 1..kMaxInstances.
  const Solver* solver = &kCoifSolver;
  /// Changes the speed and nothing else. kBadArgument for a set that can_run() denies.
  InstructionSet instruction_set = InstructionSet::kBest;
  std::uint32_t longest_interval = 1;  ///< The largest Detail::interval that will be set: 1, 2 or 4.
  /// How many sets of dynamics heads can choose from, 1..kMaxDynamicsSets. Each further set takes up to 1 KB per bone.
  std::uint32_t dynamics_sets = 1;
  /// kLinks or kCharacterLinks (coif/links.h) keeps linked chains together. Null: chains ignore the asset's links.
  const LinkCode* links = nullptr;
  // The members below are for kCharacterSolver and kCharacterCascadeSolver; with other solvers they are kBadArgument.
  /// Most colliders that set_colliders() will give one head, up to kMaxMovingColliders; 300 bytes each.
  std::uint32_t moving_colliders = 0;
  bool follows_body = false;   ///< The asset's body colliders take part, as set_body() moves them.
  bool follows_poses = false;  ///< set_pose() will be called; 60 bytes for each simulated bone.
  bool has_own_air = false;    ///< set_air() will be called; 16 bytes for each head.
  bool feels_gusts = false;    ///< set_gusts() will be called; 36 bytes for each head.
};

/// A crowd of heads that all wear one asset: a HairWorld whose heads, numbered from 0, are there from the start. Every
/// function does what the function of that name does for the head with that number in a HairWorld.
class COIF_API Hair {
 public:
  /// Exactly the memory that create() needs for this asset; zero bytes for arguments that create() refuses.
  [[nodiscard]] static MemoryNeed memory_need(const Asset& asset, const HairDesc& desc);

  /// Every instance starts in its rest pose with the head at the identity pose; its first pose puts it elsewhere, as
  /// teleport() does, and so does every other pose before the next step. The asset's bytes and `memory` must outlive
  /// this object; the Asset itself need not. Errors: kAssetLacksData (not open), kBadArgument (desc), kMemoryTooSmall
  /// (or not aligned).
  Status create(const Asset& asset, const HairDesc& desc, std::span<std::byte> memory);

  [[nodiscard]] std::uint32_t instance_count() const;
  [[nodiscard]] std::uint32_t bone_count() const;

  Status set_head(std::uint32_t instance, const HeadPose& pose) { return world_.set_head(head(instance), pose); }
  Status set_head(std::uint32_t instance, const HeadPose& pose, const HeadVelocity& velocity) {
    return world_.set_head(head(instance), pose, velocity);
  }
  /// Calls set_head(pose) for every instance, instance_count() poses, for crowds of which most stand still. A pose with
  /// the same bits as the last one costs one comparison. kSizeMismatch: nothing is set. kBadPose or kBadScale where
  /// poses are bad: those heads keep their last pose, the others are set.
  Status set_heads(std::span<const HeadPose> poses);
  Status reset(std::uint32_t instance, const HeadPose& pose) { return world_.reset(head(instance), pose); }
  Status teleport(std::uint32_t instance, const HeadPose& pose) { return world_.teleport(head(instance), pose); }
  Status set_detail(std::uint32_t instance, const Detail& detail) { return world_.set_detail(head(instance), detail); }
  [[nodiscard]] bool is_asleep(std::uint32_t instance) const { return world_.is_asleep(head(instance)); }

  Status step(const StepSettings& settings) { return world_.step(settings); }
  Status begin_step(const StepSettings& settings) { return world_.begin_step(settings); }
  [[nodiscard]] std::uint32_t job_count() const { return world_.job_count(); }  ///< One for sixteen heads.
  void run_job(std::uint32_t job) { world_.run_job(job); }
  void finish_step() { world_.finish_step(); }

  Status set_colliders(std::uint32_t instance, std::span<const MovingCollider> colliders) {
    return world_.set_colliders(head(instance), colliders);
  }
  Status set_body(std::uint32_t instance, std::span<const BodyPose> bones) {
    return world_.set_body(head(instance), bones);
  }
  Status set_pose(std::uint32_t instance, std::span<const Quat> rotations, std::span<const float> weights) {
    return world_.set_pose(head(instance), rotations, weights);
  }
  Status set_air(std::uint32_t instance, const HeadAir& air) { return world_.set_air(head(instance), air); }
  Status set_gusts(const Gusts& gusts) { return world_.set_gusts(gusts); }
  [[nodiscard]] double gusts_way() const { return world_.gusts_way(); }
  Status set_dynamics(std::uint32_t set, const DynamicsScale& scale) { return world_.set_dynamics(set, scale); }
  Status choose_dynamics(std::uint32_t instance, std::uint32_t set) {
    return world_.choose_dynamics(head(instance), set);
  }
  Status push(std::uint32_t instance, const Impulse& impulse) { return world_.push(head(instance), impulse); }
  Status settle(std::span<const std::uint32_t> instances, float seconds, const StepSettings& settings);
  Status settle(std::uint32_t instance, float seconds, const StepSettings& settings) {
    return settle(std::span(&instance, 1), seconds, settings);
  }

  [[nodiscard]] std::size_t saved_bytes() const { return world_.saved_bytes(); }
  Status save(std::span<std::byte> bytes) const { return world_.save(bytes); }
  Status restore(std::span<const std::byte> bytes) { return world_.restore(bytes); }

  [[nodiscard]] std::span<const Mat34> palette(std::uint32_t instance) const { return world_.palette(head(instance)); }
  Status bone_ends(std::uint32_t instance, std::span<Vec3> ends) const {
    return world_.bone_ends(head(instance), ends);
  }

 private:
  static WorldHead head(std::uint32_t instance) { return {instance, 1}; }

  HairWorld world_;
};

/// Steps several crowds with the same settings; stops at the first error.
Status step_all(std::span<Hair* const> crowds, const StepSettings& settings);

}  // namespace coif
