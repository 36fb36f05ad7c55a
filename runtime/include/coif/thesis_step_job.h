#pragma once

#include <coif/asset_records.h>
#include <coif/math.h>
#include <coif/particle.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

inline constexpr float kMaxTimeStep = 0.1f;  ///< Seconds; the thesis's own bound (5.2).
inline constexpr std::uint32_t kMaxIterations = 64;

/// What a step remembers about one simulated bone between its passes. Meaningless before and after.
struct BoneScratch {
  Vec3 position_before;    ///< Where the particle was, relative to where the head is now.
  Vec3 anchor;             ///< The bone's fixed start, for bones that hang from a rigid bone.
  Vec3 default_direction;  ///< Unit, from the start to the default position.
  Quat frame;              ///< Rotation from rest, world axes.
};

/// Advances the particles of one instance by one step of Algorithm 1, pass by pass as published (thesis 5.2). Reads
/// and writes only the spans below, allocates nothing and keeps no pointer after run(), so jobs with different
/// `particles` and `scratch` may run in parallel.
struct ThesisStepJob {
  float dt = 1.0f / 60.0f;           ///< Seconds, > 0, at most kMaxTimeStep.
  std::uint32_t iterations = 1;      ///< Times the length and collision passes run, 1..kMaxIterations.
  Vec3 gravity{0.0f, -9.81f, 0.0f};  ///< World, m/s^2.
  Vec3 air_velocity;                 ///< World, m/s; friction brakes towards it.
  Vec3 head_displacement;            ///< World, metres: the head's way during this step.
  Quat head_rotation;                ///< World from head space at the end of the step, unit.

  /// All bones of the asset, sorted as the format demands. The last particles.size() of them are the simulated ones,
  /// and the spans that are "per simulated bone" are in the same order.
  std::span<const BoneRecord> bones;
  std::span<const DynamicsRecord> dynamics;   ///< One per bone.
  /// What BoneRecord::colliders counts, at most kMaxColliders; empty costs nothing. Bits of a bone's set without a
  /// collider here are ignored.
  std::span<const ColliderRecord> colliders;
  std::span<const float> friction_factors;    ///< Per simulated bone; from compute_friction_factors().
  std::span<BoneScratch> scratch;             ///< Per simulated bone.
  std::span<Particle> particles;              ///< Per simulated bone; in and out.

  /// Ok when run() will not read or write out of range and its input is finite. Linear in the bones.
  [[nodiscard]] Status validate() const;

  /// Returns what validate() returns; unless that is kOk, `particles` are untouched. Finite input that is large
  /// enough to overflow can leave particles that are not finite: see all_finite().
  Status run() const;
};

/// Share of its velocity relative to the air that each simulated bone keeps during `dt`: exp(-friction * dt). The
/// linear 1 - friction * dt turns negative at large steps. Once per step, for all instances. `dynamics` has one
/// entry per bone, of which the last factors.size() are used; nothing is written where it has fewer.
void compute_friction_factors(std::span<const DynamicsRecord> dynamics, float dt, std::span<float> factors);

/// True when no particle has a NaN or an infinity.
[[nodiscard]] bool all_finite(std::span<const Particle> particles);

}  // namespace coif
