#include "report/solvers/mass_spring_solver.h"

#include "report/solvers/point_collisions.h"
#include "report/solvers/segment_spring.h"

namespace coif {

using Eigen::Vector3d;

MassSpringSolver::MassSpringSolver(const Rig& rig, const SolverScene& scene)
    : PosedSolver(rig, scene), springs_(segment_springs(rig)), forces_(rig.bones.size()) {}

void MassSpringSolver::advance(const ParticleStep& step) {
  // Forces are those of the step's start, seen from where the head was then: judged by where it now is, one at 8 m/s
  // would have left its hair a step's way behind.
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

}  // namespace coif
