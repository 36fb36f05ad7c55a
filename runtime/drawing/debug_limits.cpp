#include "drawing/debug_pen.h"

namespace coif {
namespace {

using debug::plus;
using debug::times;
using Kind = DebugLine::Kind;

/// Directions from a bone's start, each as long as the bone.
struct LimitAxes {
  Vec3 x, y, z;  ///< y is the middle direction.
};

/// One bone's limits.
struct LimitOutline {
  const debug::Pen& pen;
  std::uint32_t index;
  Vec3 start;

  void spoke(const Vec3& to) const { pen.line(Kind::kLimit, index, start, plus(start, to)); }
  void arc(const Vec3& center, const Vec3& a, const Vec3& b, float from, float to) const {
    pen.arc(Kind::kLimit, index, plus(start, center), a, b, from, to);
  }

  void draw_cone(const LimitAxes& axes, float angle) const {
    const float cosine = std::cos(angle), sine = std::sin(angle);
    const Vec3 middle = times(axes.y, cosine), u = times(axes.x, sine), v = times(axes.z, sine);
    arc(middle, u, v, 0, debug::kTurn);
    for (const Vec3& rim : {u, v, times(u, -1), times(v, -1)}) spoke(plus(middle, rim));
  }

  void draw_hinge(const LimitAxes& axes, float angle) const {
    arc({}, axes.y, axes.z, -angle, angle);
    for (const float turn : {-angle, 0.0f, angle}) {
      spoke(plus(times(axes.y, std::cos(turn)), times(axes.z, std::sin(turn))));
    }
  }

  // The border of the allowed range of pitch and yaw.
  void draw_spherical(const LimitAxes& axes, float pitch, float yaw) const {
    for (const float sign : {-1.0f, 1.0f}) {
      const Vec3 tilted = plus(times(axes.y, std::cos(pitch)), times(axes.z, sign * std::sin(pitch)));
      arc({}, tilted, axes.x, -yaw, yaw);
      const float cosine = std::cos(yaw), sine = sign * std::sin(yaw);
      arc(times(axes.x, sine), times(axes.y, cosine), times(axes.z, cosine), -pitch, pitch);
      for (const float side : {-sine, sine}) spoke(plus(times(axes.x, side), times(tilted, cosine)));
    }
  }

  void draw(const LimitRecord& limit, const Mat34& parent, float length) const {
    const Quat turn{limit.rotation[0], limit.rotation[1], limit.rotation[2], limit.rotation[3]};
    const auto axis = [&](const Vec3& own) { return times(debug::turned(parent, debug::turned(turn, own)), length); };
    const LimitAxes axes{axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})};
    switch (limit.kind) {
      case LimitKind::kUnlimited: break;
      case LimitKind::kCone: return draw_cone(axes, limit.angles[0]);
      case LimitKind::kHinge: return draw_hinge(axes, limit.angles[0]);
      case LimitKind::kSpherical: return draw_spherical(axes, limit.angles[0], limit.angles[1]);
    }
  }
};

/// Axes about the direction in which the bone was modelled.
LimitAxes rest_axes(const BoneRecord& bone, const Mat34& parent) {
  const Vec3 rest{bone.rest_direction[0], bone.rest_direction[1], bone.rest_direction[2]};
  const Vec3 axis = debug::unit(debug::turned(parent, rest));
  const debug::Across side = debug::across(axis);
  return {times(side.u, bone.length), times(axis, bone.length), times(side.v, bone.length)};
}

}  // namespace

Status draw_limit_lines(const Asset& asset, const HairInstance& instance, const DebugLines& lines) {
  if (const Status status = debug::check(asset, instance, lines); status != Status::kOk) return status;
  if (asset.dynamics().empty()) return Status::kOk;  // Nothing moves.
  const debug::Pen pen(instance.head, lines);
  for (std::uint32_t b = 1; b < asset.bones().size(); ++b) {
    const BoneRecord& bone = asset.bones()[b];
    if (bone.kind != BoneKind::kSimulated) continue;
    const Mat34& parent = instance.palette[bone.parent];
    const LimitOutline outline{pen, b, debug::posed(bone, instance.palette[b]).start};
    const float around_rest = asset.dynamics()[b].angle_limit;
    if (around_rest < kNoAngleLimit) outline.draw_cone(rest_axes(bone, parent), around_rest);
    if (!asset.limits().empty()) outline.draw(asset.limits()[b], parent, bone.length);
  }
  return Status::kOk;
}

}  // namespace coif
