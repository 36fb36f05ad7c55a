#include "drawing/debug_pen.h"

namespace coif {
namespace {

using debug::dot;
using debug::minus;
using debug::plus;
using debug::times;
using Kind = DebugLine::Kind;

/// The gap between a point and a collider's surface, towards the side that hair is kept on.
struct Gap {
  float metres;  ///< Negative on the wrong side.
  Vec3 normal;   ///< Unit, to where hair may be.
};

Gap gap_to_ball(const Vec3& offset, float radius) {
  const float distance = debug::length(offset);
  return {distance - radius, debug::unit(offset)};
}

// To first order, exact on the surface: the true distance has no closed form.
Gap gap_to_ellipsoid(const Vec3& p, const Vec3& radii) {
  const Vec3 inside{p.x / radii.x, p.y / radii.y, p.z / radii.z};
  const Vec3 gradient{inside.x / radii.x, inside.y / radii.y, inside.z / radii.z};
  const float distance = debug::length(inside), steepness = debug::length(gradient);
  const float least =
      radii.x < radii.y ? (radii.x < radii.z ? radii.x : radii.z) : (radii.y < radii.z ? radii.y : radii.z);
  if (!(steepness > 0.0f)) return {-least, {0, 1, 0}};
  return {(distance - 1.0f) * distance / steepness, times(gradient, 1.0f / steepness)};
}

// The ball of a capsule that comes nearest lies where the cone's normal through the point starts, not beside the point.
Gap gap_to_capsule(const Vec3& p, const Vec3& axis, float first, float last) {
  const float square = dot(axis, axis), taper = first - last;
  float share = square > 0.0f ? dot(p, axis) / square : 0.0f;
  const float room = square - taper * taper;
  if (room > 0.0f) share -= debug::length(minus(p, times(axis, share))) * taper / std::sqrt(square * room);
  share = share < 0.0f ? 0.0f : share > 1.0f ? 1.0f : share;
  return gap_to_ball(minus(p, times(axis, share)), first - taper * share);
}

Gap gap_to_box(const Vec3& p, const Vec3& half) {
  const float over[3] = {std::fabs(p.x) - half.x, std::fabs(p.y) - half.y, std::fabs(p.z) - half.z};
  const auto signed_as = [](float size, float of) { return of < 0.0f ? -size : size; };
  int nearest = 0;
  for (int i = 1; i < 3; ++i) nearest = over[i] > over[nearest] ? i : nearest;
  if (over[nearest] <= 0.0f) {
    const auto side = [&](int i, float of) { return i == nearest ? signed_as(1, of) : 0.0f; };
    return {over[nearest], {side(0, p.x), side(1, p.y), side(2, p.z)}};
  }
  const auto beyond = [&](int i, float of) { return over[i] > 0.0f ? signed_as(over[i], of) : 0.0f; };
  return gap_to_ball({beyond(0, p.x), beyond(1, p.y), beyond(2, p.z)}, 0);
}

Gap gap_outside(const DebugCollider& c, const Vec3& point) {
  const Vec3 offset = minus(point, c.center);
  const Quat back{-c.rotation.x, -c.rotation.y, -c.rotation.z, c.rotation.w};
  if (debug::is_box(c) || c.shape == ColliderShape::kEllipsoid) {
    const Vec3 own = debug::turned(back, offset);
    Gap gap = debug::is_box(c) ? gap_to_box(own, c.half_extents) : gap_to_ellipsoid(own, c.radii);
    if (debug::is_box(c)) gap.metres -= c.radii.x;
    return {gap.metres, debug::turned(c.rotation, gap.normal)};
  }
  if (debug::is_capsule(c)) return gap_to_capsule(offset, c.axis, c.radii.x, debug::end_radius(c));
  if (c.shape == ColliderShape::kPlane) return {dot(offset, debug::unit(c.axis)), debug::unit(c.axis)};
  return gap_to_ball(offset, c.radii.x);
}

Gap gap_to(const DebugCollider& c, const Vec3& point) {
  const Gap gap = gap_outside(c, point);
  return c.keeps_inside ? Gap{-gap.metres, times(gap.normal, -1)} : gap;
}

Vec3 along(const debug::PosedBone& bone, float share) {
  return plus(bone.start, times(minus(bone.end, bone.start), share));
}

/// Where on the bone the gap is smallest, share of its length. Colliders are convex, so there is one such place. For a
/// bone that starts inside, or that is kept inside, only its end counts.
float nearest_share(const DebugCollider& c, const debug::PosedBone& bone, float radius) {
  if (c.keeps_inside || gap_to(c, bone.start).metres < radius) return 1;
  float low = 0, high = 1;
  for (int i = 0; i < 24; ++i) {
    const float third = (high - low) / 3;
    const bool is_before = gap_to(c, along(bone, low + third)).metres < gap_to(c, along(bone, high - third)).metres;
    (is_before ? high : low) += is_before ? -third : third;
  }
  return 0.5f * (low + high);
}

void draw_contact(const debug::Pen& pen, std::uint32_t bone, const Vec3& place, const Vec3& normal) {
  constexpr float kCross = 0.004f, kNormal = 0.02f;  // metres
  const debug::Across side = debug::across(normal);
  for (const Vec3& way : {side.u, side.v}) {
    pen.line(Kind::kContact, bone, minus(place, times(way, kCross)), plus(place, times(way, kCross)));
  }
  pen.line(Kind::kContact, bone, place, plus(place, times(normal, kNormal)));
}

struct Touched {
  const debug::Pen& pen;
  const debug::PosedBone& bone;
  float hit_radius;
  float tolerance;
  std::uint32_t index;

  void look_at(const DebugCollider& collider) const {
    const Vec3 nearest = along(bone, nearest_share(collider, bone, hit_radius));
    const Gap gap = gap_to(collider, nearest);
    if (!(gap.metres < hit_radius + tolerance)) return;
    draw_contact(pen, index, minus(nearest, times(gap.normal, gap.metres)), gap.normal);
  }
};

Status check(const Asset& asset, const HairInstance& instance, const DebugLines& lines,
             std::span<const DebugCollider> more, float tolerance) {
  if (const Status status = debug::check(asset, instance, lines); status != Status::kOk) return status;
  for (const DebugCollider& collider : more) {
    if (!debug::is_finite(collider)) return Status::kBadArgument;
  }
  return tolerance >= 0.0f && std::isfinite(tolerance) ? Status::kOk : Status::kBadArgument;
}

}  // namespace

Status draw_contact_lines(const Asset& asset, const HairInstance& instance, const DebugLines& lines,
                          std::span<const DebugCollider> more, float tolerance) {
  if (const Status status = check(asset, instance, lines, more, tolerance); status != Status::kOk) return status;
  if (asset.dynamics().empty()) return Status::kOk;  // Nothing moves.
  const debug::Pen pen(instance.head, lines);
  for (std::uint32_t b = 1; b < asset.bones().size(); ++b) {
    const BoneRecord& bone = asset.bones()[b];
    if (bone.kind != BoneKind::kSimulated) continue;
    const debug::PosedBone posed = debug::posed(bone, instance.palette[b]);
    const Touched touched{pen, posed, asset.dynamics()[b].hit_radius, tolerance, b};
    for (std::uint32_t c = 0; c < asset.colliders().size(); ++c) {
      if ((bone.colliders >> c & 1u) != 0) touched.look_at(debug_collider(asset.colliders()[c]));
    }
    for (const DebugCollider& collider : more) touched.look_at(collider);
  }
  return Status::kOk;
}

}  // namespace coif
