#include <coif/thesis_step_job.h>

#include "bone_frame.h"
#include "head_pose.h"
#include "placed_colliders.h"
#include "simulated_bones.h"
#include "vector_math.h"

#include <cmath>

namespace coif {
namespace {

/// Lines 1-4: forces to velocity, velocity to position.
void apply_forces(const ThesisStepJob& job) {
  const auto dynamics = job.dynamics.last(job.particles.size());
  for (std::size_t i = 0; i < job.particles.size(); ++i) {
    Particle& particle = job.particles[i];
    // Positions are relative to the head: when the head moves one way, everything else moves the other way.
    const Vec3 before = particle.position - job.head_displacement;
    const Vec3 falling = particle.velocity + job.gravity * (dynamics[i].gravity_scale * job.dt);
    particle.velocity = job.air_velocity + (falling - job.air_velocity) * job.friction_factors[i];
    particle.position = before + particle.velocity * job.dt;
    job.scratch[i].position_before = before;
  }
}

/// Lines 5-8: towards the default position. Parents come first, so each bone sees its parent already pulled. The
/// resistance is taken per step, whatever the step's length: the published method has no correction.
void pull_to_default(const ThesisStepJob& job) {
  const SimulatedBones bones(job.bones, job.particles.size());
  const auto dynamics = job.dynamics.last(bones.count());
  for (std::size_t i = 0; i < bones.count(); ++i) {
    const BoneRecord& bone = bones[i];
    BoneScratch& scratch = job.scratch[i];
    const bool is_first = bones.hangs_from_rigid(i);
    if (is_first) scratch.anchor = rotate(job.head_rotation, to_vec3(bone.joint));
    const Vec3 start = is_first ? scratch.anchor : job.particles[bones.parent(i)].position;
    const Quat parent_frame = is_first ? job.head_rotation : job.scratch[bones.parent(i)].frame;
    const Vec3 rest_direction = to_vec3(bone.rest_direction);
    scratch.default_direction = rotate(parent_frame, rest_direction);

    Vec3& position = job.particles[i].position;
    const Vec3 default_position = start + scratch.default_direction * bone.length;
    position = position + (default_position - position) * dynamics[i].resistance;
    const Vec3 direction = direction_or(position - start, scratch.default_direction);
    scratch.frame = bend_frame(parent_frame, rest_direction, scratch.default_direction, direction);
  }
}

/// Lines 9-12: particle and parent each take half of the length error; a fixed start takes nothing.
void keep_lengths(const ThesisStepJob& job) {
  const SimulatedBones bones(job.bones, job.particles.size());
  for (std::size_t i = 0; i < bones.count(); ++i) {
    const bool is_first = bones.hangs_from_rigid(i);
    Vec3& position = job.particles[i].position;
    const Vec3 offset = position - (is_first ? job.scratch[i].anchor : job.particles[bones.parent(i)].position);
    const Vec3 direction = direction_or(offset, job.scratch[i].default_direction);
    const Vec3 error = direction * (length(offset) - bones[i].length);
    if (is_first) {
      position = position - error;
    } else {
      Vec3& parent = job.particles[bones.parent(i)].position;
      position = position - error * 0.5f;
      parent = parent + error * 0.5f;
    }
  }
}

/// Lines 13-16, for whatever the asset has where the thesis has a head.
void keep_clear(const ThesisStepJob& job, const PlacedColliders& colliders) {
  const SimulatedBones bones(job.bones, job.particles.size());
  const auto dynamics = job.dynamics.last(bones.count());
  for (std::size_t i = 0; i < bones.count(); ++i) {
    if (bones[i].colliders == 0) continue;
    Vec3& position = job.particles[i].position;
    position = colliders.clear(bones[i].colliders, dynamics[i].hit_radius, position);
  }
}

/// Lines 17-19.
void renew_velocities(const ThesisStepJob& job) {
  const float per_second = 1.0f / job.dt;
  for (std::size_t i = 0; i < job.particles.size(); ++i) {
    Particle& particle = job.particles[i];
    particle.velocity = (particle.position - job.scratch[i].position_before) * per_second;
  }
}

bool sizes_match(const ThesisStepJob& job) {
  const std::size_t count = job.particles.size();
  return count <= job.bones.size() && job.dynamics.size() == job.bones.size() && job.friction_factors.size() == count &&
         job.scratch.size() == count;
}

}  // namespace

Status ThesisStepJob::validate() const {
  if (!(dt > 0.0f && dt <= kMaxTimeStep)) return Status::kBadTimeStep;
  if (colliders.size() > kMaxColliders) return Status::kBadArgument;
  if (iterations < 1 || iterations > kMaxIterations) return Status::kBadArgument;
  if (!is_finite(gravity) || !is_finite(air_velocity) || !is_finite(head_displacement)) return Status::kBadArgument;
  if (!is_unit(head_rotation)) return Status::kBadPose;
  if (particles.empty()) return Status::kOk;
  if (!sizes_match(*this)) return Status::kSizeMismatch;
  return SimulatedBones(bones, particles.size()).parents_come_first() ? Status::kOk : Status::kBadIndex;
}

Status ThesisStepJob::run() const {
  if (const Status status = validate(); status != Status::kOk) return status;
  apply_forces(*this);
  pull_to_default(*this);
  const PlacedColliders placed(colliders, head_rotation);
  // The pull is a weight, not a constraint: repeated n times it would be 1 - (1 - resistance)^n, and more iterations
  // would mean stiffer hair. Lengths and head are what the thesis iterates "to get a closer approximation".
  for (std::uint32_t pass = 0; pass < iterations; ++pass) {
    keep_lengths(*this);
    if (!colliders.empty()) keep_clear(*this, placed);
  }
  renew_velocities(*this);
  return Status::kOk;
}

void compute_friction_factors(std::span<const DynamicsRecord> dynamics, float dt, std::span<float> factors) {
  if (dynamics.size() < factors.size()) return;
  const auto simulated = dynamics.last(factors.size());
  for (std::size_t i = 0; i < factors.size(); ++i) factors[i] = std::exp(-simulated[i].friction * dt);
}

bool all_finite(std::span<const Particle> particles) {
  for (const Particle& particle : particles) {
    if (!is_finite(particle.position) || !is_finite(particle.velocity)) return false;
  }
  return true;
}

}  // namespace coif
