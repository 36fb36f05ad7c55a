#include <coif/coif_step_job.h>

#include "bone_carrier.h"
#include "bone_frame.h"
#include "head_pose.h"
#include "placed_colliders.h"
#include "rotation_vector.h"
#include "segment_contact.h"
#include "simulated_bones.h"
#include "tilt.h"
#include "vector_math.h"

#include <coif/thesis_step_job.h>

#include <cmath>

namespace coif {
namespace {

/// One bone on its way through the step.
struct BoneState {
  Vec3 direction;  ///< Unit.
  Vec3 velocity;   ///< Of the tail, relative to the carrier's.
};

/// Where the force along the bone brings the tail, `free` metres from the carrier without it, and the distance that
/// takes. The force has the mean direction of the bone over the step: with either end's the method is of first order.
struct Constrained {
  Vec3 direction;  ///< Unit.
  Vec3 way;        ///< From the free to the constrained position, metres.
};

Constrained keep_length(const Vec3& free, const Vec3& direction_before, float bone_length) {
  const float per_length = 1.0f / bone_length;
  const Vec3 mean = free * per_length + direction_before;  // no need of unit length: the root below is homogeneous
  const float mean2 = dot(mean, mean);
  const float along = dot(free, mean);
  const float excess = dot(free, free) - bone_length * bone_length;
  const float root2 = along * along - mean2 * excess;
  // A free end far to the side, or behind the start, has no sensible mean: straight to the length instead.
  if (!(along * along > 0.1f * mean2 * bone_length * bone_length && along > 0.0f && root2 > 0.0f)) {
    // Straight back through the start it cannot go: balanced on that line it stays, off it the next step finds the side.
    // Far from the head, where the bone is shorter than a float resolves, its direction before is not of unit length.
    const Vec3 before = direction_or(direction_before, Vec3{0.0f, -1.0f, 0.0f});
    const Vec3 straight = direction_or(free, before);
    const Vec3 now = dot(straight, before) < -0.9999f ? before : straight;
    return {now, now * bone_length - free};
  }
  const Vec3 way = mean * (-excess / (along + std::sqrt(root2)));
  const Vec3 kept = (free + way) * per_length;
  const float size2 = dot(kept, kept);
  // Unit but for rounding, for which one step of Newton's method does; unless a free end many lengths away left only that.
  if (std::fabs(size2 - 1.0f) < 1e-3f) return {kept * (1.5f - 0.5f * size2), way};
  const Vec3 straight = direction_or(kept, direction_before);
  return {straight, straight * bone_length - free};
}

/// Undoes what rounding does to the length of a product of unit quaternions.
Quat nearly_unit(const Quat& q) {
  const float scale = 1.5f - 0.5f * (q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

/// The velocity of the contact's point into the collider, which turns with the head, is lost.
void stop_at_contact(const SegmentContact& contact, const HeadMove& head, const Carrier& carrier, float bone_length,
                     BoneState& bone) {
  const float share = contact.along / bone_length;
  const Vec3 side = across(contact.normal, bone.direction);
  const float size2 = dot(side, side);
  if (!(size2 > 1e-6f && share > 1e-3f)) return;
  const Vec3 point = carrier.position + bone.direction * contact.along;
  const Vec3 surface = head.velocity + cross(head.angular_velocity, point);
  const float approach = dot(carrier.velocity + bone.velocity * share - surface, contact.normal);
  if (!(approach < 0.0f)) return;
  // A contact stops a bone and never throws it: over a short lever, a start that sinks would give it any speed.
  const float own = dot(bone.velocity - cross(head.angular_velocity, bone.direction * bone_length), side) / size2;
  const float lost = approach / (share * size2);
  bone.velocity = bone.velocity - side * (own > lost ? (own < 0.0f ? own : 0.0f) : lost);
}

/// Several colliders push each other's results about: until all agree, or often enough.
constexpr int kContactRounds = 4;

class Step {
 public:
  explicit Step(const CoifStepJob& job)
      : job_(job), bones_(job.bones, job.particles.size()), colliders_(job.colliders, job.head.rotation) {
    turn_ = job.head.rotation * conjugate(job.head.rotation_before);
  }

  void run() {
    const auto dynamics = job_.dynamics.last(bones_.count());
    for (std::size_t i = 0; i < bones_.count(); ++i) advance(i, dynamics[i]);
  }

 private:
  Carrier carrier(std::size_t i) const {
    if (bones_.hangs_from_rigid(i)) return carrier_of(job_.head, to_vec3(bones_[i].joint));
    const std::size_t parent = bones_.parent(i);
    const Particle& particle = job_.particles[parent];
    return {particle.position, job_.positions_before[parent], particle.velocity, job_.frames[parent],
            job_.angular_velocities[parent]};
  }

  void advance(std::size_t i, const DynamicsRecord& dynamics) {
    const BoneRecord& record = bones_[i];
    Particle& particle = job_.particles[i];
    BoneSwing& swing = job_.swings[i];
    const Carrier from = carrier(i);
    const Vec3 position_before = particle.position;
    const Vec3 direction_before = (position_before - from.position_before) * (1.0f / record.length);
    const Target target = target_of(job_.head, from, record, dynamics.parent_share);

    BoneState bone = move_freely(i, dynamics, from, target, direction_before);
    if (dynamics.angle_limit < kNoAngleLimit) keep_in_limit(dynamics.angle_limit, from, target, bone);
    if (record.colliders != 0) keep_clear(record, dynamics.hit_radius, from, rotate(turn_, direction_before), bone);

    particle.position = from.position + bone.direction * record.length;
    particle.velocity = from.velocity + bone.velocity;
    swing.offset = particle.position - target.position;
    swing.target_velocity = target.velocity;
    job_.positions_before[i] = position_before;
    turn_frame(i, dynamics.torsion, from, target, bone);
  }

  /// The exact answer of the oscillator about the moving default position, then the force that keeps the length.
  BoneState move_freely(std::size_t i, const DynamicsRecord& dynamics, const Carrier& from, const Target& target,
                        const Vec3& direction_before) const {
    const PoseResponse& r = job_.responses[i];
    const BoneSwing& swing = job_.swings[i];
    const float dt = job_.dt;
    const float friction = dynamics.friction * job_.friction_scale;
    const Vec3 target_before = job_.particles[i].position - swing.offset - job_.head.displacement;
    const Vec3 mean_velocity = (swing.target_velocity + target.velocity) * 0.5f;
    const Vec3 gain = target.velocity - swing.target_velocity;
    // How far the default position's path is from one of constant acceleration; the drag's own change counts with it.
    const Vec3 bend =
        mean_velocity * dt - (target.position - target_before) + gain * (friction * dt * dt * (1.0f / 12.0f));
    const Vec3 load =
        job_.gravity * dynamics.gravity_scale + (job_.air_velocity - mean_velocity) * friction - gain * (1.0f / dt);
    const Vec3 speed = job_.particles[i].velocity - swing.target_velocity;
    const Vec3 offset = swing.offset * r.offset_from_offset + speed * r.offset_from_velocity +
                        load * r.offset_from_load + bend * r.offset_from_bend;
    const Vec3 velocity = swing.offset * r.velocity_from_offset + speed * r.velocity_from_velocity +
                          load * r.offset_from_velocity + bend * r.velocity_from_bend;

    const Constrained kept = keep_length(target.position + offset - from.position, direction_before, bones_[i].length);
    const Vec3 relative = target.velocity + velocity + kept.way * r.velocity_per_offset - from.velocity;
    return {kept.direction, across(relative, kept.direction)};
  }

  static void keep_in_limit(float limit, const Carrier& from, const Target& target, BoneState& bone) {
    const Vec3 axis = direction_or(target.position - from.position, target.by_parent);
    const float cosine = std::cos(limit);
    if (!(dot(bone.direction, axis) < cosine)) return;
    const Vec3 limited = tilted(bone.direction, axis, cosine, bone.direction);
    const Vec3 inwards = axis - limited * dot(axis, limited);
    bone.direction = limited;
    bone.velocity = across(bone.velocity, limited);
    // Against the stop, the bone moves as its default position does.
    const float size2 = dot(inwards, inwards);
    if (!(size2 > 1e-6f)) return;
    const float leaving = dot(bone.velocity - (target.velocity - from.velocity), inwards);
    if (leaving < 0.0f) bone.velocity = bone.velocity - inwards * (leaving / size2);
  }

  void keep_clear(const BoneRecord& record, float hit_radius, const Carrier& from, const Vec3& before,
                  BoneState& bone) const {
    BoneSegment segment{from.position, bone.direction, record.length, hit_radius};
    for (int round = 0; round < kContactRounds; ++round) {
      int touched = 0;
      colliders_.for_each(record.colliders, [&](const PlacedCollider& collider) {
        const SegmentContact contact = clear_segment(collider, before, segment);
        if (!contact.touches) return;
        ++touched;
        bone.direction = segment.direction;
        bone.velocity = across(bone.velocity, bone.direction);
        stop_at_contact(contact, job_.head, from, record.length, bone);
      });
      if (touched < 2) return;
    }
  }

  /// Carries the frame along: without any twist from one direction to the next, seen from the parent, then back towards
  /// the shortest arc from rest at the rate `torsion`. The arc alone would flip when the bone folds over its parent.
  void turn_frame(std::size_t i, float torsion, const Carrier& from, const Target& target, const BoneState& bone) {
    BoneSwing& swing = job_.swings[i];
    const Vec3 rest = to_vec3(bones_[i].rest_direction);
    const Vec3 before = swing.direction;
    const Vec3 now = rotate(conjugate(from.frame), bone.direction);
    const float fold = 0.5f * (1.0f + dot(target.by_parent, bone.direction));  // 1 at rest, 0 folded over

    // The triangle rest, before, now on the unit sphere turns what is carried around it by its area (Oosterom, Strackee).
    const float area_sin = dot(rest, cross(before, now));
    const float area_cos = 1.0f + dot(rest, before) + dot(before, now) + dot(now, rest);
    float twist_cos = swing.twist_cos * area_cos - swing.twist_sin * area_sin;
    float twist_sin = swing.twist_sin * area_cos + swing.twist_cos * area_sin;
    const float decay = torsion * fold * job_.dt;
    twist_sin /= 1.0f + decay * (1.0f + 0.5f * decay);
    const float size2 = twist_cos * twist_cos + twist_sin * twist_sin;
    const bool defined = size2 > 1e-12f;
    const float scale = defined ? 1.0f / std::sqrt(size2) : 1.0f;
    swing.twist_cos = defined ? twist_cos * scale : 1.0f;
    swing.twist_sin = defined ? twist_sin * scale : 0.0f;
    swing.direction = now;

    const Vec3& d = bone.direction;
    const Quat twist{d.x * swing.twist_sin, d.y * swing.twist_sin, d.z * swing.twist_sin, swing.twist_cos};
    const Quat arc = bend_frame(from.frame, rest, target.by_parent, d);
    job_.frames[i] = nearly_unit(twist * arc);
    const float unwinding = torsion * fold * 2.0f * swing.twist_sin * swing.twist_cos;
    job_.angular_velocities[i] =
        cross(d, bone.velocity) * (1.0f / bones_[i].length) + d * (dot(d, from.angular_velocity) - unwinding);
  }

  const CoifStepJob& job_;
  SimulatedBones bones_;
  PlacedColliders colliders_;
  Quat turn_;  ///< Of the head during the step.
};

bool sizes_match(const CoifStepJob& job) {
  const std::size_t count = job.particles.size();
  return count <= job.bones.size() && job.dynamics.size() == job.bones.size() && job.responses.size() == count &&
         job.swings.size() == count && job.frames.size() == count && job.angular_velocities.size() == count &&
         job.positions_before.size() == count;
}

bool head_is_finite(const HeadMove& head) {
  return is_finite(head.displacement) && is_finite(head.velocity) && is_finite(head.angular_velocity);
}

}  // namespace

Status CoifStepJob::validate() const {
  if (!(dt > 0.0f && dt <= kMaxTimeStep)) return Status::kBadTimeStep;
  if (colliders.size() > kMaxColliders) return Status::kBadArgument;
  if (!is_finite(gravity) || !is_finite(air_velocity) || !head_is_finite(head)) return Status::kBadArgument;
  if (!(friction_scale >= 0.0f) || !std::isfinite(friction_scale)) return Status::kBadArgument;
  if (!is_unit(head.rotation) || !is_unit(head.rotation_before)) return Status::kBadPose;
  if (particles.empty()) return Status::kOk;
  if (!sizes_match(*this)) return Status::kSizeMismatch;
  return SimulatedBones(bones, particles.size()).parents_come_first() ? Status::kOk : Status::kBadIndex;
}

Status CoifStepJob::run() const {
  if (const Status status = validate(); status != Status::kOk) return status;
  Step(*this).run();
  return Status::kOk;
}

}  // namespace coif
