#include "report/solvers/mass_spring_solver.h"

#include "report/solvers/point_collisions.h"
#include "report/solvers/segment_spring.h"

namespace coif {

using Eigen::Vector3d;

MassSpringSolver::MassSpringSolver(const Rig& rig, const SolverScene& scene)
    : PosedSolver(rig, scene), springs_(segment_springs(rig)), forces_(rig.bones.size()) {}

void MassSpringSolver::advance(const ParticleStep& step) {
  const ParticleStep begun = look_back(step);
  renew_default_pose(begun);
  add_pose_forces(begun);
  add_springs(begun);
  look_ahead(step);
  for (std::size_t i = 0; i < bone_count(); ++i) {
    velocities_[i] += forces_[i] * step.dt;
    velocities_[i] = falling_velocity(i, step);
    positions_[i] += velocities_[i] * step.dt;
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
