#pragma once

// Eigen's types for the runtime's plain types, and functions that need Eigen's decompositions: their templates take
// seconds to compile, so they are compiled once here.

#include <coif/math.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <numbers>
#include <span>

namespace coif {

inline constexpr double kDegree = std::numbers::pi / 180;  ///< One degree, in radians.

[[nodiscard]] inline Eigen::Vector3f to_eigen(const Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Vec3 to_vec3(const Eigen::Vector3d& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

/// The rotation of a record, normalised.
[[nodiscard]] inline Eigen::Quaterniond rotation_of(const float (&xyzw)[4]) {
  return Eigen::Quaterniond(double(xyzw[3]), double(xyzw[0]), double(xyzw[1]), double(xyzw[2])).normalized();
}

/// `v` turned by the unit quaternion `by`. Same as Eigen's product, for which compilers make calls that take longer
/// than the work.
[[nodiscard, gnu::always_inline]] inline Eigen::Vector3d turned(const Eigen::Quaterniond& by,
                                                                const Eigen::Vector3d& v) {
  const double x = 2 * (by.y() * v.z() - by.z() * v.y()), y = 2 * (by.z() * v.x() - by.x() * v.z()),
               z = 2 * (by.x() * v.y() - by.y() * v.x());
  return {v.x() + by.w() * x + (by.y() * z - by.z() * y), v.y() + by.w() * y + (by.z() * x - by.x() * z),
          v.z() + by.w() * z + (by.x() * y - by.y() * x)};
}

/// Turns `from` towards `to` the shortest way; where they are opposite, about some axis between. Neither need be unit.
[[nodiscard]] Eigen::Quaternionf turn_between(const Eigen::Vector3f& from, const Eigen::Vector3f& to);
[[nodiscard]] Eigen::Quaterniond turn_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Number of samples, `spacing` metres apart, in the rectangle around a triangle's picture: the cost of drawing it.
/// Uses the one of the three axes from which the triangle looks largest.
[[nodiscard]] double samples_around(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                                    double spacing);

/// The sum over all triangles, three of `indices` each.
[[nodiscard]] double samples_around(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices,
                                    double spacing);

/// Point `n` (from 1 on) of a sequence that fills the square 0..1 evenly at every length: among the first N points no
/// two are nearer to each other, also across the square's edges, than 0.5 / sqrt(N). Source: Roberts 2018, "The
/// unreasonable effectiveness of quasirandom sequences".
[[nodiscard]] Eigen::Vector2d spread_in_square(std::size_t n);

/// The same in a triangle: the weights of its second and third corner; the first corner has the rest of 1.
[[nodiscard]] Eigen::Vector2d spread_in_triangle(std::size_t n);

/// Whether the overlap of two boxes on each axis is at least that share of the range that both cover. Each box is first
/// made thicker by `slack`.
[[nodiscard]] bool overlap_on_each_axis(const Eigen::AlignedBox3f& a, const Eigen::AlignedBox3f& b, float least_share,
                                        float slack = 0);

/// The rotation nearest to a transform's linear part, without scale and shear.
[[nodiscard]] Eigen::Matrix3d rotation_part(const Eigen::Affine3d& transform);

/// Columns: perpendicular unit directions in which a symmetric matrix stretches most, less and least. Their signs are
/// arbitrary.
[[nodiscard]] Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& symmetric);

/// The shortest of all x that minimise |`normal` x - `right`|.
[[nodiscard]] Eigen::Vector4d least_squares(const Eigen::Matrix4d& normal, const Eigen::Vector4d& right);

}  // namespace coif
