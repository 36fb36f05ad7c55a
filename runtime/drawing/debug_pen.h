#pragma once
// Shared by the functions of coif/debug_lines.h: arithmetic in head space, and the way from there to the host.

#include "drawing/head_pose.h"

#include <coif/debug_lines.h>

#include <cmath>
#include <cstdint>

namespace coif::debug {

inline constexpr float kTurn = 6.2831853f;  // radians

inline Vec3 plus(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 times(const Vec3& a, float by) { return {a.x * by, a.y * by, a.z * by}; }
inline float dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(const Vec3& v) { return std::sqrt(dot(v, v)); }
/// The unit vector; upwards for a vector of no length.
inline Vec3 unit(const Vec3& v) {
  const float size = length(v);
  return size > 0.0f ? times(v, 1.0f / size) : Vec3{0, 1, 0};
}
inline Vec3 turned(const Quat& q, const Vec3& v) {
  const Vec3 u{q.x, q.y, q.z}, t = times(cross(u, v), 2.0f);
  return plus(plus(v, times(t, q.w)), cross(u, t));
}
inline Vec3 turned(const Mat34& m, const Vec3& v) {
  const auto row = [&](int i) { return m.m[i][0] * v.x + m.m[i][1] * v.y + m.m[i][2] * v.z; };
  return {row(0), row(1), row(2)};
}
inline Vec3 moved(const Mat34& m, const Vec3& v) { return plus(turned(m, v), {m.m[0][3], m.m[1][3], m.m[2][3]}); }

/// Two directions at right angles to `axis` (unit) and to each other.
struct Across {
  Vec3 u, v;
};
inline Across across(const Vec3& axis) {
  const bool is_upright = std::fabs(axis.y) > 0.9f;
  const Vec3 u = unit(cross(is_upright ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, axis));
  return {u, cross(axis, u)};
}

/// A simulated bone in a pose, head space.
struct PosedBone {
  Vec3 start, end;
};
inline PosedBone posed(const BoneRecord& bone, const Mat34& matrix) {
  const Vec3 joint{bone.joint[0], bone.joint[1], bone.joint[2]};
  const Vec3 rest{bone.rest_direction[0], bone.rest_direction[1], bone.rest_direction[2]};
  return {moved(matrix, joint), moved(matrix, plus(joint, times(rest, bone.length)))};
}

/// Draws lines that are given in head space.
class Pen {
 public:
  /// `head` must be valid.
  Pen(const HeadPose& head, const DebugLines& lines) : head_(head), turn_(turn_of(head)), lines_(lines) {}

  void line(DebugLine::Kind kind, std::uint32_t index, const Vec3& from, const Vec3& to) const {
    DebugLine line{{}, {}, kind, index};
    place(from, line.from);
    place(to, line.to);
    lines_.draw(line, lines_.user);
  }

  /// Part of an ellipse, from `center + a` towards `center + b`, radians.
  void arc(DebugLine::Kind kind, std::uint32_t index, const Vec3& center, const Vec3& a, const Vec3& b, float from = 0,
           float to = kTurn) const {
    constexpr int kPieces = 32;  // Pieces of a whole ellipse.
    const int pieces = 1 + int(float(kPieces - 1) * (to - from) / kTurn + 0.5f);
    const auto at = [&](int i) {
      const float angle = from + (to - from) * float(i) / float(pieces);
      return plus(center, plus(times(a, std::cos(angle)), times(b, std::sin(angle))));
    };
    for (int i = 0; i < pieces; ++i) line(kind, index, at(i), at(i + 1));
  }

 private:
  void place(const Vec3& p, double (&out)[3]) const {
    for (int i = 0; i < 3; ++i) {
      const double(&row)[3] = turn_.rows[i];
      out[i] = head_.position[i] + row[0] * double(p.x) + row[1] * double(p.y) + row[2] * double(p.z);
    }
  }

  const HeadPose& head_;
  HeadTurn turn_;
  const DebugLines& lines_;
};

/// The checks that all functions for a HairInstance share.
inline Status check(const Asset& asset, const HairInstance& instance, const DebugLines& lines) {
  if (!asset.is_open()) return Status::kAssetLacksData;
  if (lines.draw == nullptr) return Status::kBadArgument;
  if (instance.palette.size() != asset.bones().size()) return Status::kSizeMismatch;
  return check_pose(instance.head);
}

inline bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
inline bool is_finite(const DebugCollider& c) {
  return is_finite(c.center) && is_finite(c.axis) && is_finite(c.radii) && is_finite(c.half_extents) &&
         is_finite(Vec3{c.rotation.x, c.rotation.y, c.rotation.z}) && std::isfinite(c.rotation.w);
}
inline bool is_box(const DebugCollider& c) { return c.shape == ColliderShape::kBox; }
inline bool is_capsule(const DebugCollider& c) {
  return c.shape == ColliderShape::kCapsule || c.shape == ColliderShape::kTaperedCapsule;
}
/// The radius at a capsule's other end.
inline float end_radius(const DebugCollider& c) {
  return c.shape == ColliderShape::kTaperedCapsule ? c.radii.y : c.radii.x;
}

}  // namespace coif::debug
