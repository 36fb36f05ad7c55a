#pragma once

#include "report/particle_solver.h"

namespace coif {

/// Base of the solvers that pull by stiffness and damping per second, the continuous model that `coif` solves, and not
/// by a weight per step. The pull acts on a bone's particle alone, as the thesis has it (5.2): the parent feels the
/// child through the segment between them, or, in methods without two-way segments, not at all.
class PosedSolver : public ParticleSolver {
 protected:
  using ParticleSolver::ParticleSolver;

  /// Default directions (with parent_share) at where the particles are now, and how fast they turn: the way since the last call.
  void renew_default_pose(const ParticleStep& step);

  [[nodiscard]] const Eigen::Vector3d& default_direction(std::size_t i) const { return directions_[i]; }
  /// Where bone i's particle is at rest behind its parent's present position.
  [[nodiscard]] Eigen::Vector3d default_position(std::size_t i, const ParticleStep& step) const {
    return start(i, step) + directions_[i] * bone(i).length;
  }
  /// m/s, against which the model's damping works.
  [[nodiscard]] Eigen::Vector3d default_velocity(std::size_t i, const ParticleStep& step) const {
    return start_velocity(i, step) + swing_velocity(i);
  }
  /// default_velocity() without the start's own: m/s around it.
  [[nodiscard]] Eigen::Vector3d swing_velocity(std::size_t i) const { return turns_[i] * bone(i).length; }
  [[nodiscard]] Eigen::Vector3d start_velocity(std::size_t i, const ParticleStep& step) const {
    return hangs_from_head(i) ? step.head_velocity_at(start(i, step)) : velocities_[parent(i)];
  }

  /// Metres by which stiffness and damping move particle i, which inertia has just moved by `way` to where it is: both
  /// taken at the end of the step, so that no step is so long that the pull overshoots.
  [[nodiscard]] Eigen::Vector3d pull(std::size_t i, const Eigen::Vector3d& way, const Eigen::Vector3d& default_velocity,
                                     const ParticleStep& step) const;

  void on_reset(const ParticleStep& still) override { directions_ = shared_directions(still); }

 private:
  std::vector<Eigen::Vector3d> directions_;
  std::vector<Eigen::Vector3d> turns_;  ///< 1/s, of the directions.
};

}  // namespace coif
