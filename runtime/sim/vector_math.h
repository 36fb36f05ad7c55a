#pragma once
// Arithmetic on the plain types of coif/math.h, for work per step or per head, not per lane.

#include <coif/math.h>
#include <coif/status.h>

#include <cmath>

namespace coif {

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(const Vec3& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr float dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr bool operator==(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
inline float length(const Vec3& a) { return std::sqrt(dot(a, a)); }

/// The part of `v` at a right angle to the unit vector `direction`.
constexpr Vec3 across(const Vec3& v, const Vec3& direction) { return v - direction * dot(v, direction); }

/// `v` made unit; `fallback` where it has no direction or its length is not finite. Equal to direction_or() of the
/// lanes.
inline Vec3 unit_or(const Vec3& v, const Vec3& fallback) {
  const float size2 = dot(v, v);
  const bool has_direction = size2 > 1e-18f && size2 < 1e38f;
  return has_direction ? v * (1.0f / std::sqrt(size2)) : fallback;
}

/// A unit vector at a right angle to the unit vector `v`.
inline Vec3 any_perpendicular(const Vec3& v) {
  const Vec3 other = std::fabs(v.x) < 0.6f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 sideways = cross(v, other);
  return sideways * (1.0f / length(sideways));
}

inline bool is_finite(const double (&place)[3]) {
  return std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]);
}
inline bool is_finite(const Vec3& a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// Records store vectors and quaternions as bare arrays.
constexpr Vec3 to_vec3(const float (&v)[3]) { return {v[0], v[1], v[2]}; }
constexpr Quat to_quat(const float (&v)[4]) { return {v[0], v[1], v[2], v[3]}; }

constexpr bool operator==(const Quat& a, const Quat& b) { return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w; }
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

// Mathematical functions built only from additions and products. Libraries differ between machines in the last bit, and
// the same hair has to move the same way on all of them.
namespace plain {

/// exp(x) to about 1e-15 of it; 0 below -708, close to the largest finite number above 708.
[[nodiscard]] double exp(double x);

/// exp(x) - 1 without cancellation.
[[nodiscard]] double expm1(double x);

struct SineCosine {
  double sine, cosine;
};

/// Accurate to about 1e-15; |x| below 1e6.
[[nodiscard]] SineCosine sine_cosine(double x);

}  // namespace plain

// Rotations as vectors: axis times angle. Paths of rotations are interpolated in this space.

/// The rotation about `v` by the angle |v|, radians.
inline Quat rotation_by(const Vec3& v) {
  const float angle = length(v);
  // sin(x/2)/x: below a milliradian its series is exact in single precision.
  const plain::SineCosine half = plain::sine_cosine(0.5 * double(angle));
  const bool is_large = angle > 1e-3f;
  const float scale = is_large ? float(half.sine) / angle : 0.5f - angle * angle * (1.0f / 48.0f);
  return {v.x * scale, v.y * scale, v.z * scale, float(half.cosine)};
}

/// Restores unit length after several products.
inline Quat renormalised(const Quat& q) {
  const float scale = 1.0f / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  return {q.x * scale, q.y * scale, q.z * scale, q.w * scale};
}

/// The length differs from one by no more than hosts may be off; false for anything with a NaN or an infinity.
[[nodiscard]] bool is_unit(const Quat& rotation);

/// Copies `pose` to `unit` with its rotation normalised. kBadPose or kBadScale as coif/hair.h says; then `unit` is
/// untouched.
Status normalise_pose(const HeadPose& pose, HeadPose& unit);

}  // namespace coif
