#include "segment_contact.h"

#include "bone_contact.h"

#include "tilt.h"
#include "vector_math.h"

namespace coif {
namespace {

constexpr int kNewtonSteps = 8;
constexpr float kLargestTurn = 0.5f;  ///< Radians per Newton step: further the linear model says nothing.
constexpr float kTolerance = 1e-6f;   ///< Depth that counts as clear, share of the collider's size.
constexpr float kOvershoot = 1e-6f;   ///< So that Newton ends outside instead of creeping up from inside.

/// The deepest point of a segment in a collider.
struct Deepest {
  float gap;    ///< Metres to the surface, negative inside.
  Vec3 normal;  ///< Unit, outwards.
  float along;  ///< Metres from the segment's start.
};

float clamped(float value, float low, float high) { return value < low ? low : value > high ? high : value; }

Vec3 point_at(const BoneSegment& segment, float along) { return segment.start + segment.direction * along; }

/// `offset` is the deepest point seen from the ball's centre.
Deepest in_ball(const Vec3& offset, float radius, float along, const Vec3& way_out) {
  const float distance = length(offset);
  return {distance - radius, distance > 1e-6f * radius ? offset * (1.0f / distance) : way_out, along};
}

Deepest deepest_in_sphere(const PlacedCollider& sphere, const BoneSegment& segment) {
  const Vec3 from = segment.start - sphere.center;
  const float radius = sphere.radii.x + segment.radius;
  const float deep = radius * (1.0f - kContactSkin);
  const float along =
      dot(from, from) < deep * deep ? segment.length : clamped(-dot(from, segment.direction), 0.0f, segment.length);
  return in_ball(from + segment.direction * along, radius, along, sphere.way_out);
}

/// The ball of the capsule and the point of the segment that come nearest to each other. The distance less the ball's
/// radius is convex in both places, so where the segment's whole line would be nearest beyond its end, the end is.
Deepest nearest_of_capsule(const PlacedCollider& capsule, const BoneSegment& segment) {
  const Vec3& direction = segment.direction;
  const Vec3 from = segment.start - capsule.center;
  const Vec3 beside = from - direction * dot(from, direction);
  const Vec3 slope = capsule.axis - direction * dot(capsule.axis, direction);
  const float taper = capsule.radii.x - capsule.radii.y;
  const float slope2 = dot(slope, slope), spread = slope2 - taper * taper;
  // Nearly parallel, the thicker end is nearest.
  float share = taper > 0.0f ? 0.0f : 1.0f;
  if (spread > 1e-6f * dot(capsule.axis, capsule.axis)) {
    share = dot(beside, slope) / slope2;
    const Vec3 apart = beside - slope * share;
    share = clamped(share - length(apart) * taper / std::sqrt(slope2 * spread), 0.0f, 1.0f);
  }
  CapsuleBall ball{capsule.center + capsule.axis * share, capsule.radii.x - taper * share};
  const float nearest = dot(ball.center - segment.start, direction);
  const float along = clamped(nearest, 0.0f, segment.length);
  const Vec3 point = point_at(segment, along);
  if (along != nearest) ball = nearest_ball(capsule, point);
  return in_ball(point - ball.center, ball.radius + segment.radius, along, capsule.way_out);
}

Deepest deepest_in_capsule(const PlacedCollider& capsule, const BoneSegment& segment) {
  const CapsuleBall at_start = nearest_ball(capsule, segment.start);
  const Vec3 from = segment.start - at_start.center;
  const float deep = (at_start.radius + segment.radius) * (1.0f - kContactSkin);
  if (!(dot(from, from) < deep * deep)) return nearest_of_capsule(capsule, segment);
  const Vec3 end = point_at(segment, segment.length);
  const CapsuleBall ball = nearest_ball(capsule, end);
  return in_ball(end - ball.center, ball.radius + segment.radius, segment.length, capsule.way_out);
}

/// In the space where the ellipsoid, with the hair's radius added to its axes, is the unit sphere. The gap is that
/// space's, brought back along the gradient: exact on the surface, which is what Newton's method needs.
Deepest deepest_in_ellipsoid(const PlacedCollider& ellipsoid, const BoneSegment& segment) {
  const Vec3 radii = ellipsoid.radii + Vec3{segment.radius, segment.radius, segment.radius};
  const Vec3 per_radius{1.0f / radii.x, 1.0f / radii.y, 1.0f / radii.z};
  const Quat to_axes = conjugate(ellipsoid.rotation);
  const auto shrunk = [&](const Vec3& v) {
    const Vec3 own = rotate(to_axes, v);
    return Vec3{own.x * per_radius.x, own.y * per_radius.y, own.z * per_radius.z};
  };
  const Vec3 from = shrunk(segment.start - ellipsoid.center);
  const Vec3 way = shrunk(segment.direction);
  const float nearest = -dot(from, way) / dot(way, way);
  const float along = dot(from, from) < (1.0f - kContactSkin) * (1.0f - kContactSkin)
                          ? segment.length
                          : clamped(nearest, 0.0f, segment.length);
  const Vec3 unit = from + way * along;
  const float distance = length(unit);
  if (!(distance > 1e-6f)) return {-radii.y, ellipsoid.way_out, along};
  const Vec3 gradient{unit.x / radii.x / distance, unit.y / radii.y / distance, unit.z / radii.z / distance};
  const float slope = length(gradient);
  return {(distance - 1.0f) / slope, rotate(ellipsoid.rotation, gradient * (1.0f / slope)), along};
}

Deepest deepest(const PlacedCollider& collider, const BoneSegment& segment) {
  switch (collider.shape) {
    case ColliderShape::kSphere: return deepest_in_sphere(collider, segment);
    case ColliderShape::kEllipsoid: return deepest_in_ellipsoid(collider, segment);
    case ColliderShape::kCapsule:
    case ColliderShape::kTaperedCapsule: return deepest_in_capsule(collider, segment);
    case ColliderShape::kPlane: break;
  }
  const Vec3& normal = collider.axis;
  return {dot(point_at(segment, segment.length) - collider.center, normal) - segment.radius, normal, segment.length};
}

float size_of(const PlacedCollider& collider) {
  const Vec3& r = collider.radii;
  const float smaller = r.x < r.y ? r.x : r.y;
  return r.z > 0.0f && r.z < smaller ? r.z : smaller;
}

SegmentContact contact_of(const Deepest& at) { return {true, at.normal, at.along}; }

/// The directions from a point outside that meet a ball form a cone. A segment that ends before the tangent's point only
/// has to keep its end out.
SegmentContact clear_of_sphere(const PlacedCollider& sphere, BoneSegment& segment) {
  const float radius = sphere.radii.x + segment.radius;
  const Vec3 from = segment.start - sphere.center;
  const float distance2 = dot(from, from), distance = std::sqrt(distance2);
  const float tangent2 = distance2 - radius * radius;
  const float reach = segment.length;
  if (!(distance > 1e-6f * radius)) return {false, {}, 0};  // every direction is as good
  const Vec3 inward = from * (-1.0f / distance);
  const bool ends_before = reach * reach <= tangent2 || tangent2 <= 0.0f;
  float cosine = ends_before ? (distance2 + reach * reach - radius * radius) / (2.0f * distance * reach)
                             : std::sqrt(tangent2) / distance;
  // From the surface itself every way inwards is a chord; from deep inside there is no other way for a long bone.
  if (tangent2 <= 0.0f && distance > radius * (1.0f - kContactSkin) && cosine > 0.0f) cosine = 0.0f;
  segment.direction = tilted(segment.direction, inward, cosine, sphere.way_out);
  const float along = ends_before ? reach : std::sqrt(tangent2);
  return contact_of(in_ball(point_at(segment, along) - sphere.center, radius, along, sphere.way_out));
}

SegmentContact clear_of_plane(const PlacedCollider& plane, BoneSegment& segment) {
  const float missing = segment.radius - dot(segment.start - plane.center, plane.axis);
  segment.direction = tilted(segment.direction, plane.axis, missing / segment.length, plane.axis);
  return {true, plane.axis, segment.length};
}

/// Keeps the end in the sphere, or in the ball of a capsule that is nearest to it.
SegmentContact keep_inside(const PlacedCollider& collider, BoneSegment& segment) {
  SegmentContact contact;
  for (int i = 0; i < kNewtonSteps; ++i) {
    const Vec3 end = point_at(segment, segment.length);
    CapsuleBall ball{collider.center, collider.radii.x};
    if (collider.shape != ColliderShape::kSphere) ball = nearest_ball(collider, end);
    const float room = ball.radius > segment.radius ? ball.radius - segment.radius : 0.0f;
    const Vec3 offset = end - ball.center;
    const float distance = length(offset);
    if (!(distance > room * (1.0f + kTolerance)) || !(distance > 0.0f)) break;
    const Vec3 from = segment.start - ball.center;
    const float start2 = dot(from, from), start = std::sqrt(start2);
    contact = {true, offset * (-1.0f / distance), segment.length};
    if (!(start > 1e-6f * segment.length)) break;
    const float cosine = (start2 + segment.length * segment.length - room * room) / (2.0f * start * segment.length);
    segment.direction = tilted(segment.direction, from * (-1.0f / start), cosine, collider.way_out);
    if (collider.shape == ColliderShape::kSphere) break;
  }
  return contact;
}

/// One step of Newton's method: turns the segment so that its deepest point would reach the surface.
void turn_outwards(const Deepest& at, float overshoot, const Vec3& way_out, BoneSegment& segment) {
  const Vec3& direction = segment.direction;
  Vec3 side = at.normal - direction * dot(direction, at.normal);
  float size = length(side);
  if (!(size > 1e-3f)) {
    side = way_out - direction * dot(direction, way_out);
    if (!(dot(side, side) > 1e-6f)) side = any_perpendicular(direction);
    side = side * (1e-3f / length(side));
    size = 1e-3f;
  }
  const float turn = (overshoot - at.gap) / (at.along * size);
  const float angle = turn < kLargestTurn ? turn : kLargestTurn;
  const Vec3 turned = direction + side * (angle * (1.0f + angle * angle * (1.0f / 3.0f)) / size);
  segment.direction = turned * (1.0f / length(turned));
}

SegmentContact clear_by_newton(const PlacedCollider& collider, Deepest at, BoneSegment& segment) {
  const float size = size_of(collider);
  for (int i = 0; i < kNewtonSteps && at.gap < -kTolerance * size && at.along > 0.0f; ++i) {
    turn_outwards(at, kOvershoot * size, collider.way_out, segment);
    at = deepest(collider, segment);
  }
  return contact_of(at);
}

SegmentContact clear_outside(const PlacedCollider& collider, BoneSegment& segment) {
  const Deepest at = deepest(collider, segment);
  if (!(at.gap < 0.0f)) return {};
  if (collider.shape == ColliderShape::kSphere) return clear_of_sphere(collider, segment);
  if (collider.shape == ColliderShape::kPlane) return clear_of_plane(collider, segment);
  return clear_by_newton(collider, at, segment);
}

constexpr float kDeep = 0.35f;  ///< Share of the collider's size: deeper than this is through, not along.
constexpr int kLooks = 8;

/// True where the segment went through the collider on the way from `before`, the shorter way round, or ended deep in it.
/// Then it is put back to the last look on the side it came from.
bool find_crossing(const PlacedCollider& collider, const Vec3& before, BoneSegment& segment) {
  const float cosine = dot(before, segment.direction);
  Vec3 side = segment.direction - before * cosine;
  const float sine = length(side);
  if (!(sine > 1e-3f)) return false;  // straight over the top or around: no telling
  side = side * (1.0f / sine);
  const float turn = std::atan2(sine, cosine) / float(kLooks);
  const float turn_cos = std::cos(turn), turn_sin = std::sin(turn);
  BoneSegment between = segment;
  float along = 1.0f, across = 0.0f;
  for (int i = 1; i <= kLooks; ++i) {
    const Vec3 last = before * along + side * across;
    const float next = along * turn_cos - across * turn_sin;
    across = along * turn_sin + across * turn_cos;
    along = next;
    between.direction = before * along + side * across;
    if (deepest(collider, between).gap < -kDeep * size_of(collider)) {
      segment.direction = last * (1.0f / length(last));
      return true;
    }
  }
  return false;
}

}  // namespace

SegmentContact clear_segment(const PlacedCollider& collider, const Vec3& before, BoneSegment& segment) {
  if (collider.keeps_inside) return keep_inside(collider, segment);
  const bool is_far = dot(before, segment.direction) < kFarTurn;
  if (is_far && collider.shape != ColliderShape::kPlane && find_crossing(collider, before, segment)) {
    const SegmentContact contact = clear_outside(collider, segment);
    return contact.touches ? contact : contact_of(deepest(collider, segment));
  }
  return clear_outside(collider, segment);
}

}  // namespace coif
