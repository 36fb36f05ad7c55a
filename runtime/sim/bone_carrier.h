#pragma once
// What a bone hangs from and where it wants to be: the part of the model that a step and its start have in common.

#include "vector_math.h"

#include <coif/asset_records.h>
#include <coif/head_track.h>

namespace coif {

/// What a bone hangs from, at the end of the step: its parent's tail, or its joint on the head.
struct Carrier {
  Vec3 position;
  Vec3 position_before;  ///< At the start of the step, from where the head was then.
  Vec3 velocity;
  Quat frame;
  Vec3 angular_velocity;
};

/// The default position and its velocity, and the directions it is made of.
struct Target {
  Vec3 by_parent;  ///< Unit: the rest direction in the parent's frame.
  Vec3 position;
  Vec3 velocity;
};

inline Carrier carrier_of(const HeadMove& head, const Vec3& joint) {
  Carrier carrier;
  carrier.position = rotate(head.rotation, joint);
  carrier.position_before = rotate(head.rotation_before, joint);
  carrier.velocity = head.velocity + cross(head.angular_velocity, carrier.position);
  carrier.frame = head.rotation;
  carrier.angular_velocity = head.angular_velocity;
  return carrier;
}

inline Target target_of(const HeadMove& head, const Carrier& carrier, const BoneRecord& bone, float parent_share) {
  const Vec3 rest = to_vec3(bone.rest_direction);
  Target target;
  target.by_parent = rotate(carrier.frame, rest);
  Vec3 arm = target.by_parent, swing = cross(carrier.angular_velocity, arm);
  if (parent_share != 1.0f) {
    const Vec3 by_head = rotate(head.rotation, rest);
    arm = by_head + (arm - by_head) * parent_share;
    const Vec3 with_head = cross(head.angular_velocity, by_head);
    swing = with_head + (swing - with_head) * parent_share;
  }
  target.position = carrier.position + arm * bone.length;
  target.velocity = carrier.velocity + swing * bone.length;
  return target;
}

/// Takes away what of `velocity` (of the tail, relative to the carrier) would stretch the bone.
inline Vec3 across(const Vec3& velocity, const Vec3& direction) {
  return velocity - direction * dot(velocity, direction);
}

}  // namespace coif
