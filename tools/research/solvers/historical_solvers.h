#pragma once

#include "research/solvers/particle_solver.h"

#include <Eigen/Dense>

#include <memory>
#include <span>
#include <string_view>

namespace coif::research {

/// A way to move hair that a report can measure.
struct ListedSolver {
  std::string_view name;         ///< The name on the command line and in reports.
  std::string_view description;  ///< One line.
  std::string_view source;       ///< Paper, and section of the thesis.
  std::string_view effort_unit;  ///< The unit of `effort`.
  std::span<const int> efforts;  ///< Worth measuring, ascending.
  /// `effort` > 0. The solver has to be reset() before its first step.
  std::unique_ptr<lab::ChainSolver> (*create)(const lab::Rig& rig, const lab::SolverScene& scene, int effort);
  /// Ever finer steps converge to the motion of its own model. A solver with a setting that is a share per step or a
  /// constant pull does not converge.
  bool has_model = false;
};

/// Earlier methods and those of others, in the order of the thesis and then of the years. None of them has torsion or
/// angle limits, and their colliders push particles, not segments. `tridiagonal` uses RigBone::resistance as a weight
/// per step, the thesis's own attempts as a constant pull; all others use the model's stiffness and damping.
[[nodiscard]] std::span<const ListedSolver> historical_solvers();

/// Runs `solver` `count` times per step, each time for an equal share of it. The head moves between poses as in the
/// runtime, on a cubic; where it jumps, `solver` is run once and sees the jump. With a count of 1 (or less) this is
/// `solver` itself.
[[nodiscard]] std::unique_ptr<lab::ChainSolver> in_sub_steps(std::unique_ptr<lab::ChainSolver> solver, int count);

/// Point masses on springs, integrated explicitly: thesis 5.2 "Initial attempt", after Rosenblum, Carlson and
/// Tripp, "Simulating the Structure and Dynamics of Human Hair", 1991. Forces change velocities, the new velocities
/// change positions (symplectic Euler). Springs hold the segments (segment_springs()), the model's stiffness and
/// damping hold the pose. Unstable where dt exceeds about two over the root of the stiffest chain's spring sum: that is
/// its place in history.
class MassSpringSolver : public PosedSolver {
 public:
  MassSpringSolver(const lab::Rig& rig, const lab::SolverScene& scene);

 protected:
  /// Sets all forces to those of the pose. Here they pull on particles alone.
  virtual void add_pose_forces(const ParticleStep& step);

  std::vector<Eigen::Vector3d> forces_;  ///< Per unit of mass, m/s^2.

 private:
  void advance(const ParticleStep& step) final;
  void add_springs(const ParticleStep& step);

  std::vector<double> springs_;
};

/// The same with the thesis's angular springs (3.1, Figure 5), the hinges of Rosenblum et al.: where two segments meet,
/// a spring and a damper per radian turn the lower one to its default direction and the upper one the other way, so
/// that bones feel what hangs from them. A hinge is as strong as the mass that it swings: a bone and everything that
/// hangs from it, stretched out as at rest, swing by its stiffness (1/s^2) and damping (1/s). The passive model reads
/// these numbers in the same way.
class AngularSpringSolver final : public MassSpringSolver {
 public:
  AngularSpringSolver(const lab::Rig& rig, const lab::SolverScene& scene);

 private:
  void add_pose_forces(const ParticleStep& step) override;
  /// Torque of bone i's hinge, per unit of mass, m^2/s^2; perpendicular to the bone.
  [[nodiscard]] Eigen::Vector3d torque(std::size_t i, const ParticleStep& step) const;
  /// A pair of forces at the bone's ends.
  void turn(std::size_t i, const Eigen::Vector3d& torque, const ParticleStep& step);

  std::vector<double> inertia_;  ///< Per unit of mass, m^2: everything that each bone swings, about its start, at rest.
};

/// The thesis's second attempt (5.2 "Replacing the springs"): nothing moves a particle but its velocity. Errors of
/// length and collision are foreseen at the end of the step and become impulses of error / dt, half for the particle
/// and half for its parent; the pose is a velocity of constant size (constant_pull()) towards the default position.
class ImpulseSolver final : public ParticleSolver {
 public:
  /// `iterations`: passes over lengths and collisions, the thesis has one.
  ImpulseSolver(const lab::Rig& rig, const lab::SolverScene& scene, int iterations);

 private:
  void advance(const ParticleStep& step) override;
  void pull_to_default(const ParticleStep& step);
  void keep_lengths(const ParticleStep& step);
  void keep_clear(const ParticleStep& step);
  /// The place to which the present velocity takes particle i by the end of the step.
  [[nodiscard]] Eigen::Vector3d foreseen(std::size_t i, const ParticleStep& step) const {
    return before_[i] + velocities_[i] * step.dt;
  }

  int iterations_;
  std::vector<Eigen::Vector3d> before_;
};

/// The thesis's third attempt (5.2 "Adjusting positions and velocities separately"): velocities move the particles,
/// then positions are corrected directly, and velocities are adjusted to match. The thesis calls that "not always
/// obvious how"; here a segment that was corrected loses the speed at which its ends part or meet, half from each, and
/// a particle that was moved out of the head loses its speed into it. The pose is still the second attempt's
/// constant_pull().
class SeparateSolver final : public ParticleSolver {
 public:
  /// `iterations`: passes over lengths and collisions, the thesis has one.
  SeparateSolver(const lab::Rig& rig, const lab::SolverScene& scene, int iterations);

 private:
  void advance(const ParticleStep& step) override;
  void move(const ParticleStep& step);
  void keep_length(std::size_t i, const ParticleStep& step);

  int iterations_;
};

/// Rigid sticks with two angles each, and one equation of motion for either angle by itself: thesis 3.2, the
/// one-dimensional projective equations of Anjyo, Usami and Kurihara, "A Simple Method for Extracting the Natural
/// Beauty of Hair", 1992. From root to tip, each stick is a pendulum on a start that moves as given, so lengths are
/// exact and children do not pull their parents. The pose is a spring per radian and a damper per angle.
///
/// The angles are measured around a pole across the default direction (zenith 90 degrees, azimuth 0 in the pose), not
/// around the vertical: hair hangs down, where the azimuth of the paper has no meaning. As in the paper, the terms that
/// couple the two angles are left out. Springs and dampers are implicit; gravity, drag and the start's motion are
/// explicit.
class ProjectiveSolver final : public PosedSolver {
 public:
  using PosedSolver::PosedSolver;

 private:
  void on_reset(const ParticleStep& still) override;
  void advance(const ParticleStep& step) override;
  void swing(std::size_t i, const ParticleStep& step);

  std::vector<Eigen::Vector3d> pointing_;  ///< Unit, world axes, where each stick points.
};

/// The mass-spring system of MassSpringSolver by backward Euler, linearised once per step: thesis 3.1, after Baraff and
/// Witkin, "Large Steps in Cloth Simulation", 1998. Stable at any step, at the price of one linear system of three
/// equations per particle. Hair is a tree, so elimination from the tips to the roots solves it without fill-in, in time
/// linear in the bones. It is set up where gravity and inertia take the particles by the end of the step, so that a
/// head that moves evenly changes nothing. The pose's pull follows the parent too, which makes the matrix unsymmetric.
class ImplicitSolver final : public PosedSolver {
 public:
  ImplicitSolver(const lab::Rig& rig, const lab::SolverScene& scene);

 private:
  /// Row i of the system: diagonal * change[i] + by_parent * change[parent] = right, and the effect of change[i] on its
  /// parent's row.
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
  std::vector<Eigen::Vector3d> changes_;  ///< Changes of velocity, m/s.
};

/// Dynamic follow-the-leader: Mueller, Kim and Chentanez, "Fast Simulation of Inextensible Hair and Fur", 2012. One
/// pass from root to tip puts each particle at its length behind its parent, which never moves for the child. This
/// one-sidedness loses velocity, which is given back in part by the correction of the next particle (the mean of them
/// where a strand forks). The paper has no pose: stiffness and damping act as an implicit force (PosedSolver::pull()),
/// so that the method is measured and not an explicit spring.
class FollowLeaderSolver final : public PosedSolver {
 public:
  FollowLeaderSolver(const lab::Rig& rig, const lab::SolverScene& scene);

 private:
  void advance(const ParticleStep& step) override;
  void follow(std::size_t i, const ParticleStep& step);
  void renew_velocities(const ParticleStep& step);

  std::vector<double> given_back_;  ///< Share of bone i's correction that is given to its parent's velocity.

  std::vector<Eigen::Vector3d> before_;
  std::vector<Eigen::Vector3d> corrections_;  ///< Metres, by which each particle was put behind its leader.
};

/// All lengths of a strand at once: Han and Harada, "Tridiagonal Matrix Formulation for Inextensible Hair Strand
/// Simulation", 2013. The first-order system of the length errors couples neighbours only and is solved directly, once
/// per iteration (a Newton step). The paper is about lengths. The pose is the weight per step towards the default
/// position, called resistance in Algorithm 1 and a shape constraint in Han and Harada's "Real-time Hair Simulation
/// with Efficient Hair Style Preservation", 2012; so its strength depends on the frame rate, as theirs does.
///
/// Newton's method fails where a step stretches hair far: a strand that it leaves more than a tenth off, or not finite,
/// is put behind its leaders from root to tip instead. Where strands fork, the first child continues the strand and the
/// others hang from a particle that is fixed for them; the paper has no forks.
class TridiagonalSolver final : public ParticleSolver {
 public:
  TridiagonalSolver(const lab::Rig& rig, const lab::SolverScene& scene, int iterations);

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

/// Extended position-based dynamics, one iteration per step, meant for sub-steps: Macklin, Storey, Lu, Terdiman,
/// Chentanez, Jeschke and Mueller, "Small Steps in Physics Simulation", 2019. Segments have compliance 0 and move
/// particle and parent by half each. The pose is a constraint on the particle's way off its default position with
/// compliance 1 / stiffness and the Rayleigh damping of Macklin, Mueller and Chentanez, "XPBD", 2016; multiplied
/// through by the stiffness, so that bones without any need no special case.
class XpbdSolver final : public PosedSolver {
 public:
  using PosedSolver::PosedSolver;

 private:
  void advance(const ParticleStep& step) override;
  void keep_pose(std::size_t i, const ParticleStep& step);
  void keep_length(std::size_t i, const ParticleStep& step);

  std::vector<Eigen::Vector3d> before_;
};

}  // namespace coif::research
