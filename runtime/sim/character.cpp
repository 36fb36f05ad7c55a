// What hosts say of the character that wears the hair, and how it gets to the bones: bodies, the game's colliders, poses.

#include <coif/hair.h>

#include "crowd_step.h"
#include "float_environment.h"
#include "memory_carver.h"
#include "vector_math.h"

#include <cstring>

namespace coif {
namespace {

std::uint32_t body_colliders_of(const Asset& asset) { return std::uint32_t(asset.body_colliders().size()); }

void carve(MemoryCarver& carver, const Asset& asset, const HairDesc& desc, std::uint64_t states, std::uint32_t blocks,
           CharacterState& character) {
  character.body_colliders = desc.follows_body ? body_colliders_of(asset) : 0;
  character.places = character.body_colliders + desc.moving_colliders;
  const std::uint64_t places = std::uint64_t(desc.instances) * character.places;
  character.told = carver.take<ToldCollider>(places);
  character.ways = carver.take<ColliderWay>(places);
  character.way_counts = carver.take<std::uint32_t>(character.places != 0 ? desc.instances : 0);
  character.most_ways = carver.take<std::uint32_t>(character.places != 0 ? blocks : 0);
  character.bounds = carver.take<ColliderBounds>(std::uint64_t(blocks) * character.places);
  const LaneOrder order = choose_lane_order(asset, *desc.solver, desc.instances);
  const std::uint64_t row_bones = count_rows(asset, *desc.solver, order).bones;
  character.body_sets = carver.take<std::uint32_t>(character.body_colliders != 0 ? row_bones * kLanes : 0);
  character.poses = carver.take<PoseLanes>(desc.follows_poses ? states : 0);
  character.is_posed = carver.take<std::uint8_t>(desc.follows_poses ? desc.instances : 0);
}

/// The rest pose, at which nothing pulls but what would anyway.
void set_rest_pose(PoseLanes& pose, std::uint32_t lane, const Vec3& pull) {
  set_lane(pose.before, lane, Quat{});
  set_lane(pose.now, lane, Quat{});
  set_lane(pose.pull_before, lane, pull);
  set_lane(pose.pull_now, lane, pull);
  pose.weight.v[lane] = 1.0f;
}

/// How far from the head's position the bones of a chain get, whatever way they are turned.
float reach_of(const Asset& asset, const ChainRecord& chain) {
  float most = 0;
  float lengths = 0;
  for (std::uint32_t bone = chain.first_bone; bone < chain.first_bone + chain.bone_count; ++bone) {
    const BoneRecord& record = asset.bones()[bone];
    lengths += record.length + asset.dynamics()[bone].hit_radius;
    const float joint = length(to_vec3(record.joint));
    most = joint > most ? joint : most;
  }
  return most + lengths;
}

void create(CrowdState& crowd) {
  CharacterState& character = crowd.character;
  const Asset& asset = crowd.asset;
  character.code = &kCharacterCode;
  for (const ChainRecord& chain : asset.chains()) {
    const float reach = reach_of(asset, chain);
    character.reach = reach > character.reach ? reach : character.reach;
  }
  const std::size_t row_bones = crowd.row_bone_count();
  for (std::size_t i = 0; i < character.poses.size(); ++i) {
    const BoneLanes& constants = crowd.constants[i % row_bones];
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      set_rest_pose(character.poses[i], lane, coif::lane(constants.pull, lane));
    }
  }
  if (character.body_sets.empty()) return;
  for (const Row& row : crowd.rows) {
    for (std::uint32_t i = 0; i < row.bone_count; ++i) {
      for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
        const std::uint32_t bone = bone_in_lane(asset, row, i, lane);
        character.body_sets[(row.first_bone + i) * kLanes + lane] = asset.body_sets()[bone];
      }
    }
  }
}

bool any_posed(const CrowdState& crowd, const Block& block) {
  if (crowd.character.is_posed.empty()) return false;
  for (std::uint32_t i = 0; i < block.count; ++i) {
    if (crowd.character.is_posed[block.instance[i]] != 0) return true;
  }
  return false;
}

void set_up(const CrowdState& crowd, std::uint32_t index, std::int32_t only_head, const Row& row, std::size_t state,
            RowCharacter& to) {
  const CharacterState& from = crowd.character;
  const Block& block = crowd.blocks[index];
  const bool by_heads = only_head < 0;
  to.only_head = only_head;
  to.body_colliders = from.body_colliders;
  to.poses = any_posed(crowd, block) ? &from.poses[state] : nullptr;
  to.collider_count = 0;
  if (from.places == 0) return;
  to.bounds = &from.bounds[std::size_t(index) * from.places];
  to.body_sets = from.body_sets.empty() ? nullptr : &from.body_sets[std::size_t(row.first_bone) * kLanes];
  to.collider_count = by_heads ? from.most_ways[index] : from.way_counts[block.instance[only_head]];
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    const std::uint32_t head = by_heads ? (i < block.count ? i : 0) : std::uint32_t(only_head);
    const std::uint32_t instance = block.instance[head];
    to.of_lane[i] = &from.ways[std::size_t(instance) * from.places];
    to.counts[i] = from.way_counts[instance];
  }
}

void arrive(PoseLanes& pose, std::uint32_t lane) {
  set_lane(pose.before, lane, coif::lane(pose.now, lane));
  set_lane(pose.pull_before, lane, coif::lane(pose.pull_now, lane));
}

/// Calls visit(bone of the asset, PoseLanes, lane, constants, lane of those, bone in the row) for each simulated bone of a head.
template <typename Visit>
void for_each_pose(CrowdState& crowd, std::uint32_t slot, const Visit& visit) {
  const std::size_t first = crowd.first_state(slot);
  for (const Row& row : crowd.rows) {
    for (std::uint32_t chain = 0; chain < row.chain_count; ++chain) {
      const std::uint32_t lane = crowd.order == LaneOrder::kHeads ? slot % kLanes : chain;
      for (std::uint32_t i = 0; i < row.bone_count; ++i) {
        const std::uint32_t bone = bone_in_lane(crowd.asset, row, i, chain);
        const std::size_t at = row.first_bone + i;
        visit(bone, row.first_chain + chain, crowd.character.poses[first + at], lane,
              coif::lane(crowd.constants[at].pull, chain));
      }
    }
  }
}

/// Poses that were reached are what the next step begins with.
void finish(CrowdState& crowd, std::uint32_t index) {
  const Block& block = crowd.blocks[index];
  if (!any_posed(crowd, block)) return;
  for (std::uint32_t i = 0; i < block.count; ++i) {
    if (crowd.character.is_posed[block.instance[i]] == 0) continue;
    for_each_pose(
        crowd, index * kLanes + i,
        [](std::uint32_t, std::uint32_t, PoseLanes& pose, std::uint32_t lane, const Vec3&) { arrive(pose, lane); });
  }
}

void appear(CrowdState& crowd, std::uint32_t slot) {
  CharacterState& character = crowd.character;
  const std::uint32_t instance = crowd.blocks[slot / kLanes].instance[slot % kLanes];
  for (std::uint32_t place = 0; place < character.places; ++place) {
    character.told[std::size_t(instance) * character.places + place].has_way = false;
  }
  if (character.is_posed.empty() || character.is_posed[instance] == 0) return;
  for_each_pose(crowd, slot, [](std::uint32_t, std::uint32_t, PoseLanes& pose, std::uint32_t lane, const Vec3&) {
    arrive(pose, lane);
  });
}

Quat unit_of(const Quat& q) { return renormalised(q); }

Quat towards(const Quat& near, const Quat& q) {
  const bool is_far = near.x * q.x + near.y * q.y + near.z * q.z + near.w * q.w < 0.0f;
  return is_far ? Quat{-q.x, -q.y, -q.z, -q.w} : q;
}

bool same_collider(const MovingCollider& a, const MovingCollider& b) {
  const bool same_place = a.center[0] == b.center[0] && a.center[1] == b.center[1] && a.center[2] == b.center[2];
  const bool same_shape = a.shape == b.shape && a.axis == b.axis && a.radius == b.radius &&
                          a.end_radius == b.end_radius && a.half_extents == b.half_extents;
  return same_place && same_shape && a.rotation == b.rotation && a.is_velocity_known == b.is_velocity_known &&
         a.velocity.linear == b.velocity.linear && a.velocity.angular == b.velocity.angular;
}

/// World metres from the collider's `center` within which all of it is.
float extent_of(const MovingCollider& c) {
  const float radius = c.radius > c.end_radius ? c.radius : c.end_radius;
  switch (c.shape) {
    case ColliderShape::kSphere: return c.radius;
    case ColliderShape::kBox:
    case ColliderShape::kEllipsoid: return c.radius + length(c.half_extents);
    case ColliderShape::kPlane: return 3e18f;
    default: return radius + length(c.axis);
  }
}

/// Whether hair of the head could touch it where it is told to be.
bool is_in_reach(const CrowdState& crowd, std::uint32_t instance, const ToldCollider& told) {
  const std::uint32_t slot = crowd.slots[instance], i = slot % kLanes;
  const HeadLanes& heads = crowd.blocks[slot / kLanes].heads;
  const double scale = 1.0 / double(heads.per_scale.v[i]);
  double distance2 = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double way = told.now.center[axis] - heads.next_position[axis][i];
    distance2 += way * way;
  }
  const double extent = double(extent_of(told.now)) * (told.is_of_body ? scale : 1.0);
  const double reach = double(crowd.character.reach) * scale + extent;
  return told.keeps_inside || distance2 < reach * reach;
}

/// Takes the place of what was told before; a sleeping head wakes where it matters.
void tell(CrowdState& crowd, std::uint32_t instance, std::uint32_t place, const ToldCollider& next) {
  ToldCollider& told = crowd.character.told[std::size_t(instance) * crowd.character.places + place];
  if (told.is_there == next.is_there && (!next.is_there || same_collider(told.now, next.now))) return;
  const bool matters =
      (told.is_there && is_in_reach(crowd, instance, told)) || (next.is_there && is_in_reach(crowd, instance, next));
  const bool has_way = told.has_way && next.is_there && told.now.shape == next.now.shape;
  told.now = next.now;
  told.is_there = next.is_there;
  told.has_way = has_way;
  told.is_of_body = next.is_of_body;
  told.keeps_inside = next.keeps_inside;
  if (matters && crowd.details[instance].asleep) wake(crowd, instance);
}

/// A collider of the asset as its bone carries it. `rest`: of the bone, from its own axes to head space.
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

const CharacterCode kCharacterCode{
    .carve = &carve, .create = &create, .begin = &begin_colliders, .set_up = &set_up, .finish = &finish, .appear = &appear};

Status Hair::set_colliders(std::uint32_t instance, std::span<const MovingCollider> colliders) {
  if (block_of(crowd_, instance) == nullptr) return missing(crowd_);
  CharacterState& character = crowd_->character;
  if (colliders.size() > character.places - character.body_colliders) return Status::kNotAsked;
  const FloatEnvironment plain;
  for (const MovingCollider& collider : colliders) {
    if (const Status status = check_collider(collider); status != Status::kOk) return status;
  }
  for (std::uint32_t i = 0; i < character.places - character.body_colliders; ++i) {
    ToldCollider next;
    next.is_there = i < colliders.size();
    if (next.is_there) next.now = colliders[i];
    tell(*crowd_, instance, character.body_colliders + i, next);
  }
  return Status::kOk;
}

Status Hair::set_body(std::uint32_t instance, std::span<const BodyPose> bones) {
  const Block* const block = block_of(crowd_, instance);
  if (block == nullptr) return missing(crowd_);
  const CharacterState& character = crowd_->character;
  if (character.body_colliders == 0) return Status::kNotAsked;
  const Asset& asset = crowd_->asset;
  if (bones.size() != asset.body_bones().size()) return Status::kSizeMismatch;
  const FloatEnvironment plain;
  HeadPose unit;
  for (const BodyPose& bone : bones) {
    const HeadPose pose{{bone.position[0], bone.position[1], bone.position[2]}, bone.rotation};
    if (normalise_pose(pose, unit) != Status::kOk) return Status::kBadPose;
  }
  const float scale = 1.0f / block->heads.per_scale.v[crowd_->slots[instance] % kLanes];
  for (std::uint32_t i = 0; i < character.body_colliders; ++i) {
    const ColliderRecord& record = asset.body_colliders()[i];
    const BodyPose& bone = bones[record.bone];
    (void)normalise_pose({{bone.position[0], bone.position[1], bone.position[2]}, bone.rotation}, unit);
    ToldCollider next;
    next.now = carried_by(record, asset.body_bones()[record.bone], unit, scale);
    next.is_there = next.is_of_body = true;
    next.keeps_inside = (record.flags & kColliderKeepsInside) != 0;
    tell(*crowd_, instance, i, next);
  }
  return Status::kOk;
}

namespace {

Status check_pose(const CrowdState& crowd, std::span<const Quat> rotations, std::span<const float> weights) {
  if (crowd.character.poses.empty()) return Status::kNotAsked;
  if (rotations.empty() && weights.empty()) return Status::kOk;
  const std::size_t chains = crowd.asset.chains().size();
  if (rotations.size() != crowd.bone_count()) return Status::kSizeMismatch;
  if (weights.size() != 1 && weights.size() != chains) return Status::kSizeMismatch;
  for (const float weight : weights) {
    if (!(weight >= 0.0f && weight <= 1.0f)) return Status::kBadArgument;
  }
  HeadPose unit;
  for (std::size_t bone = 0; bone < rotations.size(); ++bone) {
    if (crowd.asset.bones()[bone].kind != BoneKind::kSimulated) continue;
    if (normalise_pose({{0, 0, 0}, rotations[bone]}, unit) != Status::kOk) return Status::kBadPose;
  }
  return Status::kOk;
}

/// How the bone is turned against head space when it and all above it are posed.
Quat posed_rotation(const Asset& asset, std::span<const Quat> rotations, std::uint32_t bone) {
  Quat all;
  for (; bone != kNone && asset.bones()[bone].kind == BoneKind::kSimulated; bone = asset.bones()[bone].parent) {
    all = unit_of(rotations[bone]) * all;
  }
  return renormalised(all);
}

}  // namespace

Status Hair::set_pose(std::uint32_t instance, std::span<const Quat> rotations, std::span<const float> weights) {
  if (block_of(crowd_, instance) == nullptr) return missing(crowd_);
  const FloatEnvironment plain;
  if (const Status status = check_pose(*crowd_, rotations, weights); status != Status::kOk) return status;
  const bool is_first = crowd_->character.is_posed[instance] == 0, is_rest = rotations.empty();
  if (is_first && is_rest) return Status::kOk;
  bool changes = is_first != is_rest;
  for_each_pose(*crowd_, crowd_->slots[instance],
                [&](std::uint32_t bone, std::uint32_t chain, PoseLanes& pose, std::uint32_t lane, const Vec3& pull) {
                  if (is_rest) return set_rest_pose(pose, lane, pull);
                  const float weight = weights[weights.size() == 1 ? 0 : chain];
                  const Quat next = towards(coif::lane(pose.before, lane), unit_of(rotations[bone]));
                  changes = changes || !(coif::lane(pose.now, lane) == next) || pose.weight.v[lane] != weight;
                  set_lane(pose.now, lane, next);
                  set_lane(pose.pull_now, lane, rotate(posed_rotation(crowd_->asset, rotations, bone), pull));
                  pose.weight.v[lane] = weight;
                  if (is_first) arrive(pose, lane);
                });
  crowd_->character.is_posed[instance] = is_rest ? 0 : 1;
  if (changes && crowd_->details[instance].asleep) wake(*crowd_, instance);
  return Status::kOk;
}

}  // namespace coif
