#include "report/solvers/impulse_solver.h"

#include "report/solvers/constant_pull.h"
#include "report/solvers/point_collisions.h"

namespace coif {

using Eigen::Vector3d;

ImpulseSolver::ImpulseSolver(const Rig& rig, const SolverScene& scene, int iterations)
    : ParticleSolver(rig, scene), iterations_(iterations) {}

void ImpulseSolver::advance(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) velocities_[i] = falling_velocity(i, step);
  pull_to_default(look_back(step));
  look_ahead(step);
  for (int pass = 0; pass < iterations_; ++pass) {
    keep_lengths(step);
    keep_clear(step);
  }
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] = foreseen(i, step);
}

void ImpulseSolver::pull_to_default(const ParticleStep& begun) {
  const std::vector<Vector3d> directions = default_directions(begun);
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d off = start(i, begun) + directions[i] * bone(i).length - positions_[i];
    velocities_[i] += off.normalized() * constant_pull(bone(i));
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
