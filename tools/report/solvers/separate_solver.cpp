#include "report/solvers/separate_solver.h"

#include "report/solvers/constant_pull.h"
#include "report/solvers/point_collisions.h"

namespace coif {

using Eigen::Vector3d;

SeparateSolver::SeparateSolver(const Rig& rig, const SolverScene& scene, int iterations)
    : ParticleSolver(rig, scene), iterations_(iterations) {}

void SeparateSolver::advance(const ParticleStep& step) {
  move(step);
  for (int pass = 0; pass < iterations_; ++pass) {
    for (std::size_t i = 0; i < bone_count(); ++i) keep_length(i, step);
    for (std::size_t i = 0; i < bone_count(); ++i) push_out(rig(), i, step, positions_[i], velocities_[i]);
  }
}

void SeparateSolver::move(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) velocities_[i] = falling_velocity(i, step);
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] += velocities_[i] * step.dt;
  const std::vector<Vector3d> directions = default_directions(step);
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d off = start(i, step) + directions[i] * bone(i).length - positions_[i];
    const Vector3d pull = constant_pull(bone(i), off, step.dt);
    velocities_[i] += pull;
    positions_[i] += pull * step.dt;
  }
}

void SeparateSolver::keep_length(std::size_t i, const ParticleStep& step) {
  const Vector3d from = start(i, step);
  const Vector3d direction = (positions_[i] - from).normalized();
  const Vector3d error = direction * ((positions_[i] - from).norm() - bone(i).length);
  const Vector3d start_velocity = hangs_from_head(i) ? step.head_velocity_at(from) : velocities_[parent(i)];
  const Vector3d parting = direction * (velocities_[i] - start_velocity).dot(direction);
  const double share = hangs_from_head(i) ? 1.0 : 0.5;
  positions_[i] -= error * share;
  velocities_[i] -= parting * share;
  if (hangs_from_head(i)) return;
  positions_[parent(i)] += error * share;
  velocities_[parent(i)] += parting * share;
}

}  // namespace coif
