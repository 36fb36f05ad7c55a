#pragma once

#include "report/solvers/posed_solver.h"

namespace coif {

/// Dynamic follow-the-leader: Mueller, Kim and Chentanez, "Fast Simulation of Inextensible Hair and Fur", 2012. One pass
/// from root to tip puts each particle at its length behind its parent, which never moves for the child; the velocity
/// that this one-sidedness steals is given back in part, by the correction of the next particle (the mean of them where
/// a strand forks). The paper
/// has no pose: stiffness and damping act as a force taken at the end of the step (PosedSolver::pull()), so that what is
/// measured is the method and not an explicit spring.
class FollowLeaderSolver final : public PosedSolver {
 public:
  FollowLeaderSolver(const Rig& rig, const SolverScene& scene);

 private:
  void advance(const ParticleStep& step) override;
  void follow(std::size_t i, const ParticleStep& step);
  void renew_velocities(const ParticleStep& step);

  std::vector<double> given_back_;  ///< Share of bone i's correction that goes to its parent's velocity.

  std::vector<Eigen::Vector3d> before_;
  std::vector<Eigen::Vector3d> corrections_;  ///< Metres, by which each particle was put behind its leader.
};

}  // namespace coif
