// Impulses between two steps. With every solver a bone's state has its place or its direction, and the velocity of its
// particle.

#include <coif/hair.h>

#include "chain_motion.h"
#include "float_environment.h"
#include "rules.h"
#include "vector_math.h"
#include "world_heads.h"

#include <cmath>

namespace coif {
namespace {

/// An impulse relative to the head's position, in world axes and the hair's metres.
struct FeltImpulse {
  Vec3 center, axis;
  float per_axis2 = 0;  ///< 0 for a ball.
  float radius = 0;
  float speed = 0;
  Vec3 velocity;
  bool strokes = false;
};

/// False where the head is too far away to feel it.
bool feel(const Impulse& impulse, const HeadLanes& heads, std::uint32_t i, FeltImpulse& felt) {
  const float per_scale = heads.per_scale.v[i];
  const Vec3 left = lane(heads.way, i);
  const double ahead[3] = {double(left.x), double(left.y), double(left.z)};
  double way[3];
  for (int axis = 0; axis < 3; ++axis) {
    way[axis] = (impulse.center[axis] - (heads.next_position[axis][i] - ahead[axis])) * double(per_scale);
    if (!(std::fabs(way[axis]) < 1e15)) return false;
  }
  felt.center = {float(way[0]), float(way[1]), float(way[2])};
  felt.axis = impulse.axis * per_scale;
  const float size2 = dot(felt.axis, felt.axis);
  const bool has_length = size2 > 1e-18f;
  felt.per_axis2 = has_length ? 1.0f / size2 : 0.0f;
  felt.radius = impulse.radius * per_scale;
  felt.speed = impulse.speed * per_scale;
  felt.velocity = impulse.velocity * per_scale;
  felt.strokes = impulse.strokes;
  return true;
}

/// The change of velocity at `place` for hair that moves at `velocity`.
Vec3 change_of(const FeltImpulse& impulse, const Vec3& place, const Vec3& velocity) {
  Vec3 from = place - impulse.center;
  const float along = dot(from, impulse.axis) * impulse.per_axis2;
  from = from - impulse.axis * (along < 0.0f ? 0.0f : along > 1.0f ? 1.0f : along);
  const float distance = length(from);
  if (!(distance < impulse.radius)) return {};
  const float share = 1.0f - distance / impulse.radius;
  const Vec3 given = impulse.strokes ? impulse.velocity - velocity : impulse.velocity;
  const Vec3 outwards = distance > 1e-9f ? from * (impulse.speed / distance) : Vec3{};
  return (given + outwards) * share;
}

/// Pushes particles that have world places and velocities, as in Algorithm 1.
bool push_particles(ChainMotion pushed, std::size_t bones, const FeltImpulse& impulse) {
  bool any = false;
  for (std::size_t i = 0; i < bones; ++i) {
    const Vec3 change = change_of(impulse, pushed.first(i), pushed.velocity(i));
    const Vec3 pushed_velocity = pushed.velocity(i) + change;
    if (!is_finite(pushed_velocity)) continue;
    any = any || !(change == Vec3{});
    pushed.set_velocity(i, pushed_velocity);
  }
  return any;
}

/// The end of a bone.
struct Tail {
  Vec3 place, velocity, change;
};

/// The motion that the head gives its joints.
struct Carrying {
  Quat rotation;
  Vec3 velocity, turning;
};

/// Pushes bones that turn about their starts. The part of an impulse along a bone is lost, and the change of its start
/// is already in its parent. Parents come first.
class PushedBones {
 public:
  PushedBones(const ChainMotion& pushed, const ChainLane& chain, const Carrying& head, const FeltImpulse& impulse)
      : pushed_(pushed), chain_(chain), head_(head), impulse_(impulse) {}

  bool run() {
    bool any = false;
    for (std::size_t i = 0; i < chain_.bones.size(); ++i) {
      const RowBone& shape = chain_.bones[i];
      const Tail start = shape.parent < 0 ? joint(i) : open_[shape.parent_slot];
      const Vec3 direction = pushed_.first(i), own = pushed_.velocity(i);
      Tail tail;
      tail.place = start.place + direction * chain_.constants[i].length.v[chain_.constant_lane];
      tail.velocity = start.velocity + own;
      const Vec3 relative = change_of(impulse_, tail.place, tail.velocity) - start.change;
      Vec3 change = relative - direction * dot(relative, direction);
      if (!is_finite(own + change)) change = {};
      any = any || !(change == Vec3{});
      pushed_.set_velocity(i, own + change);
      tail.change = start.change + change;
      if ((shape.features & kRowHasChildren) != 0) open_[shape.slot] = tail;
    }
    return any;
  }

 private:
  [[nodiscard]] Tail joint(std::size_t bone) const {
    const Vec3 place = rotate(head_.rotation, lane(chain_.constants[bone].joint, chain_.constant_lane));
    return {place, head_.velocity + cross(head_.turning, place), {}};
  }

  ChainMotion pushed_;
  const ChainLane& chain_;
  const Carrying& head_;
  const FeltImpulse& impulse_;
  Tail open_[kMaxOpenBones];
};

}  // namespace

Status HairWorld::push(WorldHead head, const Impulse& impulse) {
  const WornHead* const worn = find(world_, head);
  if (worn == nullptr) return missing(world_);
  const FloatEnvironment plain;
  if (const Status status = check(impulse); status != Status::kOk) return status;
  const std::uint32_t i = worn->lane;
  const HeadLanes& heads = worn->block->heads;
  FeltImpulse felt;
  if (!feel(impulse, heads, i, felt)) return Status::kOk;
  const Carrying carrying{lane(heads.rotation, i), lane(heads.velocity, i) * heads.per_scale.v[i],
                          lane(heads.angular_velocity, i)};
  bool any = false;
  for_each_chain(*world_, head.index, [&](const Solver& solver, std::uint32_t, const ChainLane& chain) {
    const ChainMotion pushed(solver, chain);
    const bool hit = solver.keeps_places ? push_particles(pushed, chain.bones.size(), felt)
                                         : PushedBones(pushed, chain, carrying, felt).run();
    any = any || hit;
  });
  if (any) wake_if_asleep(*world_, head.index);
  return Status::kOk;
}

}  // namespace coif
