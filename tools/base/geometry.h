#pragma once

// Eigen beside the runtime's plain types, and what needs one of its decompositions, whose templates take seconds to
// compile: here they are compiled once.

#include <coif/math.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <numbers>
#include <span>

namespace coif {

inline constexpr double kDegree = std::numbers::pi / 180;  ///< In radians.

[[nodiscard]] inline Eigen::Vector3f to_eigen(const Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline Vec3 to_vec3(const Eigen::Vector3d& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

/// Of a record, made unit.
[[nodiscard]] inline Eigen::Quaterniond rotation_of(const float (&xyzw)[4]) {
  return Eigen::Quaterniond(double(xyzw[3]), double(xyzw[0]), double(xyzw[1]), double(xyzw[2])).normalized();
}

/// `v` turned by the unit quaternion `by`: what Eigen's product is, of which compilers leave calls that take longer
/// than it does.
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

/// Samples, `spacing` metres from one to the next, in the rectangle around a triangle in a picture: what drawing it
/// takes. Of the pictures along the three axes the one that shows most of it.
[[nodiscard]] double samples_around(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c,
                                    double spacing);

/// Those of all triangles together, three of `indices` each.
[[nodiscard]] double samples_around(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices,
                                    double spacing);

/// Point `n` (from 1 on) of a sequence that fills the square 0..1 evenly however far it goes: of the first so many none
/// lies nearer to another, across the square's edges too, than half of one over their root. Source: Roberts 2018, "The
/// unreasonable effectiveness of quasirandom sequences".
[[nodiscard]] Eigen::Vector2d spread_in_square(std::size_t n);

/// The same in a triangle: the weights of its second and third corner, the first one's is what is left of one.
[[nodiscard]] Eigen::Vector2d spread_in_triangle(std::size_t n);

/// Whether along each axis what two boxes have in common is at least that share of what both take up, each of them
/// thicker by `slack`.
[[nodiscard]] bool overlap_on_each_axis(const Eigen::AlignedBox3f& a, const Eigen::AlignedBox3f& b, float least_share,
                                        float slack = 0);

/// The rotation nearest to a transform's linear part, without scale and shear.
[[nodiscard]] Eigen::Matrix3d rotation_part(const Eigen::Affine3d& transform);

/// Columns: unit directions, at right angles, in which a symmetric matrix stretches most, less and least. Which way
/// each points is left to chance.
[[nodiscard]] Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& symmetric);

/// The shortest x of those for which `normal` x is nearest to `right`.
[[nodiscard]] Eigen::Vector4d least_squares(const Eigen::Matrix4d& normal, const Eigen::Vector4d& right);

}  // namespace coif
