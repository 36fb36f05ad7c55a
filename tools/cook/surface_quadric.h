#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace coif {

/// The squared distances of a point from several planes, each times a weight, as one polynomial (Garland and Heckbert
/// 1997, "Surface simplification using quadric error metrics").
class SurfaceQuadric {
 public:
  /// `normal` has length 1.
  void add_plane(const Eigen::Vector3d& normal, const Eigen::Vector3d& on_plane, double weight) {
    const double offset = -normal.dot(on_plane);
    square_ += weight * normal * normal.transpose();
    linear_ += weight * offset * normal;
    constant_ += weight * offset * offset;
  }

  void add(const SurfaceQuadric& other) {
    square_ += other.square_;
    linear_ += other.linear_;
    constant_ += other.constant_;
  }

  [[nodiscard]] double at(const Eigen::Vector3d& point) const {
    return point.dot(square_ * point) + 2 * linear_.dot(point) + constant_;
  }

 private:
  Eigen::Matrix3d square_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d linear_ = Eigen::Vector3d::Zero();
  double constant_ = 0;
};

}  // namespace coif
