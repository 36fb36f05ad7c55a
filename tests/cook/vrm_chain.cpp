#include "cook/vrm_chain.h"

#include "base/geometry.h"

namespace coif::cook {

using Eigen::Quaterniond;
using Eigen::Vector3d;

VrmChain::VrmChain(std::vector<importer::SourceSpringJoint> joints, std::vector<Vector3d> rest_directions)
    : joints_(std::move(joints)), rest_(std::move(rest_directions)), tails_(joints_.size()) {
  pose(Quaterniond::Identity());
}

void VrmChain::pose(const Quaterniond& rotation) {
  Vector3d start = Vector3d::Zero();
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    start += rotation * rest_[j] * joints_[j].length;
    tails_[j] = start;
  }
  before_ = tails_;
}

void VrmChain::step(const Vector3d& root) {
  constexpr double kFrame = 1.0 / 60;
  Vector3d start = root;
  Quaterniond parent = Quaterniond::Identity();  // turn from rest
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const importer::SourceSpringJoint& joint = joints_[j];
    const Vector3d rest = parent * rest_[j];
    const Vector3d next = tails_[j] + (tails_[j] - before_[j]) * (1 - joint.drag) + rest * (joint.stiffness * kFrame) +
                          joint.gravity_direction * (joint.gravity_power * kFrame);
    before_[j] = tails_[j];
    tails_[j] = start + (next - start).normalized() * joint.length;
    parent = turn_between(rest, tails_[j] - start) * parent;
    start = tails_[j];
  }
}

}  // namespace coif::cook
