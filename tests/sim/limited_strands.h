#pragma once
// Strands with limits of every kind, and how far bones are beyond theirs: by the definition, not by the solver's way.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>

namespace coif::limits_test {

inline constexpr double kAllowed = 1e-4;  // radians
inline constexpr double kPi = 3.14159265358979;
inline constexpr ChainModel kModels[] = {ChainModel::kCascade, ChainModel::kPassive};
inline constexpr LimitKind kKinds[] = {LimitKind::kCone, LimitKind::kHinge, LimitKind::kSpherical};

struct Point {
  double x, y, z;
};

/// `v` rotated by the conjugate of `q`.
inline Point rotated_back(const float (&q)[4], const Point& v) {
  const double x = -double(q[0]), y = -double(q[1]), z = -double(q[2]), w = q[3];
  const Point t{2 * (y * v.z - z * v.y), 2 * (z * v.x - x * v.z), 2 * (x * v.y - y * v.x)};
  return {v.x + w * t.x + y * t.z - z * t.y, v.y + w * t.y + z * t.x - x * t.z, v.z + w * t.z + x * t.y - y * t.x};
}

/// `v` in the parent's frame `m`.
inline Point in_frame(const Mat34& m, const Point& v) {
  return {double(m.m[0][0]) * v.x + double(m.m[1][0]) * v.y + double(m.m[2][0]) * v.z,
          double(m.m[0][1]) * v.x + double(m.m[1][1]) * v.y + double(m.m[2][1]) * v.z,
          double(m.m[0][2]) * v.x + double(m.m[1][2]) * v.y + double(m.m[2][2]) * v.z};
}

/// How far, at least, a unit direction in the limit's axes is from what the record allows, radians. By its definition,
/// not by the solver's way.
inline double violation(const LimitRecord& limit, const Point& d) {
  const double angle = std::atan2(std::hypot(d.x, d.z), d.y);
  switch (limit.kind) {
    case LimitKind::kUnlimited: return 0;
    case LimitKind::kCone: return std::max(0.0, angle - double(limit.angles[0]));
    case LimitKind::kHinge: return std::max(std::asin(std::min(1.0, std::fabs(d.x))), angle - double(limit.angles[0]));
    case LimitKind::kSpherical: break;
  }
  const double yaw = std::asin(std::clamp(d.x, -1.0, 1.0)), pitch = std::atan2(d.z, d.y);
  const double over = std::fabs(pitch) - double(limit.angles[0]);
  return std::max(std::fabs(yaw) - double(limit.angles[1]), over * std::cos(yaw));
}

/// The worst of the rig's bones under head `instance`. `posed`: frames are turned by these first, one for each bone.
inline double worst_violation(const TestRig& rig, const TestHair& test, std::uint32_t instance = 0,
                              std::span<const Quat> posed = {}) {
  const auto palette = test.hair.palette(instance);
  double worst = 0;
  for (std::size_t i = 1; i < rig.limits.size(); ++i) {
    const float* const rest = rig.bones[i].rest_direction;
    const Vec3 now = transformed(palette[i], {rest[0], rest[1], rest[2]}), zero = transformed(palette[i], {});
    const Point in_head{double(now.x) - double(zero.x), double(now.y) - double(zero.y), double(now.z) - double(zero.z)};
    Point seen = in_frame(palette[rig.bones[i].parent], in_head);
    if (!posed.empty()) seen = rotated_back({posed[i].x, posed[i].y, posed[i].z, posed[i].w}, seen);
    const double v = violation(rig.limits[i], rotated_back(rig.limits[i].rotation, seen));
    worst = v > worst || std::isnan(v) ? v : worst;
  }
  return worst;
}

/// From the limit's y to the direction, by the shortest way, and then about that.
inline Quat axes_towards(const Vec3& direction, double about) {
  const double size = std::hypot(direction.x, direction.z);
  const double angle = std::atan2(size, double(direction.y));
  const Vec3 axis = size > 1e-9 ? Vec3{float(direction.z / size), 0, float(-direction.x / size)} : Vec3{1, 0, 0};
  return product(turned_about(axis, angle), turned_about({0, 1, 0}, about));
}

struct Limited {
  LimitKind kind = LimitKind::kCone;
  float first = 0.4f, second = 0.2f;
};

/// Two strands of four soft bones, the limits' middle the rest direction, their axes turned about that, bone by bone.
inline TestRig strands(ChainModel model, const Limited& limited) {
  TestRig rig;
  rig.model = model;
  for (const float side : {-0.04f, 0.05f}) {
    TestBone bone{.joint = {side, 0.05f, -0.1f}, .rest_direction = {0, -0.8f, -0.6f}, .length = 0.06f};
    bone.stiffness = 40;
    bone.damping = 3;
    bone.friction = 0.5f;
    bone.torsion = model == ChainModel::kCascade && side < 0 ? 20 : kShortestArc;
    rig.add_strand(4, bone);
  }
  for (std::uint32_t i = 1; i < rig.bones.size(); ++i) {
    const float second = limited.kind == LimitKind::kSpherical ? limited.second : 0.0f;
    rig.limit(i, limited.kind, limited.first, second, axes_towards({0, -0.8f, -0.6f}, 0.7 * i));
  }
  return rig;
}

inline StepSettings at_rate(double fps) {
  StepSettings settings;
  settings.dt = float(1 / fps);
  return settings;
}

inline std::string named(ChainModel model, LimitKind kind) {
  return std::string(model == ChainModel::kPassive ? "passive" : "cascade") + ", kind " + std::to_string(int(kind));
}

/// Calls visit(model, kind) for each pair.
inline void for_all(const std::function<void(ChainModel, LimitKind)>& visit) {
  for (const ChainModel model : kModels) {
    for (const LimitKind kind : kKinds) {
      SCOPED_TRACE(named(model, kind));
      visit(model, kind);
    }
  }
}

/// The ends of every frame of a violent motion.
inline std::vector<Vec3> violent_ends(const TestRig& rig, const HairDesc& desc = {}) {
  TestHair test(rig, desc);
  Violence violence(5);
  std::vector<Vec3> all;
  for (int frame = 0; frame < 40; ++frame) {
    const HeadPose pose = frame % 2 == 0 ? violence.next() : wander(frame / 60.0);
    for (std::uint32_t i = 0; i < desc.instances; ++i) {
      if (test.hair.set_head(i, pose) != Status::kOk) return {};
    }
    if (test.hair.step(at_rate(60)) != Status::kOk) return {};
    const auto ends = test.ends(desc.instances - 1);
    all.insert(all.end(), ends.begin(), ends.end());
  }
  return all;
}

inline bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && !a.empty() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

}  // namespace coif::limits_test
