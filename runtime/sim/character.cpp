// The way of characters to the rows: what hosts set for each head, as the lanes of a step need it.

#include <coif/hair.h>

#include "followed_pose.h"
#include "world_step.h"

namespace coif {
namespace {

/// Marks the lanes of heads that follow a pose.
void find_posed(const WorldState& world, const RowHeads& heads, RowCharacter& to) {
  to.is_posed = false;
  if (!world.rules.follows_poses) return;
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    const std::uint32_t lane = heads.only_head < 0 ? i : std::uint32_t(heads.only_head);
    const bool is_posed = lane < heads.count && world.heads[heads.head[lane]].is_posed;
    to.has_pose.v[i] = is_posed ? 1.0f : 0.0f;
    to.is_posed = to.is_posed || is_posed;
  }
}

void set_up(const WorldState& world, const RowHeads& heads, const StepParts& parts, std::uint32_t part,
            RowCharacter& to) {
  to.from = float(part) / float(parts.count);
  to.to = float(part + 1) / float(parts.count);
  to.per_dt = 1.0f / parts.dt;
  to.only_head = heads.only_head;
  set_up_air(world, heads, to);
  find_posed(world, heads, to);
  const bool by_heads = heads.only_head < 0;
  to.collider_count = heads.most_ways;
  if (!by_heads && heads.most_ways != 0) {
    to.collider_count = world.colliders_of(world.heads[heads.head[heads.only_head]]).way_count;
  }
  if (to.collider_count == 0) return;
  to.bounds = heads.bounds;
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    const std::uint32_t lane = by_heads ? (i < heads.count ? i : 0) : std::uint32_t(heads.only_head);
    const WornHead& head = world.heads[heads.head[lane]];
    const bool has_any = world.worn_by(head).places != 0;
    to.of_lane[i] = has_any ? world.ways(head) : nullptr;
    to.counts[i] = has_any ? world.colliders_of(head).way_count : 0;
    to.has_colliders.v[i] = to.counts[i] != 0 ? 1.0f : 0.0f;
  }
}

/// Calls for each bone of the head that follows a pose: it has arrived at it.
void reach_pose(WorldState& world, std::uint32_t head) {
  for_each_pose(world, head, [](std::uint32_t, std::uint32_t, PoseLanes& pose, std::uint32_t lane, const Vec3&) {
    arrive(pose, lane);
  });
}

void finish(WorldState& world, const Block& block) {
  for (std::uint32_t i = 0; i < block.count; ++i) {
    if (world.heads[block.head[i]].is_posed) reach_pose(world, block.head[i]);
  }
}

void set_rest_poses(const ChainLane& chain) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    set_rest_pose(chain.poses[i], chain.state_lane, lane(chain.constants[i].pull, chain.constant_lane));
  }
}

void appear(WorldState& world, std::uint32_t index) {
  const WornHead& head = world.heads[index];
  const std::uint32_t places = world.worn_by(head).places;
  for (std::uint32_t place = 0; place < places; ++place) world.told_colliders(head)[place].has_way = false;
  if (head.is_posed) reach_pose(world, index);
}

}  // namespace

const CharacterCode kCharacterCode{.begin = &begin_colliders,
                                   .gather = &gather_bounds,
                                   .blow = &blow,
                                   .set_up = &set_up,
                                   .finish = &finish,
                                   .set_rest_poses = &set_rest_poses,
                                   .appear = &appear};

}  // namespace coif
