#include "report/solvers/posed_solver.h"

namespace coif {

using Eigen::Vector3d;

void PosedSolver::renew_default_pose(const ParticleStep& step) {
  std::vector<Vector3d> directions = shared_directions(step);
  turns_.resize(bone_count());
  for (std::size_t i = 0; i < bone_count(); ++i) turns_[i] = (directions[i] - directions_[i]) / step.dt;
  directions_ = std::move(directions);
}

Vector3d PosedSolver::pull(std::size_t i, const Vector3d& way, const Vector3d& default_velocity,
                           const ParticleStep& step) const {
  const double spring = bone(i).stiffness * step.dt * step.dt;
  const double damper = bone(i).damping * step.dt;
  const Vector3d off = default_position(i, step) - positions_[i];
  return (off * spring + (default_velocity * step.dt - way) * damper) / (1 + spring + damper);
}

}  // namespace coif
