#include "report/solvers/impulse_solver.h"

#include "report/solvers/constant_pull.h"
#include "report/solvers/point_collisions.h"

namespace coif {

using Eigen::Vector3d;

ImpulseSolver::ImpulseSolver(const Rig& rig, const SolverScene& scene, int iterations)
    : ParticleSolver(rig, scene), iterations_(iterations) {}

void ImpulseSolver::advance(const ParticleStep& step) {
  before_ = positions_;
  for (std::size_t i = 0; i < bone_count(); ++i) velocities_[i] = falling_velocity(i, step);
  pull_to_default(step);
  for (int pass = 0; pass < iterations_; ++pass) {
    keep_lengths(step);
    keep_clear(step);
  }
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] = foreseen(i, step);
}

void ImpulseSolver::pull_to_default(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] = foreseen(i, step);
  const std::vector<Vector3d> directions = default_directions(step);
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d off = start(i, step) + directions[i] * bone(i).length - positions_[i];
    velocities_[i] += constant_pull(bone(i), off, step.dt);
    positions_[i] = foreseen(i, step);
  }
}

void ImpulseSolver::keep_lengths(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d along = foreseen(i, step) - (hangs_from_head(i) ? start(i, step) : foreseen(parent(i), step));
    const Vector3d impulse = along.normalized() * ((along.norm() - bone(i).length) / step.dt);
    if (hangs_from_head(i)) {
      velocities_[i] -= impulse;
    } else {
      velocities_[i] -= impulse * 0.5;
      velocities_[parent(i)] += impulse * 0.5;
    }
  }
}

void ImpulseSolver::keep_clear(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d end = foreseen(i, step);
    velocities_[i] += (clear_of_colliders(rig(), i, step.head_rotation, end) - end) / step.dt;
  }
}

}  // namespace coif
