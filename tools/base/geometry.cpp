#include "base/geometry.h"

#include <Eigen/Dense>

namespace coif {

Eigen::Quaternionf turn_between(const Eigen::Vector3f& from, const Eigen::Vector3f& to) {
  return Eigen::Quaternionf::FromTwoVectors(from, to);
}

Eigen::Quaterniond turn_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return Eigen::Quaterniond::FromTwoVectors(from, to);
}

Eigen::Matrix3d rotation_part(const Eigen::Affine3d& transform) { return transform.rotation(); }

Eigen::Vector4d least_squares(const Eigen::Matrix4d& normal, const Eigen::Vector4d& right) {
  return normal.completeOrthogonalDecomposition().solve(right);
}

}  // namespace coif
