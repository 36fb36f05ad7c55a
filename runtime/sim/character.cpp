// The part of a crowd's state that belongs to characters, and its way to the rows.

#include <coif/hair.h>

#include "character_air.h"
#include "followed_pose.h"
#include "memory_carver.h"
#include "vector_math.h"

namespace coif {
namespace {

std::uint32_t body_colliders_of(const Asset& asset) { return std::uint32_t(asset.body_colliders().size()); }

void carve(MemoryCarver& carver, const Asset& asset, const HairDesc& desc, std::uint64_t states, std::uint32_t blocks,
           CharacterState& character) {
  character.body_colliders = desc.follows_body ? body_colliders_of(asset) : 0;
  character.places = character.body_colliders + desc.moving_colliders;
  const std::uint64_t places = std::uint64_t(desc.instances) * character.places;
  character.told = carver.take<ToldCollider>(places);
  character.there = carver.take<std::uint64_t>(character.places != 0 ? desc.instances : 0);
  character.ways = carver.take<ColliderWay>(places);
  character.way_counts = carver.take<std::uint32_t>(character.places != 0 ? desc.instances : 0);
  character.most_ways = carver.take<std::uint32_t>(character.places != 0 ? blocks : 0);
  character.bounds = carver.take<ColliderBounds>(std::uint64_t(blocks) * character.places);
  const LaneOrder order = choose_lane_order(asset, *desc.solver, desc.instances);
  const std::uint64_t row_bones = count_rows(asset, *desc.solver, order).bones;
  character.body_sets = carver.take<std::uint32_t>(character.body_colliders != 0 ? row_bones * kLanes : 0);
  character.poses = carver.take<PoseLanes>(desc.follows_poses ? states : 0);
  character.is_posed = carver.take<std::uint8_t>(desc.follows_poses ? desc.instances : 0);
  carve_air(carver, desc, blocks, character);
}

/// Largest distance of a chain's bones from the head's position, however they are turned.
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

void set_up(const CrowdState& crowd, std::uint32_t index, std::int32_t only_head, RowCharacter& to) {
  const CharacterState& from = crowd.character;
  const Block& block = crowd.blocks[index];
  const bool by_heads = only_head < 0;
  to.only_head = only_head;
  set_up_air(from, index, to);
  to.body_colliders = from.body_colliders;
  to.is_posed = any_posed(crowd, block);
  to.collider_count = 0;
  if (from.places == 0) return;
  to.collider_count = by_heads ? from.most_ways[index] : from.way_counts[block.instance[only_head]];
  if (to.collider_count == 0) return;
  to.bounds = &from.bounds[std::size_t(index) * from.places];
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    const std::uint32_t head = by_heads ? (i < block.count ? i : 0) : std::uint32_t(only_head);
    const std::uint32_t instance = block.instance[head];
    to.of_lane[i] = &from.ways[std::size_t(instance) * from.places];
    to.counts[i] = from.way_counts[instance];
  }
}

void enter_row(const CrowdState& crowd, const Row& row, std::size_t state, RowCharacter& to) {
  const CharacterState& from = crowd.character;
  to.poses = to.is_posed ? &from.poses[state] : nullptr;
  to.body_sets = from.body_sets.empty() ? nullptr : &from.body_sets[std::size_t(row.first_bone) * kLanes];
}

/// The next step begins with the poses that were reached.
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

}  // namespace

const CharacterCode kCharacterCode{.carve = &carve,
                                   .create = &create,
                                   .pass_time = &pass_time,
                                   .begin = &begin_colliders,
                                   .set_up = &set_up,
                                   .enter_row = &enter_row,
                                   .blow = &blow,
                                   .finish = &finish,
                                   .appear = &appear};

}  // namespace coif
