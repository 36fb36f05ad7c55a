#include "report/solvers/xpbd_solver.h"

#include "report/solvers/point_collisions.h"

namespace coif {

using Eigen::Vector3d;

void XpbdSolver::advance(const ParticleStep& step) {
  before_ = positions_;
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] += falling_velocity(i, step) * step.dt;
  renew_default_pose(step);
  for (std::size_t i = 0; i < bone_count(); ++i) {
    keep_pose(i, step);
    keep_length(i, step);
  }
  for (std::size_t i = 0; i < bone_count(); ++i) {
    positions_[i] = clear_of_colliders(rig(), i, step.head_rotation, positions_[i]);
  }
  for (std::size_t i = 0; i < bone_count(); ++i) velocities_[i] = (positions_[i] - before_[i]) / step.dt;
}

void XpbdSolver::keep_pose(std::size_t i, const ParticleStep& step) {
  const Vector3d start_velocity = hangs_from_head(i) ? step.head_velocity_at(start(i, step))
                                                     : Vector3d((positions_[parent(i)] - before_[parent(i)]) / step.dt);
  positions_[i] += pull(i, positions_[i] - before_[i], start_velocity + swing_velocity(i), step);
}

void XpbdSolver::keep_length(std::size_t i, const ParticleStep& step) {
  const Vector3d along = positions_[i] - start(i, step);
  const Vector3d error = along.normalized() * (along.norm() - bone(i).length);
  if (hangs_from_head(i)) {
    positions_[i] -= error;
  } else {
    positions_[i] -= error * 0.5;
    positions_[parent(i)] += error * 0.5;
  }
}

}  // namespace coif
