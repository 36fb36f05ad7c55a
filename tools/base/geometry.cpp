#include "base/geometry.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace coif {

namespace {

/// As Eigen's FromTwoVectors(), except for the axis of a half turn, for which Eigen compiles a singular value
/// decomposition.
template <class Scalar>
Eigen::Quaternion<Scalar> turn(const Eigen::Vector3<Scalar>& from, const Eigen::Vector3<Scalar>& to) {
  const Eigen::Vector3<Scalar> a = from.normalized(), b = to.normalized();
  const Scalar cosine = b.dot(a);
  Eigen::Quaternion<Scalar> result;
  if (cosine < Scalar(-1) + Eigen::NumTraits<Scalar>::dummy_precision()) {
    const Scalar squared = (Scalar(1) + std::max(cosine, Scalar(-1))) * Scalar(0.5);
    result.w() = std::sqrt(squared);
    result.vec() = a.unitOrthogonal() * std::sqrt(Scalar(1) - squared);
    return result;
  }
  const Scalar s = std::sqrt((Scalar(1) + cosine) * Scalar(2));
  const Scalar inverse = Scalar(1) / s;
  result.vec() = a.cross(b) * inverse;
  result.w() = s * Scalar(0.5);
  return result;
}

}  // namespace

Eigen::Quaternionf turn_between(const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
  return turn<float>(from, to);
}
Eigen::Quaterniond turn_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return turn<double>(from, to);
}

double samples_around(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c, double spacing) {
  const Eigen::Vector3f size = a.cwiseMax(b).cwiseMax(c) - a.cwiseMin(b).cwiseMin(c);
  const Eigen::Array3d n = size.cast<double>().array() / spacing + 1;
  return std::max({n.x() * n.y(), n.y() * n.z(), n.z() * n.x()});
}

double samples_around(std::span<const Eigen::Vector3f> positions, std::span<const std::uint32_t> indices,
                      double spacing) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    sum += samples_around(positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]], spacing);
  }
  return sum;
}

Eigen::Vector2d spread_in_square(std::size_t n) {
  const double x = double(n) * 0.7548776662466927, y = double(n) * 0.5698402909980532;
  return {x - std::floor(x), y - std::floor(y)};
}

Eigen::Vector2d spread_in_triangle(std::size_t n) {
  const Eigen::Vector2d point = spread_in_square(n);
  return point.sum() > 1 ? Eigen::Vector2d(1 - point.x(), 1 - point.y()) : point;
}

bool overlap_on_each_axis(const Eigen::AlignedBox3f& a, const Eigen::AlignedBox3f& b, float least_share, float slack) {
  for (int axis = 0; axis < 3; ++axis) {
    const float common = std::min(a.max()[axis], b.max()[axis]) - std::max(a.min()[axis], b.min()[axis]) + slack;
    const float both = std::max(a.max()[axis], b.max()[axis]) - std::min(a.min()[axis], b.min()[axis]) + slack;
    if (!(common >= least_share * both)) return false;
  }
  return true;
}

Eigen::Matrix3d rotation_part(const Eigen::Affine3d& transform) { return transform.rotation(); }

Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(symmetric);
  return solved.eigenvectors().rowwise().reverse();  // Eigen has the least first
}

Eigen::Vector4d least_squares(const Eigen::Matrix4d& normal, const Eigen::Vector4d& right) {
  return normal.completeOrthogonalDecomposition().solve(right);
}

}  // namespace coif
