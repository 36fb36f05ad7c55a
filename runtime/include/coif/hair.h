#pragma once

#include <coif/asset.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

inline constexpr float kMaxTimeStep = 0.1f;  ///< Seconds; the thesis's own bound (5.2).

enum class Solver : std::uint8_t {
  kThesis = 0,  ///< Algorithm 1 exactly as published (thesis 5.2).
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
  float dt = 1.0f / 60.0f;  ///< Seconds, > 0, at most kMaxTimeStep.
  Solver solver = Solver::kThesis;
  std::uint32_t iterations = 1;  ///< Passes over the length and head constraints, 1..64.
  Environment environment;
};

struct HairDesc {
  std::uint32_t instances = 1;  ///< Heads that wear this asset, 1..1'000'000.
};

struct MemoryNeed {
  std::size_t bytes = 0;
  std::size_t alignment = 64;
};

/// A crowd of instances of one asset: state, simulation, bone matrices. Allocates nothing: the caller gives memory
/// once, create() carves it up. Not thread safe; different Hair objects are independent.
class Hair {
 public:
  /// Exact need of create() for this asset; zero bytes for arguments that create() refuses.
  [[nodiscard]] static MemoryNeed memory_need(const Asset& asset, const HairDesc& desc);

  /// Every instance starts in its rest pose with the head at the identity pose. The asset's bytes and `memory` must
  /// outlive this object.
  Status create(const Asset& asset, const HairDesc& desc, std::span<std::byte> memory);

  [[nodiscard]] std::uint32_t instance_count() const { return instances_; }
  [[nodiscard]] std::uint32_t bone_count() const { return bone_count_; }

  /// Where the head is at the end of the next step. The step moves it there from where it was.
  Status set_head(std::uint32_t instance, const HeadPose& pose);

  /// Puts the head at `pose` and the hair into its rest pose there, at rest.
  Status reset(std::uint32_t instance, const HeadPose& pose);

  /// Advances every instance by settings.dt and renews the matrices.
  Status step(const StepSettings& settings);

  /// Skinning matrices, bone_count() of them: rest pose in head space -> current pose in head space. Draw them under
  /// the head's world transform. Valid until the next call of step() or reset(); empty for a bad index.
  [[nodiscard]] std::span<const Mat34> palette(std::uint32_t instance) const;

  /// Where each bone's particle is (rigid bones: their joint), head space, metres; empty for a bad index.
  [[nodiscard]] std::span<const Vec3> bone_ends(std::uint32_t instance) const;

 private:
  std::uint32_t instances_ = 0;
  std::uint32_t bone_count_ = 0;
};

}  // namespace coif
