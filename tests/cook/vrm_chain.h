#pragma once
// VRM's spring bones as their specification describes them, to measure the cooker's mapping against.

#include "import/source_model.h"

#include <Eigen/Geometry>

#include <vector>

namespace coif {

/// One chain of joints with a fixed or carried root, no colliders, in double precision.
class VrmChain {
 public:
  /// Joints of length > 0; at rest each points along `rest_directions` (unit, model space).
  VrmChain(std::vector<SourceSpringJoint> joints, std::vector<Eigen::Vector3d> rest_directions);

  /// One frame of 1/60 s that ends with the root at `root`.
  void step(const Eigen::Vector3d& root);
  /// Turns the whole chain about its root, standing still.
  void pose(const Eigen::Quaterniond& rotation);
  [[nodiscard]] const std::vector<Eigen::Vector3d>& tails() const { return tails_; }

 private:
  std::vector<SourceSpringJoint> joints_;
  std::vector<Eigen::Vector3d> rest_;
  std::vector<Eigen::Vector3d> tails_, before_;
};

}  // namespace coif
