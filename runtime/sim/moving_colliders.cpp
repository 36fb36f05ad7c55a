#include "moving_colliders.h"

#include "vector_math.h"
#include "world.h"
#include "world_step.h"

#include <bit>
#include <cmath>

namespace coif {
namespace {

Vec3 mix(const Vec3& a, const Vec3& b, float s) { return a + (b - a) * s; }

Vec3 unit(const Vec3& v) { return v * (1.0f / length(v)); }

/// Makes the axes exactly perpendicular, x first.
OwnAxes straightened(const OwnAxes& axes) {
  const Vec3 x = unit(axes.x), y = unit(axes.y - x * dot(axes.y, x));
  return {x, y, cross(x, y)};
}

bool has_axes(ColliderShape shape) { return shape == ColliderShape::kBox || shape == ColliderShape::kEllipsoid; }

/// The head at one end of the step.
struct HeadAt {
  double position[3];
  Quat rotation;
  float per_scale;
};

/// In head space, in the hair's metres.
Vec3 seen_from(const HeadAt& head, const double (&place)[3]) {
  const auto offset = [&](int axis) { return float((place[axis] - head.position[axis]) * double(head.per_scale)); };
  return rotate(conjugate(head.rotation), {offset(0), offset(1), offset(2)});
}

constexpr std::uint32_t kMostLooks = 64;

/// Sets the shape in the hair's metres. Degenerate capsules become spheres.
void set_shape(const ToldCollider& told, float per_scale, ColliderWay& way) {
  const MovingCollider& now = told.now;
  const float scale = told.is_of_body ? 1.0f : per_scale;
  const float first = now.radius * scale, last = now.end_radius * scale, apart = length(now.axis) * scale;
  way.shape = now.shape;
  way.keeps_inside = told.keeps_inside;
  way.radii = {first, first, first};
  way.rounding = 0;
  if (now.shape == ColliderShape::kTaperedCapsule) way.radii = {first, last, 0};
  if (has_axes(now.shape)) way.radii = now.half_extents * scale;
  if (now.shape == ColliderShape::kBox) way.rounding = first;
  const bool is_ball = is_capsule(now.shape) && !(apart > 1e-5f);
  const bool has_swallowed = now.shape == ColliderShape::kTaperedCapsule && std::fabs(first - last) >= 0.9999f * apart;
  if (!is_ball && !has_swallowed) return;
  const float radius = now.shape == ColliderShape::kTaperedCapsule && last > first ? last : first;
  way.shape = ColliderShape::kSphere;
  way.radii = {radius, radius, radius};
}

Vec3 own_axis(const ToldCollider& told, const Quat& rotation, const Quat& head, float scale) {
  if (told.now.shape == ColliderShape::kPlane) return rotate(conjugate(head), unit(rotate(rotation, told.now.axis)));
  return rotate(conjugate(head), rotate(rotation, told.now.axis)) * scale;
}

/// A tapered capsule in which one ball contains the other becomes a sphere: true where that is the ball at the end.
bool takes_end(const ToldCollider& told, const ColliderWay& way) {
  return told.now.shape == ColliderShape::kTaperedCapsule && way.shape == ColliderShape::kSphere &&
         told.now.end_radius > told.now.radius;
}

void set_end(const ToldCollider& told, const HeadAt& head, const double (&center)[3], const Quat& rotation, int end,
             ColliderWay& way) {
  const float scale = told.is_of_body ? 1.0f : head.per_scale;
  const bool has_axis = is_capsule(told.now.shape) || told.now.shape == ColliderShape::kPlane;
  const Vec3 axis = has_axis ? own_axis(told, rotation, head.rotation, scale) : Vec3{};
  way.center[end] = seen_from(head, center);
  if (takes_end(told, way)) way.center[end] = way.center[end] + axis;
  way.axis[end] = way.shape == ColliderShape::kSphere ? Vec3{} : axis;
  if (has_axes(way.shape)) way.axes[end] = axes_of(conjugate(head.rotation) * rotation);
}

/// Velocities of the head at the step's end, in the hair's metres and world axes; `dt` is the whole step, seconds.
struct HeadPace {
  float dt;
  Vec3 velocity, turning;
};

void set_velocity(const ToldCollider& told, const HeadAt& before, const HeadAt& after, const HeadPace& pace,
                  ColliderWay& way) {
  if (told.now.is_velocity_known) {
    const Quat back = conjugate(after.rotation);
    const Vec3 head_turning = rotate(back, pace.turning);
    const Vec3 velocity = told.now.velocity.linear * after.per_scale - pace.velocity;
    way.velocity = rotate(back, velocity) - cross(head_turning, way.center[1]);
    way.turning = rotate(back, told.now.velocity.angular) - head_turning;
    return;
  }
  const float per_second = 1.0f / pace.dt;
  way.velocity = (way.center[1] - way.center[0]) * per_second;
  const Quat from = conjugate(before.rotation) * told.rotation_before,
             to = conjugate(after.rotation) * told.now.rotation;
  const Quat turn = to * conjugate(from);
  way.turning = Vec3{turn.x, turn.y, turn.z} * (turn.w < 0.0f ? -2.0f * per_second : 2.0f * per_second);
}

/// Upper bound of the way that any point of its surface makes.
float longest_way(const ColliderWay& way) {
  const float straight = length(way.center[1] - way.center[0]);
  if (has_axes(way.shape)) {
    const Vec3 corner0 = way.axes[0].x * way.radii.x + way.axes[0].y * way.radii.y + way.axes[0].z * way.radii.z;
    const Vec3 corner1 = way.axes[1].x * way.radii.x + way.axes[1].y * way.radii.y + way.axes[1].z * way.radii.z;
    return straight + length(corner1 - corner0) + length(way.axes[1].x - way.axes[0].x) * length(way.radii);
  }
  return straight + length(way.axis[1] - way.axis[0]);
}

float thickness_of(const ColliderWay& way) {
  if (way.shape == ColliderShape::kPlane) return 1.0f;
  float least = way.radii.x < way.radii.y ? way.radii.x : way.radii.y;
  if (has_axes(way.shape)) least = (way.radii.z < least ? way.radii.z : least) + way.rounding;
  constexpr float kThinnest = 0.005f;  // Metres: hair itself has some thickness.
  return least < kThinnest ? kThinnest : least;
}

/// It turns by a right angle or more, so its interpolated axes would vanish on the way.
bool turns_over(const ColliderWay& way) {
  if (way.shape == ColliderShape::kSphere) return false;
  if (!has_axes(way.shape)) return !(dot(way.axis[0], way.axis[1]) > 0.0f);
  return !(dot(way.axes[0].x, way.axes[1].x) > 0.0f && dot(way.axes[0].y, way.axes[1].y) > 0.0f);
}

void stay(ColliderWay& way) {
  way.center[0] = way.center[1];
  way.axis[0] = way.axis[1];
  way.axes[0] = way.axes[1];
}

/// Looks lie half a thickness apart, so that hair in front of the collider stays in front. A collider that needs more
/// looks than kMostLooks was put there.
void find_looks(ColliderWay& way, bool& has_way) {
  const float looks = std::ceil(longest_way(way) / (0.5f * thickness_of(way)));
  has_way = has_way && looks <= float(kMostLooks) && !turns_over(way);
  way.looks = has_way && looks > 1.0f ? std::uint32_t(looks) : 1;
  if (!has_way) stay(way);
}

}  // namespace

void place_at(const ColliderWay& way, float s, PlacedCollider& placed) {
  placed.shape = way.shape;
  placed.keeps_inside = way.keeps_inside;
  placed.center = mix(way.center[0], way.center[1], s);
  placed.radii = way.radii;
  placed.rounding = way.rounding;
  placed.way_out = {0, 1, 0};
  placed.axis = mix(way.axis[0], way.axis[1], s);
  if (way.shape == ColliderShape::kPlane) placed.axis = unit(placed.axis);
  if (has_axes(way.shape)) {
    const OwnAxes &a = way.axes[0], &b = way.axes[1];
    placed.axes = straightened({mix(a.x, b.x, s), mix(a.y, b.y, s), mix(a.z, b.z, s)});
  }
  complete(placed);
  constexpr float kLeastSize = 1e-3f;  // Metres; thinner colliders are not felt more exactly.
  if (placed.size < kLeastSize) placed.size = kLeastSize;
}

namespace {

bool is_endless(const ColliderWay& way) { return way.keeps_inside || way.shape == ColliderShape::kPlane; }

/// Finds the collider at both ends of the step from what the host set. False where hair cannot reach it.
bool find_way(const ToldCollider& told, const HeadAt& before, const HeadAt& after, const HeadPace& pace, bool is_put,
              float reach, ColliderWay& way) {
  set_shape(told, after.per_scale, way);
  set_end(told, after, told.now.center, told.now.rotation, 1, way);
  bool has_way = told.has_way && !is_put;
  if (has_way) set_end(told, before, told.center_before, told.rotation_before, 0, way);
  if (!has_way) stay(way);
  find_looks(way, has_way);
  way.velocity = way.turning = {};
  if (has_way || told.now.is_velocity_known) set_velocity(told, before, after, pace, way);
  if (!is_finite(way.center[0]) || !is_finite(way.center[1]) || !is_finite(way.velocity)) return false;
  PlacedCollider ends[2];
  for (int end = 0; end < 2; ++end) place_at(way, float(end), ends[end]);
  const float larger = ends[0].bound_radius > ends[1].bound_radius ? ends[0].bound_radius : ends[1].bound_radius;
  const float travel = length(ends[1].bound_center - ends[0].bound_center);
  way.bound_center = mix(ends[0].bound_center, ends[1].bound_center, 0.5f);
  way.bound_radius = is_endless(way) ? 1e15f : larger + 0.5f * travel * kBoundMargin;
  const float nearest0 = length(ends[0].bound_center) - ends[0].bound_radius;
  const float nearest1 = length(ends[1].bound_center) - ends[1].bound_radius;
  return is_endless(way) || (nearest0 <= reach + travel && nearest1 <= reach + travel);
}

constexpr Vec3 kNowhere{1e15f, 1e15f, 1e15f};  ///< No hair comes near it.

/// Squared distance, in world metres.
double distance2(const double (&a)[3], const double (&b)[3]) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return sum;
}

/// Whether the collider is too far away at both ends of the step, whatever its shape, as most are.
bool is_far(const ToldCollider& told, const HeadAt& before, const HeadAt& after, float reach) {
  const double scale = 1.0 / double(after.per_scale);
  const double radius = scale * double(reach) + double(told.extent) * (told.is_of_body ? scale : 1.0);
  const double now2 = distance2(told.now.center, after.position);
  if (told.keeps_inside || told.now.shape == ColliderShape::kPlane || now2 <= 4 * radius * radius) return false;
  // Further than the longest way that it can have made.
  const double before2 = distance2(told.center_before, before.position);
  const double way2 = distance2(told.now.center, told.center_before) + distance2(after.position, before.position);
  return before2 > 4 * radius * radius && 4 * way2 < now2;
}

/// Finds the colliders that hair of the head in lane `i` may touch, and makes the present places those of the last
/// step.
void find_ways(WorldState& world, const BlockStep& step, std::uint32_t i) {
  const WornHead& head = world.heads[step.block.head[i]];
  const WornAsset& worn = world.worn_by(head);
  if (worn.places == 0) return;
  HeadColliders& own = world.colliders_of(head);
  own.way_count = 0;
  if (own.there == 0) return;
  const HeadLanes& heads = step.block.heads;
  const Vec3 way = lane(heads.way, i);
  const float per_scale = heads.per_scale.v[i];
  const bool is_put = ((step.put >> i) & 1u) != 0;
  HeadAt after{{heads.next_position[0][i], heads.next_position[1][i], heads.next_position[2][i]},
               lane(heads.next_rotation, i),
               per_scale};
  HeadAt before{
      {after.position[0] - double(way.x), after.position[1] - double(way.y), after.position[2] - double(way.z)},
      lane(heads.rotation, i),
      per_scale};
  const HeadPace pace{step.parts.dt, lane(step.heads.next_velocity, i) * per_scale,
                      lane(step.heads.next_angular_velocity, i)};
  for (std::uint64_t there = own.there; there != 0; there &= there - 1) {
    const auto place = std::uint32_t(std::countr_zero(there));
    ToldCollider& told = world.told_colliders(head)[place];
    ColliderWay& to = world.ways(head)[own.way_count];
    // In a long frame the hair was carried along for a share of the time.
    for (int axis = 0; axis < 3; ++axis) {
      told.center_before[axis] += (told.now.center[axis] - told.center_before[axis]) * double(step.parts.carried);
    }
    if (!is_far(told, before, after, worn.reach) && find_way(told, before, after, pace, is_put, worn.reach, to)) {
      to.place = told.is_of_body ? place : kMaxBodyColliders;
      ++own.way_count;
    }
    for (int axis = 0; axis < 3; ++axis) told.center_before[axis] = told.now.center[axis];
    told.rotation_before = told.now.rotation;
    told.has_way = true;
  }
}

}  // namespace

void begin_colliders(WorldState& world, BlockStep& step) {
  keep_awake_in_gusts(world, step);
  if (world.rules.moving_colliders == 0 && !world.rules.follows_body) return;
  Block& block = step.block;
  for (std::uint32_t i = 0; i < block.count; ++i) find_ways(world, step, i);
  if (block.bounds == nullptr) return;
  RowHeads heads{.heads = &block.heads, .head = block.head, .count = block.count, .bounds = block.bounds};
  gather_bounds(world, heads);
  block.most_ways = heads.most_ways;
}

void gather_bounds(const WorldState& world, RowHeads& heads) {
  const ColliderWay* ways[kLanes];
  std::uint32_t counts[kLanes] = {};
  heads.most_ways = 0;
  for (std::uint32_t i = 0; i < heads.count; ++i) {
    const WornHead& head = world.heads[heads.head[i]];
    if (world.worn_by(head).places == 0) continue;
    ways[i] = world.ways(head);
    counts[i] = world.colliders_of(head).way_count;
    heads.most_ways = counts[i] > heads.most_ways ? counts[i] : heads.most_ways;
  }
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    for (std::uint32_t k = 0; k < heads.most_ways; ++k) {
      const bool is_there = k < counts[i];
      set_lane(heads.bounds[k].center, i, is_there ? ways[i][k].bound_center : kNowhere);
      heads.bounds[k].radius.v[i] = is_there ? ways[i][k].bound_radius : 0.0f;
    }
  }
}

}  // namespace coif
