#include "report/solvers/follow_leader_solver.h"

#include "report/solvers/point_collisions.h"

namespace coif {

using Eigen::Vector3d;

FollowLeaderSolver::FollowLeaderSolver(const Rig& rig, const SolverScene& scene)
    : PosedSolver(rig, scene), given_back_(rig.bones.size()), corrections_(rig.bones.size()) {
  // The paper's s_damping: 1 gives back all that was taken and is not stable, 0 is plain follow-the-leader.
  constexpr double kGivenBack = 0.9;
  std::vector<int> children(bone_count());
  for (std::size_t i = 0; i < bone_count(); ++i) {
    if (!hangs_from_head(i)) ++children[parent(i)];
  }
  for (std::size_t i = 0; i < bone_count(); ++i) {
    if (!hangs_from_head(i)) given_back_[i] = kGivenBack / children[parent(i)];
  }
}

void FollowLeaderSolver::advance(const ParticleStep& step) {
  before_ = positions_;
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] += falling_velocity(i, step) * step.dt;
  renew_default_pose(step);
  for (std::size_t i = 0; i < bone_count(); ++i) follow(i, step);
  renew_velocities(step);
}

void FollowLeaderSolver::follow(std::size_t i, const ParticleStep& step) {
  const Vector3d leader = start(i, step);
  // How the leader really moved: its velocity also holds what it was given back, which at rest is not zero.
  const Vector3d leader_velocity =
      hangs_from_head(i) ? step.head_velocity_at(leader) : Vector3d((leader - before_[parent(i)]) / step.dt);
  const Vector3d foreseen =
      positions_[i] + pull(i, positions_[i] - before_[i], leader_velocity + swing_velocity(i), step);
  positions_[i] = clear_of_colliders_at_length(rig(), i, step.head_rotation, leader, foreseen);
  corrections_[i] = positions_[i] - foreseen;
}

void FollowLeaderSolver::renew_velocities(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) velocities_[i] = (positions_[i] - before_[i]) / step.dt;
  for (std::size_t i = 0; i < bone_count(); ++i) {
    if (!hangs_from_head(i)) velocities_[parent(i)] -= corrections_[i] * (given_back_[i] / step.dt);
  }
}

}  // namespace coif
