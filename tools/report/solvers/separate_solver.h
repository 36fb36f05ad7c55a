#pragma once

#include "report/particle_solver.h"

namespace coif {

/// The thesis's third attempt (5.2 "Adjusting positions and velocities separately"): velocities move the particles, then
/// positions are put right directly, and velocities are adjusted to match. The thesis calls it "not always obvious how";
/// here a segment that was put right loses the speed at which its ends part or meet, half from each, and a particle that
/// was put out of the head loses its speed into it. The pose is still the second attempt's constant_pull().
class SeparateSolver final : public ParticleSolver {
 public:
  /// `iterations`: passes over lengths and collisions, the thesis has one.
  SeparateSolver(const Rig& rig, const SolverScene& scene, int iterations);

 private:
  void advance(const ParticleStep& step) override;
  void move(const ParticleStep& step);
  void keep_length(std::size_t i, const ParticleStep& step);

  int iterations_;
};

}  // namespace coif
