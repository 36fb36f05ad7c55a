// Colliders that hosts set: the game's, and, through the bones of a body, the asset's that hang on them.

#include <coif/hair.h>

#include "float_environment.h"
#include "rules.h"
#include "saved_collider.h"
#include "vector_math.h"
#include "world_heads.h"

#include <bit>

namespace coif {
namespace {

bool same_velocity(const MovingCollider& a, const MovingCollider& b) {
  if (a.is_velocity_known != b.is_velocity_known) return false;
  return !a.is_velocity_known || (a.velocity.linear == b.velocity.linear && a.velocity.angular == b.velocity.angular);
}

bool same_collider(const MovingCollider& a, const MovingCollider& b) {
  const bool same_place = a.center[0] == b.center[0] && a.center[1] == b.center[1] && a.center[2] == b.center[2];
  const bool same_shape = a.shape == b.shape && a.axis == b.axis && a.radius == b.radius &&
                          a.end_radius == b.end_radius && a.half_extents == b.half_extents;
  return same_place && same_shape && a.rotation == b.rotation && same_velocity(a, b);
}

/// One collider place of a head.
struct Place {
  Place(WorldState& all, std::uint32_t index, std::uint32_t place)
      : world(all),
        head(index),
        bit(std::uint64_t{1} << place),
        told(all.told_colliders(all.heads[index])[place]),
        there(all.colliders_of(all.heads[index]).there) {}

  [[nodiscard]] bool is_taken() const { return (there & bit) != 0; }
  [[nodiscard]] bool holds(const MovingCollider& collider) const {
    return is_taken() && same_collider(told.now, collider);
  }
  /// Whether hair of the head could touch the collider where it was set.
  [[nodiscard]] bool is_in_reach() const {
    const WornHead& worn = world.heads[head];
    const HeadLanes& heads = worn.block->heads;
    const double scale = 1.0 / double(heads.per_scale.v[worn.lane]);
    double distance2 = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double way = told.now.center[axis] - heads.next_position[axis][worn.lane];
      distance2 += way * way;
    }
    const double extent = double(told.extent) * (told.is_of_body ? scale : 1.0);
    const double reach = double(world.worn_by(worn).reach) * scale + extent;
    return told.keeps_inside || distance2 < reach * reach;
  }
  /// True for a sleeping head that is affected when this collider comes, goes or moves.
  [[nodiscard]] bool wakes() const { return world.heads[head].detail.asleep && is_taken() && is_in_reach(); }

  WorldState& world;
  std::uint32_t head;
  std::uint64_t bit;
  ToldCollider& told;
  std::uint64_t& there;
};

/// Sets the collider of this place; a sleeping head wakes where that matters.
void tell(const Place& place, const MovingCollider& next, bool is_of_body, bool keeps_inside) {
  ToldCollider& told = place.told;
  const bool woke = place.wakes();
  told.has_way = place.is_taken() && told.has_way && told.now.shape == next.shape;
  told.extent = extent_of(next);
  told.now = next;
  told.is_of_body = is_of_body;
  told.keeps_inside = keeps_inside;
  place.there |= place.bit;
  if (woke || place.wakes()) wake(place.world, place.head);
}

void take_away(const Place& place) {
  const bool woke = place.wakes();
  place.told.has_way = false;
  place.there &= ~place.bit;
  if (woke) wake(place.world, place.head);
}

/// A collider of the asset moved by its bone. `rest`: the bone's rest pose, from its own axes to head space.
MovingCollider carried_by(const ColliderRecord& record, const BodyBoneRecord& rest, const HeadPose& bone, float scale) {
  MovingCollider moved;
  const Quat to_bone = conjugate(to_quat(rest.rotation));
  const Vec3 center = rotate(to_bone, to_vec3(record.center) - to_vec3(rest.joint)) * scale;
  const Vec3 in_world = rotate(bone.rotation, center);
  moved.shape = record.shape;
  moved.center[0] = bone.position[0] + double(in_world.x);
  moved.center[1] = bone.position[1] + double(in_world.y);
  moved.center[2] = bone.position[2] + double(in_world.z);
  moved.rotation = renormalised(bone.rotation * to_bone * to_quat(record.rotation));
  moved.axis = rotate(conjugate(to_quat(record.rotation)), to_vec3(record.axis));
  moved.half_extents = to_vec3(record.radii);
  moved.radius = record.radii[0];
  moved.end_radius = record.radii[1];
  return moved;
}

}  // namespace

Status HairWorld::set_colliders(WorldHead head, std::span<const MovingCollider> colliders) {
  const WornHead* const worn = find(world_, head);
  if (worn == nullptr) return missing(world_);
  const WornAsset& asset = world_->worn_by(*worn);
  const std::uint32_t first = asset.body_colliders, room = asset.places - first;
  if (colliders.size() > room) return Status::kNotAsked;
  const FloatEnvironment plain;
  std::uint32_t changed = 0;  // A collider that is set again without a change was right before.
  for (std::uint32_t i = 0; i < colliders.size(); ++i) {
    if (Place(*world_, head.index, first + i).holds(colliders[i])) continue;
    if (const Status status = check(colliders[i]); status != Status::kOk) return status;
    changed |= 1u << i;
  }
  for (; changed != 0; changed &= changed - 1) {
    const auto i = std::uint32_t(std::countr_zero(changed));
    tell(Place(*world_, head.index, first + i), colliders[i], false, false);
  }
  if (asset.places == 0) return Status::kOk;  // The list must be empty, and it is.
  const auto next = first + std::uint32_t(colliders.size());
  const std::uint64_t there = world_->colliders_of(*worn).there;
  for (std::uint64_t gone = there >> next << next; gone != 0; gone &= gone - 1) {
    take_away(Place(*world_, head.index, std::uint32_t(std::countr_zero(gone))));
  }
  return Status::kOk;
}

Status HairWorld::set_body(WorldHead head, std::span<const BodyPose> bones) {
  const WornHead* const worn = find(world_, head);
  if (worn == nullptr) return missing(world_);
  const WornAsset& dressed = world_->worn_by(*worn);
  if (dressed.body_colliders == 0) return Status::kNotAsked;
  const Asset& asset = dressed.asset;
  if (bones.size() != asset.body_bones().size()) return Status::kSizeMismatch;
  const FloatEnvironment plain;
  HeadPose unit;
  for (const BodyPose& bone : bones) {
    const HeadPose pose{{bone.position[0], bone.position[1], bone.position[2]}, bone.rotation};
    if (normalise_pose(pose, unit) != Status::kOk) return Status::kBadPose;
  }
  const float scale = 1.0f / worn->block->heads.per_scale.v[worn->lane];
  for (std::uint32_t i = 0; i < dressed.body_colliders; ++i) {
    const ColliderRecord& record = asset.body_colliders()[i];
    const BodyPose& bone = bones[record.bone];
    (void)normalise_pose({{bone.position[0], bone.position[1], bone.position[2]}, bone.rotation}, unit);
    const MovingCollider next = carried_by(record, asset.body_bones()[record.bone], unit, scale);
    const Place place(*world_, head.index, i);
    if (!place.holds(next)) tell(place, next, true, (record.flags & kColliderKeepsInside) != 0);
  }
  return Status::kOk;
}

}  // namespace coif
