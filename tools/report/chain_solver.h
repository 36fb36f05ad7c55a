#pragma once

#include <coif/math.h>

#include <Eigen/Core>

#include <memory>
#include <span>

namespace coif {

/// What acts on the hair besides the head. Defaults are the runtime's (coif/hair.h).
struct SolverScene {
  Eigen::Vector3d gravity{0, -9.81, 0};            ///< World, m/s^2.
  Eigen::Vector3d wind = Eigen::Vector3d::Zero();  ///< World, m/s.
  double air_follow = 1;                           ///< Share of the head's velocity that the air takes on.
};

/// A way to move the bones of one head: the runtime's solvers, the reference, and what others do, behind one interface
/// so that the same measurement runs over all of them.
class ChainSolver {
 public:
  ChainSolver() = default;
  ChainSolver(const ChainSolver&) = delete;
  ChainSolver& operator=(const ChainSolver&) = delete;
  virtual ~ChainSolver() = default;

  /// The rest pose under this head, at rest.
  virtual void reset(const HeadPose& head) = 0;

  /// Moves the head to `head` within `dt` seconds. False where the solver refuses the input and keeps its state.
  [[nodiscard]] virtual bool step(const HeadPose& head, double dt) = 0;

  /// Tails of the simulated bones, head space, metres; the order of Rig::bones. May hold NaN after a step that exploded.
  [[nodiscard]] virtual std::span<const Eigen::Vector3d> bone_ends() const = 0;
};

}  // namespace coif
