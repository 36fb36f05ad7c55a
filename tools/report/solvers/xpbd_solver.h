#pragma once

#include "report/solvers/posed_solver.h"

namespace coif {

/// Extended position-based dynamics, one iteration per step, meant for sub-steps: Macklin, Storey, Lu, Terdiman,
/// Chentanez, Jeschke and Mueller, "Small Steps in Physics Simulation", 2019. Segments have compliance 0 and move
/// particle and parent by half each. The pose is a constraint on the particle's way off its default position with
/// compliance 1 / stiffness and the Rayleigh damping of Macklin, Mueller and Chentanez, "XPBD", 2016; multiplied through
/// by the stiffness, so that bones without any need no special case.
class XpbdSolver final : public PosedSolver {
 public:
  using PosedSolver::PosedSolver;

 private:
  void advance(const ParticleStep& step) override;
  void keep_pose(std::size_t i, const ParticleStep& step);
  void keep_length(std::size_t i, const ParticleStep& step);

  std::vector<Eigen::Vector3d> before_;
};

}  // namespace coif
