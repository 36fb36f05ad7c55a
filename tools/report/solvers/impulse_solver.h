#pragma once

#include "report/particle_solver.h"

namespace coif {

/// The thesis's second attempt (5.2 "Replacing the springs"): nothing moves a particle but its velocity. Errors of
/// length and collision are foreseen at the end of the step and become impulses of error / dt, half for the particle and
/// half for its parent; the pose is a velocity of constant size (constant_pull()) towards the default position.
class ImpulseSolver final : public ParticleSolver {
 public:
  /// `iterations`: passes over lengths and collisions, the thesis has one.
  ImpulseSolver(const Rig& rig, const SolverScene& scene, int iterations);

 private:
  void advance(const ParticleStep& step) override;
  void pull_to_default(const ParticleStep& step);
  void keep_lengths(const ParticleStep& step);
  void keep_clear(const ParticleStep& step);
  /// Where the velocity of now takes particle i by the end of the step.
  [[nodiscard]] Eigen::Vector3d foreseen(std::size_t i, const ParticleStep& step) const {
    return before_[i] + velocities_[i] * step.dt;
  }

  int iterations_;
  std::vector<Eigen::Vector3d> before_;
};

}  // namespace coif
