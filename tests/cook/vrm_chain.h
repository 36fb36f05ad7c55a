#pragma once

// VRM's spring bones as their specification describes them, to measure the cooker's mapping against.

#include "import/source_model.h"
#include "models/test_rig.h"

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace coif::cook {

/// One chain of joints with a fixed or carried root, no colliders, in double precision.
class VrmChain {
 public:
  /// Joints of length > 0; at rest each points along `rest_directions` (unit, model space).
  VrmChain(std::vector<importer::SourceSpringJoint> joints, std::vector<Eigen::Vector3d> rest_directions);

  /// One frame of 1/60 s that ends with the root at `root`.
  void step(const Eigen::Vector3d& root);
  /// Turns the whole chain about its root, standing still.
  void pose(const Eigen::Quaterniond& rotation);
  [[nodiscard]] const std::vector<Eigen::Vector3d>& tails() const { return tails_; }

 private:
  std::vector<importer::SourceSpringJoint> joints_;
  std::vector<Eigen::Vector3d> rest_;
  std::vector<Eigen::Vector3d> tails_, before_;
};

struct SoftChain {
  int bones = 5;
  float length = 0.4f;      ///< The whole chain's, metres.
  float stiffness = 600;    ///< At the root, 1/s^2; a quarter of it at the tip.
  float damping_ratio = 0;  ///< Share of critical damping against the pose.
};

/// A head with one chain that hangs down behind it, without friction.
[[nodiscard]] inline TestRig rig_of_chain(const SoftChain& chain) {
  TestRig rig;
  std::uint32_t parent = 0;
  for (int i = 0; i < chain.bones; ++i) {
    const float share = chain.bones > 1 ? float(i) / float(chain.bones - 1) : 0;
    const float stiffness = chain.stiffness * (1 - 0.75f * share);
    parent = rig.add({.parent = parent,
                      .joint = {0, 0.02f, -0.12f},
                      .rest_direction = {0, -0.8f, -0.6f},
                      .length = chain.length / float(chain.bones),
                      .stiffness = stiffness,
                      .damping = 2 * chain.damping_ratio * std::sqrt(stiffness + 200),
                      .torsion = 20});
  }
  return rig;
}

}  // namespace coif::cook
