#pragma once
// Arithmetic on the plain types of coif/math.h, for the simulation's own files.

#include <coif/math.h>

#include <cmath>

namespace coif {

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(const Vec3& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr float dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// A unit vector at a right angle to the unit vector `v`.
inline Vec3 any_perpendicular(const Vec3& v) {
  const Vec3 other = std::fabs(v.x) < 0.6f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 sideways = cross(v, other);
  return sideways * (1.0f / length(sideways));
}

inline bool is_finite(const Vec3& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// Records store vectors and quaternions as bare arrays.
constexpr Vec3 to_vec3(const float (&v)[3]) { return {v[0], v[1], v[2]}; }
constexpr Quat to_quat(const float (&v)[4]) { return {v[0], v[1], v[2], v[3]}; }

/// First b, then a.
constexpr Quat operator*(const Quat& a, const Quat& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
constexpr Quat conjugate(const Quat& q) { return {-q.x, -q.y, -q.z, q.w}; }

/// q must be unit.
constexpr Vec3 rotate(const Quat& q, const Vec3& v) {
  const Vec3 axis{q.x, q.y, q.z};
  const Vec3 twice = cross(axis, v) * 2.0f;
  return v + twice * q.w + cross(axis, twice);
}

}  // namespace coif
