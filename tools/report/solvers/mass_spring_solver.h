#pragma once

#include "report/solvers/posed_solver.h"

namespace coif {

/// Point masses on springs, integrated explicitly: thesis 3.1 and 5.2 "Initial attempt", after Rosenblum, Carlson and
/// Tripp, "Simulating the Structure and Dynamics of Human Hair", 1991. Forces change velocities, the new velocities
/// change positions (symplectic Euler). Springs hold the segments (segment_springs()), the model's stiffness and damping
/// hold the pose. Unstable where dt exceeds about two over the root of the stiffest chain's spring sum: that is its
/// place in history.
class MassSpringSolver final : public PosedSolver {
 public:
  MassSpringSolver(const Rig& rig, const SolverScene& scene);

 private:
  void advance(const ParticleStep& step) override;
  void add_pose_forces(const ParticleStep& step);
  void add_springs(const ParticleStep& step);

  std::vector<double> springs_;
  std::vector<Eigen::Vector3d> forces_;  ///< Per unit of mass, m/s^2.
};

}  // namespace coif
