#include "report/solvers/implicit_solver.h"

#include "report/solvers/point_collisions.h"
#include "report/solvers/segment_spring.h"

#include <algorithm>

namespace coif {

using Eigen::Matrix3d;
using Eigen::Vector3d;

ImplicitSolver::ImplicitSolver(const Rig& rig, const SolverScene& scene)
    : PosedSolver(rig, scene), springs_(segment_springs(rig)), rows_(rig.bones.size()), changes_(rig.bones.size()) {}

void ImplicitSolver::advance(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) velocities_[i] = falling_velocity(i, step);
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] += velocities_[i] * step.dt;
  renew_default_pose(step);
  begin_rows(step);
  add_springs(step);
  solve();
  for (std::size_t i = 0; i < bone_count(); ++i) {
    velocities_[i] += changes_[i];
    positions_[i] += changes_[i] * step.dt;
    push_out(rig(), i, step, positions_[i], velocities_[i]);
  }
}

/// Masses and the pose's pull, which follows the parent.
void ImplicitSolver::begin_rows(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const double spring = bone(i).stiffness * step.dt;
    const double damper = bone(i).damping * step.dt;
    const double change = spring * step.dt + damper;
    rows_[i].diagonal = Matrix3d::Identity() * (1 + change);
    rows_[i].by_parent = Matrix3d::Identity() * (hangs_from_head(i) ? 0 : -change);
    rows_[i].on_parent.setZero();
    rows_[i].right =
        (default_position(i, step) - positions_[i]) * spring + (default_velocity(i, step) - velocities_[i]) * damper;
  }
}

void ImplicitSolver::add_springs(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d along = positions_[i] - start(i, step);
    const double length = along.norm();
    const Vector3d direction = along.normalized();
    const Matrix3d axial = direction * direction.transpose();
    // A compressed spring would push sideways and make the system indefinite; Baraff and Witkin drop that part too.
    const double sideways = length > 0 ? std::max(0.0, 1 - bone(i).length / length) : 0.0;
    const Matrix3d stiffness = (axial + (Matrix3d::Identity() - axial) * sideways) * (springs_[i] * step.dt * step.dt);
    const Vector3d impulse = direction * ((length - bone(i).length) * springs_[i] * step.dt);
    rows_[i].diagonal += stiffness;
    rows_[i].right -= impulse;
    if (hangs_from_head(i)) continue;
    rows_[i].by_parent -= stiffness;
    rows_[i].on_parent -= stiffness;
    rows_[parent(i)].diagonal += stiffness;
    rows_[parent(i)].right += impulse;
  }
}

void ImplicitSolver::solve() {
  for (std::size_t i = bone_count(); i-- > 0;) {
    Block& row = rows_[i];
    row.diagonal = row.diagonal.inverse().eval();
    if (hangs_from_head(i)) continue;
    const Matrix3d weight = row.on_parent * row.diagonal;
    rows_[parent(i)].diagonal -= weight * row.by_parent;
    rows_[parent(i)].right -= weight * row.right;
  }
  for (std::size_t i = 0; i < bone_count(); ++i) {
    Vector3d right = rows_[i].right;
    if (!hangs_from_head(i)) right -= rows_[i].by_parent * changes_[parent(i)];
    changes_[i] = rows_[i].diagonal * right;
  }
}

}  // namespace coif
