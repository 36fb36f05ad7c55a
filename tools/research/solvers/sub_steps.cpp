#include "motion/motion_path.h"
#include "research/solvers/historical_solvers.h"
#include "research/solvers/particle_solver.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

namespace coif::research {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Cubic from 0 to `to` within 1, with these slopes.
Vector3d hermite(const Vector3d& to, const Vector3d& slope, const Vector3d& end_slope, double share) {
  const double s2 = share * share, s3 = s2 * share;
  return (3 * s2 - 2 * s3) * to + (s3 - 2 * s2 + share) * slope + (s3 - s2) * end_slope;
}

/// The way of a head between poses, as in the runtime (runtime/docs/MODEL.md, "The step", 1): a cubic whose slopes are
/// those of the parabola through three poses. So the sub-steps of other solvers have no corners that the runtime's
/// lack.
class SmoothWay {
 public:
  void begin(const HeadPose& head) {
    head_ = head;
    last_dt_ = 0;
  }

  /// On to `head`, which ends a frame of `dt` seconds.
  void aim(const HeadPose& head, double dt) {
    way_ = Eigen::Map<const Vector3d>(head.position) - Eigen::Map<const Vector3d>(head_.position);
    turn_ = motion::vector_of(rotation_of(head_).conjugate() * rotation_of(head));
    const Vector3d mean = way_ / dt, mean_spin = turn_ / dt;
    const double share = last_dt_ > 0 ? dt / (dt + last_dt_) : 0;
    end_velocity_ = last_dt_ > 0 ? Vector3d(mean + (mean - last_mean_) * share) : mean;
    end_spin_ = last_dt_ > 0 ? Vector3d(mean_spin + (mean_spin - last_mean_spin_) * share) : mean_spin;
    if (!(last_dt_ > 0)) velocity_ = mean, spin_ = mean_spin;
    dt_ = dt;
  }

  [[nodiscard]] HeadPose at(double share) const {
    HeadPose pose;
    const Vector3d moved = hermite(way_, velocity_ * dt_, end_velocity_ * dt_, share);
    for (int axis = 0; axis < 3; ++axis) pose.position[axis] = head_.position[axis] + moved[axis];
    const Vector3d end_rate = motion::rate_of(turn_, end_spin_) * dt_;
    const Quaterniond turned = rotation_of(head_) * motion::rotation_of(hermite(turn_, spin_ * dt_, end_rate, share));
    pose.rotation = {float(turned.x()), float(turned.y()), float(turned.z()), float(turned.w())};
    return pose;
  }

  void arrive(const HeadPose& head) {
    last_mean_ = way_ / dt_;
    last_mean_spin_ = turn_ / dt_;
    velocity_ = end_velocity_;
    spin_ = end_spin_;
    last_dt_ = dt_;
    head_ = head;
  }

  [[nodiscard]] const HeadPose& head() const { return head_; }

 private:
  HeadPose head_;
  double dt_ = 0, last_dt_ = 0;  ///< Seconds; 0: there was no frame before.
  // World axes, and the head's own for turns; m, rad, and these per second.
  Vector3d way_ = Vector3d::Zero(), turn_ = Vector3d::Zero();
  Vector3d velocity_ = Vector3d::Zero(), end_velocity_ = Vector3d::Zero(), last_mean_ = Vector3d::Zero();
  Vector3d spin_ = Vector3d::Zero(), end_spin_ = Vector3d::Zero(), last_mean_spin_ = Vector3d::Zero();
};

class SubSteps final : public lab::ChainSolver {
 public:
  SubSteps(std::unique_ptr<lab::ChainSolver> solver, int count) : solver_(std::move(solver)), count_(count) {}

  void reset(const HeadPose& head) override {
    way_.begin(head);
    solver_->reset(head);
  }

  bool step(const HeadPose& head, double dt) override {
    // A cubic makes finite poses of some that are not.
    if (!(dt > 0) || !std::isfinite(dt) || !is_finite(head)) return false;
    if (jumps(way_.head(), head)) {
      // After a jump there is no way in between.
      if (!solver_->step(head, dt)) return false;
      way_.begin(head);
      return true;
    }
    SmoothWay aimed = way_;
    aimed.aim(head, dt);
    for (int i = 1; i <= count_; ++i) {
      // Invalid input is refused in the first of them, with nothing moved: NaN has no finite share.
      if (!solver_->step(i < count_ ? aimed.at(double(i) / count_) : head, dt / count_)) return false;
    }
    aimed.arrive(head);
    way_ = aimed;
    return true;
  }

  std::span<const Vector3d> bone_ends() const override { return solver_->bone_ends(); }

 private:
  std::unique_ptr<lab::ChainSolver> solver_;
  int count_;
  SmoothWay way_;
};

}  // namespace

std::unique_ptr<lab::ChainSolver> in_sub_steps(std::unique_ptr<lab::ChainSolver> solver, int count) {
  if (count <= 1) return solver;
  return std::make_unique<SubSteps>(std::move(solver), count);
}

}  // namespace coif::research
