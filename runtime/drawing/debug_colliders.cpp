#include "drawing/debug_pen.h"

namespace coif {
namespace {

using debug::plus;
using debug::times;
using Kind = DebugLine::Kind;

constexpr float kPlaneHalf = 0.3f, kPlaneNormal = 0.1f;  // metres

/// A collider to draw, and its number.
struct Outline {
  const debug::Pen& pen;
  const DebugCollider& of;
  std::uint32_t index;

  void line(const Vec3& a, const Vec3& b) const { pen.line(Kind::kCollider, index, a, b); }

  void draw() const {
    if (debug::is_box(of)) return draw_box();
    if (debug::is_capsule(of)) return draw_capsule();
    if (of.shape == ColliderShape::kPlane) return draw_plane();
    draw_ellipsoid();
  }

  void draw_ellipsoid() const {
    const bool is_sphere = of.shape == ColliderShape::kSphere;
    const Vec3 radii = is_sphere ? Vec3{of.radii.x, of.radii.x, of.radii.x} : of.radii;
    const Quat turn = is_sphere ? Quat{} : of.rotation;
    const Vec3 x = debug::turned(turn, {radii.x, 0, 0}), y = debug::turned(turn, {0, radii.y, 0});
    const Vec3 z = debug::turned(turn, {0, 0, radii.z});
    pen.arc(Kind::kCollider, index, of.center, x, y);
    pen.arc(Kind::kCollider, index, of.center, y, z);
    pen.arc(Kind::kCollider, index, of.center, z, x);
  }

  // Two outlines at right angles: along the cone's sides, which touch both balls, and around the ends.
  void draw_capsule() const {
    const float size = debug::length(of.axis), first = of.radii.x, last = debug::end_radius(of);
    const Vec3 axis = debug::unit(of.axis), other = plus(of.center, of.axis);
    const debug::Across side = debug::across(axis);
    const float sine = size > 0.0f && std::fabs(first - last) < size ? (first - last) / size : 0.0f;
    const float cosine = std::sqrt(1.0f - sine * sine), slant = std::atan2(sine, cosine);
    for (const Vec3& way : {side.u, side.v}) {
      pen.arc(Kind::kCollider, index, other, times(way, last), times(axis, last), slant, 0.5f * debug::kTurn - slant);
      pen.arc(Kind::kCollider, index, of.center, times(way, first), times(axis, first), 0.5f * debug::kTurn - slant,
              debug::kTurn + slant);
      for (const float sign : {-1.0f, 1.0f}) {
        const Vec3 out = plus(times(way, sign * cosine), times(axis, sine));
        line(plus(of.center, times(out, first)), plus(other, times(out, last)));
      }
    }
    draw_ring(of.center, axis, side, first * sine, first * cosine);
    draw_ring(other, axis, side, last * sine, last * cosine);
  }

  void draw_ring(const Vec3& center, const Vec3& axis, const debug::Across& side, float along, float radius) const {
    pen.arc(Kind::kCollider, index, plus(center, times(axis, along)), times(side.u, radius), times(side.v, radius));
  }

  void draw_plane() const {
    const Vec3 normal = debug::unit(of.axis);
    const debug::Across side = debug::across(normal);
    const Vec3 u = times(side.u, kPlaneHalf), v = times(side.v, kPlaneHalf);
    const Vec3 corners[] = {plus(u, v), debug::minus(v, u), times(plus(u, v), -1), debug::minus(u, v)};
    for (int i = 0; i < 4; ++i) line(plus(of.center, corners[i]), plus(of.center, corners[(i + 1) % 4]));
    line(plus(of.center, corners[0]), plus(of.center, corners[2]));
    line(plus(of.center, corners[1]), plus(of.center, corners[3]));
    line(of.center, plus(of.center, times(normal, kPlaneNormal)));
  }

  [[nodiscard]] Vec3 corner(int number) const {
    const auto side = [&](int bit, float half) { return (number & bit) != 0 ? half : -half; };
    const float round = of.radii.x;
    const Vec3 half = plus(of.half_extents, {round, round, round});
    return plus(of.center, debug::turned(of.rotation, {side(1, half.x), side(2, half.y), side(4, half.z)}));
  }
  void draw_box() const {
    for (int number = 0; number < 8; ++number) {
      for (const int bit : {1, 2, 4}) {
        if ((number & bit) == 0) line(corner(number), corner(number | bit));
      }
    }
  }
};

Vec3 vec3(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

Status check(const HeadPose& head, const DebugLines& lines) {
  if (lines.draw == nullptr) return Status::kBadArgument;
  return check_pose(head);
}

}  // namespace

DebugCollider debug_collider(const ColliderRecord& c) {
  DebugCollider collider;
  collider.shape = c.shape;
  collider.center = vec3(c.center);
  collider.axis = vec3(c.axis);
  collider.radii = vec3(c.radii);
  collider.rotation = {c.rotation[0], c.rotation[1], c.rotation[2], c.rotation[3]};
  collider.keeps_inside = (c.flags & kColliderKeepsInside) != 0;
  return collider;
}

Status draw_collider_lines(std::span<const DebugCollider> colliders, const HeadPose& head, const DebugLines& lines,
                           std::uint32_t first) {
  if (const Status status = check(head, lines); status != Status::kOk) return status;
  for (const DebugCollider& collider : colliders) {
    if (!debug::is_finite(collider)) return Status::kBadArgument;
  }
  const debug::Pen pen(head, lines);
  for (const DebugCollider& collider : colliders) Outline{pen, collider, first++}.draw();
  return Status::kOk;
}

Status draw_collider_lines(const Asset& asset, const HeadPose& head, const DebugLines& lines) {
  if (!asset.is_open()) return Status::kAssetLacksData;
  if (const Status status = check(head, lines); status != Status::kOk) return status;
  const debug::Pen pen(head, lines);
  std::uint32_t index = 0;
  for (const ColliderRecord& record : asset.colliders()) Outline{pen, debug_collider(record), index++}.draw();
  return Status::kOk;
}

}  // namespace coif
