#include "lab/reference_model.h"

#include <algorithm>

namespace coif::lab {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// shortest_arc(), not made unit.
Quaterniond arc_between(const Vector3d& from, const Vector3d& to) {
  const double cosine = from.dot(to);
  const bool is_opposite = cosine < -1 + 1.0e-14;
  const Vector3d axis = is_opposite ? from.unitOrthogonal() : from.cross(to);
  return {is_opposite ? 0 : 1 + cosine, axis.x(), axis.y(), axis.z()};
}

/// Sine of the angle by which a bone is twisted against the shortest arc from its parent's frame; `direction` is the
/// bone's in that frame.
double sine_of_twist(const RigBone& bone, const Quaterniond& in_parent, const Vector3d& direction) {
  // Needs no unit length: only the ratio of its parts counts.
  const Quaterniond twist = in_parent * arc_between(bone.rest_direction, direction).conjugate();
  const double sine = twist.vec().dot(direction), cosine = twist.w();
  return 2 * sine * cosine / (sine * sine + cosine * cosine);
}

/// About the bone's own direction, 1/s, where its frame is the shortest arc from its parent's: the derivative of
/// shortest_arc() with both ends moving. Without bound where the bone folds over, as the arc flips there.
/// `arm`: the rest direction as the parent turns it.
double spin_of_arc(const BoneMotion& parent, const Vector3d& arm, const Vector3d& direction, const Vector3d& turning) {
  constexpr double kLeastUnfolded = 1.0e-7;  // Equal to the runtime's.
  const Vector3d swing = direction.cross(turning);
  const double along = (arm + direction).dot(parent.angular_velocity) - arm.dot(swing);
  return along / std::max(1 + arm.dot(direction), kLeastUnfolded);
}

/// Angular velocity about the bone's own direction, 1/s: the parent's, minus the decay of a twist.
double spin_of_twist(const RigBone& bone, const BoneMotion& parent, const Quaterniond& frame,
                     const Vector3d& direction) {
  const double carried = parent.angular_velocity.dot(direction);
  if (bone.torsion == 0) return carried;
  const Quaterniond to_parent = parent.frame.conjugate();
  const Vector3d in_parent = turned(to_parent, direction);
  // Weakened where the bone folds over: there the shortest arc turns with every small movement.
  const double unfolded = 0.5 * (1 + bone.rest_direction.dot(in_parent));
  return carried - bone.torsion * unfolded * sine_of_twist(bone, to_parent * frame, in_parent);
}

/// Acceleration of the mass at the bone's tail, m/s^2, without the force that keeps its length.
Vector3d load_on(const RigBone& bone, const SolverScene& scene, const motion::HeadState& head, const BoneTarget& target,
                 const Vector3d& direction, const Vector3d& turning, const Vector3d& parent_velocity) {
  const Vector3d air = scene.wind + head.velocity * bone.air_follow;
  return scene.gravity * bone.gravity_scale - bone.friction * (parent_velocity + bone.length * turning - air) -
         bone.length * (bone.stiffness * (direction - target.direction) + bone.damping * (turning - target.turning));
}

/// angular_velocity_of() a bone that points along `direction`.
Vector3d angular_velocity(const RigBone& bone, const BoneMotion& parent, const BoneState& state, const Vector3d& arm,
                          const Vector3d& direction) {
  const double spin = never_twists(bone) ? spin_of_arc(parent, arm, direction, state.turning)
                                         : spin_of_twist(bone, parent, state.frame, direction);
  return direction.cross(state.turning) + direction * spin;
}

/// target_of() a bone that its parent pulls along `with_parent`.
BoneTarget target_from(const RigBone& bone, const Vector3d& unbent, const Vector3d& with_parent,
                       const BoneMotion& parent, const motion::HeadState& head) {
  BoneTarget target{with_parent, parent.angular_velocity.cross(with_parent)};
  if (const double share = bone.parent_share; share != 1) {
    const Vector3d with_head = turned(head.rotation, unbent);
    target.direction = share * target.direction + (1 - share) * with_head;
    target.turning = share * target.turning + (1 - share) * head.angular_velocity.cross(with_head);
  }
  return target;
}

BoneRates rates_of(const RigBone& bone, const SolverScene& scene, const motion::HeadState& head, const BoneState& state,
                   const BoneMotion& parent, BoneMotion& motion) {
  motion.frame = state.frame.normalized();
  const Vector3d direction = turned(motion.frame, bone.rest_direction);
  const Vector3d arm = turned(parent.frame, bone.rest_direction);
  const Vector3d turning = across(state.turning, direction);
  const bool leans = !bone.leaning.isZero();
  const Vector3d with_parent = leans ? turned(parent.frame, bone.leaning) : arm;
  const BoneTarget target = target_from(bone, bone.pull_direction(), with_parent, parent, head);
  const Vector3d load = load_on(bone, scene, head, target, direction, turning, parent.velocity);
  const Vector3d turning_rate =
      across((load - parent.acceleration) / bone.length, direction) - direction * turning.squaredNorm();
  motion.end = parent.end + bone.length * direction;
  motion.velocity = parent.velocity + bone.length * turning;
  motion.acceleration = parent.acceleration + bone.length * turning_rate;
  motion.angular_velocity = angular_velocity(bone, parent, {motion.frame, turning}, arm, direction);
  const Vector3d half = 0.5 * motion.angular_velocity;
  return {(Quaterniond(0, half.x(), half.y(), half.z()) * state.frame).coeffs(), turning_rate};
}

}  // namespace

Quaterniond shortest_arc(const Vector3d& from, const Vector3d& to) { return arc_between(from, to).normalized(); }

BoneMotion motion_of_joint(const Vector3d& joint, const motion::HeadState& head) {
  const Vector3d arm = turned(head.rotation, joint);
  const Vector3d swing = head.angular_velocity.cross(arm);
  return {arm, head.velocity + swing,
          head.acceleration + head.angular_acceleration.cross(arm) + head.angular_velocity.cross(swing),
          head.angular_velocity, head.rotation};
}

BoneTarget target_of(const RigBone& bone, const BoneMotion& parent, const motion::HeadState& head) {
  return target_of(bone, bone.pull_direction(), parent, head);
}

BoneTarget target_of(const RigBone& bone, const Vector3d& unbent, const BoneMotion& parent,
                     const motion::HeadState& head) {
  return target_from(bone, unbent, turned(parent.frame, unbent), parent, head);
}

Vector3d angular_velocity_of(const RigBone& bone, const BoneMotion& parent, const BoneState& state) {
  const Vector3d direction = turned(state.frame, bone.rest_direction);
  return angular_velocity(bone, parent, state, turned(parent.frame, bone.rest_direction), direction);
}

Quaterniond frame_of_arc(const RigBone& bone, const Quaterniond& parent_frame, const Vector3d& direction) {
  return shortest_arc(turned(parent_frame, bone.rest_direction), direction) * parent_frame;
}

void free_rates(std::span<const RigBone> bones, const SolverScene& scene, const motion::HeadState& head,
                std::span<const BoneState> states, std::span<BoneMotion> motions, std::span<BoneRates> rates) {
  for (std::size_t i = 0; i < bones.size(); ++i) {
    const RigBone& bone = bones[i];
    if (bone.parent >= 0) {
      rates[i] = rates_of(bone, scene, head, states[i], motions[std::size_t(bone.parent)], motions[i]);
    } else {
      rates[i] = rates_of(bone, scene, head, states[i], motion_of_joint(bone.joint, head), motions[i]);
    }
  }
}

BoundedBone bounded(const RigBone& bone, const Eigen::Quaterniond& parent_frame, const Eigen::Vector3d& direction) {
  const float* const q = bone.limit.rotation;
  BoundedBone out{parent_frame, {direction}};
  if (bone.limit.kind == LimitKind::kUnlimited) return out;
  out.axes = parent_frame * Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized();
  out.at = bounded(bone.limit, turned(out.axes.conjugate(), direction));
  return out;
}

}  // namespace coif::lab
