#include "research/solvers/historical_solvers.h"
#include "research/solvers/particle_solver.h"

#include <algorithm>
#include <cmath>

namespace coif::research {

using Eigen::Vector3d;

MassSpringSolver::MassSpringSolver(const lab::Rig& rig, const lab::SolverScene& scene)
    : PosedSolver(rig, scene), forces_(rig.bones.size()), springs_(segment_springs(rig)) {}

void MassSpringSolver::advance(const ParticleStep& step) {
  // Forces are those of the step's start, relative to the head's place then: relative to its present place, a head at 8
  // m/s would have left its hair behind by a step's way.
  const Vector3d head_way = step.head_velocity * step.dt;
  for (Vector3d& position : positions_) position += head_way;
  ParticleStep begun = step;
  begun.head_rotation = step.rotation_before;
  renew_default_pose(begun);
  add_pose_forces(begun);
  add_springs(begun);
  for (std::size_t i = 0; i < bone_count(); ++i) {
    velocities_[i] += forces_[i] * step.dt;
    velocities_[i] = falling_velocity(i, step);
    positions_[i] += velocities_[i] * step.dt - head_way;
    push_out(rig(), i, step, positions_[i], velocities_[i]);
  }
}

void MassSpringSolver::add_pose_forces(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) {
    forces_[i] = (default_position(i, step) - positions_[i]) * bone(i).stiffness +
                 (default_velocity(i, step) - velocities_[i]) * bone(i).damping;
  }
}

void MassSpringSolver::add_springs(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d along = positions_[i] - start(i, step);
    const Vector3d force = along.normalized() * ((along.norm() - bone(i).length) * springs_[i]);
    forces_[i] -= force;
    if (!hangs_from_head(i)) forces_[parent(i)] += force;
  }
}

AngularSpringSolver::AngularSpringSolver(const lab::Rig& rig, const lab::SolverScene& scene)
    : MassSpringSolver(rig, scene), inertia_(rig.bones.size(), 0) {
  std::vector<Vector3d> starts, tails;
  for (std::size_t i = 0; i < bone_count(); ++i) {
    starts.push_back(hangs_from_head(i) ? bone(i).joint : tails[parent(i)]);
    tails.push_back(starts[i] + bone(i).rest_direction * bone(i).length);
    for (int up = int(i); up >= 0; up = bone(std::size_t(up)).parent) {
      inertia_[std::size_t(up)] += (tails[i] - starts[std::size_t(up)]).squaredNorm();
    }
  }
}

void AngularSpringSolver::add_pose_forces(const ParticleStep& step) {
  forces_.assign(bone_count(), Vector3d::Zero());
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d lower = torque(i, step);
    turn(i, lower, step);
    if (!hangs_from_head(i)) turn(parent(i), -lower * bone(i).parent_share, step);
  }
}

Vector3d AngularSpringSolver::torque(std::size_t i, const ParticleStep& step) const {
  const Vector3d along = positions_[i] - start(i, step);
  const Vector3d direction = along.normalized(), to = default_direction(i).normalized();
  const Vector3d axis = direction.cross(to);
  const double angle = std::atan2(axis.norm(), direction.dot(to));
  const Vector3d off = axis.norm() > 0 ? Vector3d(axis.normalized() * angle) : Vector3d::Zero();
  const Vector3d spin = direction.cross(velocities_[i] - start_velocity(i, step)) / std::max(along.norm(), 1e-12);
  const Vector3d default_spin = to.cross(swing_velocity(i)) / bone(i).length;
  const Vector3d all = off * bone(i).stiffness + (default_spin - spin) * bone(i).damping;
  return (all - direction * all.dot(direction)) * inertia_[i];
}

void AngularSpringSolver::turn(std::size_t i, const Vector3d& torque, const ParticleStep& step) {
  const Vector3d along = positions_[i] - start(i, step);
  const Vector3d force = torque.cross(along) / std::max(along.squaredNorm(), 1e-12);
  forces_[i] += force;
  if (!hangs_from_head(i)) forces_[parent(i)] -= force;
}

using Eigen::Vector3d;

ImpulseSolver::ImpulseSolver(const lab::Rig& rig, const lab::SolverScene& scene, int iterations)
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

using Eigen::Vector3d;

SeparateSolver::SeparateSolver(const lab::Rig& rig, const lab::SolverScene& scene, int iterations)
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

}  // namespace coif::research
