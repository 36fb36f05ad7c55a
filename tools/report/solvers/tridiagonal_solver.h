#pragma once

#include "report/particle_solver.h"

namespace coif {

/// All lengths of a strand at once: Han and Harada, "Tridiagonal Matrix Formulation for Inextensible Hair Strand
/// Simulation", 2013. The length errors' first-order system couples neighbours only and is solved directly, once per
/// iteration (a Newton step). The paper is about lengths; the pose is the weight per step towards the default position
/// that Algorithm 1 calls resistance and Han and Harada's "Real-time Hair Simulation with Efficient Hair Style
/// Preservation", 2012, a shape constraint, so its strength depends on the frame rate as theirs does.
///
/// Newton's method fails where a step stretches hair far: a strand that it leaves more than a tenth off, or not finite,
/// is put behind its leaders from root to tip instead. Where strands fork, the first child goes on and the others
/// hang from a particle that is fixed for them; the paper has no forks.
class TridiagonalSolver final : public ParticleSolver {
 public:
  TridiagonalSolver(const Rig& rig, const SolverScene& scene, int iterations);

 private:
  using Strand = std::vector<std::size_t>;  ///< Bones, root to tip, without forks.

  void advance(const ParticleStep& step) override;
  void pull_to_default(const ParticleStep& step);
  void keep_lengths(const Strand& strand, const ParticleStep& step);
  void newton(const Strand& strand, const ParticleStep& step);
  void follow(const Strand& strand, const ParticleStep& step);
  /// Share of its length by which the worst segment is off; NaN where one is.
  [[nodiscard]] double worst_error(const Strand& strand, const ParticleStep& step) const;

  int iterations_;
  std::vector<Strand> strands_;
  std::vector<Eigen::Vector3d> before_;
  std::vector<Eigen::Vector3d> pulled_;  ///< Before lengths are kept.
  // One row per segment of a strand.
  std::vector<Eigen::Vector3d> directions_;
  std::vector<double> diagonal_, coupling_, push_;
};

}  // namespace coif
