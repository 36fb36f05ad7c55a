#pragma once

#include <coif/asset_records.h>
#include <coif/head_track.h>
#include <coif/math.h>
#include <coif/particle.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

/// What one simulated bone remembers besides its particle. World axes where not said otherwise.
struct BoneSwing {
  Vec3 offset;           ///< Particle minus default position, metres.
  Vec3 target_velocity;  ///< Of the default position, m/s.
  Vec3 direction;        ///< Unit, start to particle, in the parent's frame.
  float twist_cos = 1;   ///< Of half the angle by which the bone's frame is turned about its direction against the
  float twist_sin = 0;   ///< shortest arc from its rest direction.
};

/// How a damped oscillator with a moving target answers within one step: exact for a target that moves on a cubic in
/// time and a constant load (runtime/docs/MODEL.md, "The step"). From compute_pose_responses().
struct PoseResponse {
  float offset_from_offset;      ///< 1
  float offset_from_velocity;    ///< s; also the velocity from a constant load.
  float offset_from_load;        ///< s^2
  float offset_from_bend;        ///< 1
  float velocity_from_offset;    ///< 1/s
  float velocity_from_velocity;  ///< 1
  float velocity_from_bend;      ///< 1/s
  float velocity_per_offset;     ///< 1/s: what a constant force that moves the particle by 1 m leaves behind; within 2/dt.
};

/// Advances the particles of one instance by one step of the model in runtime/docs/MODEL.md: one pass from root to tip,
/// without stretch and without penetration. Reads and writes only the spans below, allocates nothing and keeps no
/// pointer after run(), so jobs with different `particles`, `swings` and `frames` may run in parallel.
struct CoifStepJob {
  float dt = 1.0f / 60.0f;           ///< Seconds, > 0, at most kMaxTimeStep.
  Vec3 gravity{0.0f, -9.81f, 0.0f};  ///< World, m/s^2.
  Vec3 air_velocity;                 ///< World, m/s; friction brakes towards it.
  HeadMove head;                     ///< What the head does during this step.
  float friction_scale = 1;          ///< As given to compute_pose_responses().

  /// All bones of the asset, sorted as the format demands. The last particles.size() of them are the simulated ones,
  /// and the spans that are "per simulated bone" are in the same order.
  std::span<const BoneRecord> bones;
  std::span<const DynamicsRecord> dynamics;   ///< One per bone.
  std::span<const ColliderRecord> colliders;  ///< As for ThesisStepJob.
  std::span<const PoseResponse> responses;    ///< Per simulated bone, for this dt.
  std::span<Particle> particles;              ///< Per simulated bone; in and out.
  std::span<BoneSwing> swings;                ///< Per simulated bone; in and out.
  std::span<Quat> frames;                     ///< Out, per simulated bone: rotation from rest, world axes.
  std::span<Vec3> angular_velocities;         ///< Scratch, per simulated bone.
  std::span<Vec3> positions_before;           ///< Scratch, per simulated bone.

  /// Ok when run() will not read or write out of range and its input is finite. Linear in the bones.
  [[nodiscard]] Status validate() const;

  /// Returns what validate() returns; unless that is kOk, the state is untouched. Finite input that is large enough to
  /// overflow can leave particles that are not finite: see all_finite().
  Status run() const;
};

/// Factors on what the asset's dynamics say; for parameters that a game changes while it runs.
struct DynamicsScale {
  float stiffness = 1;  ///< >= 0
  float damping = 1;    ///< >= 0
  float friction = 1;   ///< >= 0
};

/// Once per step length, for all instances. `dynamics` has one entry per bone, of which the last responses.size() are
/// used; nothing is written where it has fewer.
void compute_pose_responses(std::span<const DynamicsRecord> dynamics, float dt, const DynamicsScale& scale,
                            std::span<PoseResponse> responses);

/// Sets `swings` for particles that something else has moved: another solver, a reset, a teleport. Untwisted; default
/// positions move as the particles' velocities say. `head_rotation` and the head's velocities: as they are now.
void swings_from_particles(std::span<const BoneRecord> bones, std::span<const DynamicsRecord> dynamics,
                           const HeadMove& head, std::span<const Particle> particles, std::span<BoneSwing> swings,
                           std::span<Quat> frames, std::span<Vec3> angular_velocities);

}  // namespace coif
