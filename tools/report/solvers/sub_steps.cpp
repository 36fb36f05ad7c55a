#include "report/solvers/sub_steps.h"

#include <Eigen/Geometry>

namespace coif {
namespace {

using Eigen::Quaterniond;

Quaterniond rotation_of(const HeadPose& head) {
  return Quaterniond(head.rotation.w, head.rotation.x, head.rotation.y, head.rotation.z);
}

HeadPose between(const HeadPose& from, const HeadPose& to, double share) {
  HeadPose pose;
  for (int axis = 0; axis < 3; ++axis) {
    pose.position[axis] = from.position[axis] + (to.position[axis] - from.position[axis]) * share;
  }
  const Quaterniond turned = rotation_of(from).slerp(share, rotation_of(to));
  pose.rotation = {float(turned.x()), float(turned.y()), float(turned.z()), float(turned.w())};
  return pose;
}

class SubSteps final : public ChainSolver {
 public:
  SubSteps(std::unique_ptr<ChainSolver> solver, int count) : solver_(std::move(solver)), count_(count) {}

  void reset(const HeadPose& head) override {
    head_ = head;
    solver_->reset(head);
  }

  bool step(const HeadPose& head, double dt) override {
    for (int i = 1; i <= count_; ++i) {
      // What is refused is refused at the first of them, with nothing moved: NaN has no finite share.
      if (!solver_->step(i < count_ ? between(head_, head, double(i) / count_) : head, dt / count_)) return false;
    }
    head_ = head;
    return true;
  }

  std::span<const Eigen::Vector3d> bone_ends() const override { return solver_->bone_ends(); }

 private:
  std::unique_ptr<ChainSolver> solver_;
  int count_;
  HeadPose head_;
};

}  // namespace

std::unique_ptr<ChainSolver> in_sub_steps(std::unique_ptr<ChainSolver> solver, int count) {
  if (count <= 1) return solver;
  return std::make_unique<SubSteps>(std::move(solver), count);
}

}  // namespace coif
