#pragma once

#include "report/solvers/posed_solver.h"

namespace coif {

/// Rigid sticks with two angles each, and one equation of motion for either angle by itself: thesis 3.2, the
/// one-dimensional projective equations of Anjyo, Usami and Kurihara, "A Simple Method for Extracting the Natural Beauty
/// of Hair", 1992. From root to tip, each stick is a pendulum on a start that moves as given, so lengths are exact and
/// children do not pull their parents. The pose is a spring per radian and a damper per angle.
///
/// The angles are measured around a pole across the default direction (zenith 90 degrees, azimuth 0 in the pose), not
/// around the vertical: hair hangs down, where the azimuth of the paper has no meaning. The terms by which the two angles
/// act on each other are left out, as the paper does. Springs and dampers are taken at the end of the step, gravity,
/// drag and the start's motion as they are.
class ProjectiveSolver final : public PosedSolver {
 public:
  using PosedSolver::PosedSolver;

 private:
  void on_reset(const ParticleStep& still) override;
  void advance(const ParticleStep& step) override;
  void swing(std::size_t i, const ParticleStep& step);

  std::vector<Eigen::Vector3d> pointing_;  ///< Unit, world axes, where each stick points.
};

}  // namespace coif
