#include "bone_contact.h"

#include "segment_contact.h"
#include "vector_math.h"

namespace coif {
namespace {

Vec3 across(const Vec3& velocity, const Vec3& direction) { return velocity - direction * dot(velocity, direction); }

/// The velocity of the contact's point into the collider is lost.
void stop_at_contact(const SegmentContact& contact, BoneContact& bone) {
  const float share = contact.along / bone.length;
  const Vec3 side = across(contact.normal, bone.direction);
  const float size2 = dot(side, side);
  if (!(size2 > 1e-6f && share > 1e-3f)) return;
  const Vec3 point = bone.start + bone.direction * contact.along;
  const Vec3 surface = cross(bone.head_turning, point);
  const float approach = dot(bone.start_velocity + bone.velocity * share - surface, contact.normal);
  if (!(approach < 0.0f)) return;
  // A contact stops a bone and never throws it: over a short lever, a start that sinks would give it any speed.
  const float own = dot(bone.velocity - cross(bone.head_turning, bone.direction * bone.length), side) / size2;
  const float lost = approach / (share * size2);
  bone.velocity = bone.velocity - side * (own > lost ? (own < 0.0f ? own : 0.0f) : lost);
}

}  // namespace

void keep_clear(const PlacedColliders& colliders, BoneContact& bone) {
  BoneSegment segment{bone.start, bone.direction, bone.length, bone.hit_radius};
  for (int round = 0; round < kContactRounds; ++round) {
    int touched = 0;
    colliders.for_each(bone.colliders, [&](const PlacedCollider& collider) {
      const SegmentContact contact = clear_segment(collider, bone.before, segment);
      if (!contact.touches) return;
      ++touched;
      bone.direction = segment.direction;
      bone.velocity = across(bone.velocity, bone.direction);
      stop_at_contact(contact, bone);
    });
    if (touched < 2) return;
  }
}

}  // namespace coif
