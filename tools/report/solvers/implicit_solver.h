#pragma once

#include "report/solvers/posed_solver.h"

#include <Eigen/Dense>

namespace coif {

/// The mass-spring system of MassSpringSolver by backward Euler, linearised once per step: thesis 3.1, after Baraff and
/// Witkin, "Large Steps in Cloth Simulation", 1998. Stable at any step, at the price of one linear system of three
/// equations per particle. Hair is a tree, so elimination from the tips to the roots solves it without fill-in, in time
/// linear in the bones. It is set up where gravity and inertia take the particles by the end of the step, so that a
/// head that moves evenly changes nothing. The pose's pull follows the parent too, which makes the matrix unsymmetric.
class ImplicitSolver final : public PosedSolver {
 public:
  ImplicitSolver(const Rig& rig, const SolverScene& scene);

 private:
  /// Row i of the system: diagonal * change[i] + by_parent * change[parent] = right, and what change[i] does to the row
  /// of its parent.
  struct Block {
    Eigen::Matrix3d diagonal;
    Eigen::Matrix3d by_parent;
    Eigen::Matrix3d on_parent;
    Eigen::Vector3d right;
  };

  void advance(const ParticleStep& step) override;
  void begin_rows(const ParticleStep& step);
  void add_springs(const ParticleStep& step);
  void solve();

  std::vector<double> springs_;
  std::vector<Block> rows_;
  std::vector<Eigen::Vector3d> changes_;  ///< Of velocity, m/s.
};

}  // namespace coif
