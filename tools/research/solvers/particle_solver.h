#pragma once

#include "lab/rig.h"
#include "lab/runtime_solver.h"

#include <algorithm>
#include <vector>

namespace coif::research {

/// World from head space, unit.
[[nodiscard]] Eigen::Quaterniond rotation_of(const HeadPose& head);
[[nodiscard]] bool is_finite(const HeadPose& head);

/// The movement is too large for the runtime (StepSettings::teleport_distance and teleport_angle).
[[nodiscard]] bool jumps(const HeadPose& from, const HeadPose& to);

/// The values of one step for a solver of particles. Metres from the head's position at the end of the step, world
/// axes.
struct ParticleStep {
  double dt = 0;
  Eigen::Quaterniond head_rotation;    ///< World from head space, at the end of the step.
  Eigen::Quaterniond rotation_before;  ///< At its start.
  Eigen::Vector3d gravity;             ///< m/s^2
  Eigen::Vector3d air_velocity;        ///< m/s
  Eigen::Vector3d head_velocity;       ///< m/s, mean over the step.
  Eigen::Vector3d head_spin;           ///< rad/s, world axes, mean over the step.

  /// Velocity of the point of the head that is now at `point`, m/s.
  [[nodiscard]] Eigen::Vector3d head_velocity_at(const Eigen::Vector3d& point) const {
    return head_velocity + head_spin.cross(point);
  }
};

/// Base of the solvers with a point mass at every bone's tail. They work relative to the head like the runtime, in
/// double precision, so that methods are compared and not number formats.
class ParticleSolver : public lab::ChainSolver {
 public:
  ParticleSolver(const lab::Rig& rig, const lab::SolverScene& scene);

  void reset(const HeadPose& head) final;
  /// Refuses values that are not finite, steps that are not above zero, and a start without reset(). A jump of the head
  /// is detected as in the runtime; then the hair starts again from rest, as these methods have no other way.
  [[nodiscard]] bool step(const HeadPose& head, double dt) final;
  [[nodiscard]] std::span<const Eigen::Vector3d> bone_ends() const final { return ends_; }

 protected:
  /// Advances positions and velocities. When it is called the positions have been moved against the head's way, so they
  /// are where the particles were, seen from where the head now is; velocities are the world's.
  virtual void advance(const ParticleStep& step) = 0;
  /// Called after reset(): positions are the rest pose, velocities zero, and `still` has the head's rotation.
  virtual void on_reset(const ParticleStep& still) { static_cast<void>(still); }

  [[nodiscard]] const lab::Rig& rig() const { return rig_; }
  [[nodiscard]] std::size_t bone_count() const { return rig_.bones.size(); }
  [[nodiscard]] const lab::RigBone& bone(std::size_t i) const { return rig_.bones[i]; }
  [[nodiscard]] bool hangs_from_head(std::size_t i) const { return rig_.bones[i].parent < 0; }
  [[nodiscard]] std::size_t parent(std::size_t i) const { return std::size_t(rig_.bones[i].parent); }
  /// The present start of bone i: its parent's particle, or its joint on the turned head.
  [[nodiscard]] Eigen::Vector3d start(std::size_t i, const ParticleStep& step) const;

  /// velocities_[i] after gravity and friction, which decays exactly; pulls and corrections come later.
  [[nodiscard]] Eigen::Vector3d falling_velocity(std::size_t i, const ParticleStep& step) const;

  /// Default directions, root to tip, as Algorithm 1 (5.2) has them: each bone's rest direction in its parent's present
  /// frame, the frame turned by the shortest arc from there to where the bone points now. Unit, one per bone.
  [[nodiscard]] std::vector<Eigen::Vector3d> default_directions(const ParticleStep& step, bool leaning = false) const;

  /// The target of the pose when only RigBone::parent_share of it turns with the parent and the rest with the head: the
  /// mean of both directions, which is shorter than unit where they differ.
  [[nodiscard]] std::vector<Eigen::Vector3d> shared_directions(const ParticleStep& step) const;

  std::vector<Eigen::Vector3d> positions_;
  std::vector<Eigen::Vector3d> velocities_;

 private:
  void renew_ends();

  lab::Rig rig_;
  lab::SolverScene scene_;
  HeadPose head_;
  std::vector<bool> has_children_;
  bool turns_with_parents_ = false;  ///< Whether any bone has a parent_share.
  std::vector<Eigen::Vector3d> ends_;
};

/// Base of the solvers that pull by stiffness and damping per second, the continuous model that `coif` solves, and not
/// by a weight per step. The pull acts on a bone's particle alone, as the thesis has it (5.2): the parent feels the
/// child through the segment between them, or, in methods without two-way segments, not at all.
class PosedSolver : public ParticleSolver {
 protected:
  using ParticleSolver::ParticleSolver;

  /// Default directions (with parent_share) at where the particles are now, and how fast they turn: the way since the
  /// last call.
  void renew_default_pose(const ParticleStep& step);

  [[nodiscard]] const Eigen::Vector3d& default_direction(std::size_t i) const { return directions_[i]; }
  /// Place of bone i's particle at rest behind its parent's present position.
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

/// Velocity that the thesis's second and third attempts (5.2) add per step to a particle that would end `off` its
/// default position without pull. The thesis uses a constant size but gives no number. Here it is the pull that the
/// final method's resistance gives a bone that is a quarter of its length off, at the authoring rate. It is limited so
/// that the particle ends at the default position; beyond it the hair would swing from side to side for ever. Since it
/// is per step, it grows with the frame rate.
[[nodiscard]] inline Eigen::Vector3d constant_pull(const lab::RigBone& bone, const Eigen::Vector3d& off, double dt) {
  const double speed = bone.resistance * 0.25 * bone.length * bone.authoring_rate;
  return off.normalized() * std::min(speed, off.norm() / dt);
}

/// Share of its length by which a segment's spring gives under the weight that hangs from it: about where an eye begins
/// to see hair stretch.
inline constexpr double kSpringStretch = 0.01;

/// Spring constants of the segments per unit of mass, 1/s^2: each carries its own particle and all behind it in earth's
/// gravity (whatever the scene's gravity) at kSpringStretch. For a chain of n equal bones of length l that is up to
/// 9.81 n / (0.01 l): three bones of 0.1 m oscillate with periods of 0.02 s and less, which explicit integration has to
/// follow.
[[nodiscard]] std::vector<double> segment_springs(const lab::Rig& rig);

/// `position` (metres from the head, world axes) moved to where bone `i` keeps its hit radius from every collider it
/// may touch, one collider after another, the short way. Shapes and limits are the runtime's
/// (runtime/sim/lanes/solids-inl.h), in double precision: on overlapping colliders the last has its way, and an
/// ellipsoid is left along the radius of the space where it is a unit sphere.
[[nodiscard]] Eigen::Vector3d clear_of_colliders(const lab::Rig& rig, std::size_t i,
                                                 const Eigen::Quaterniond& head_rotation,
                                                 const Eigen::Vector3d& position);

/// For methods that keep lengths exactly: a point at the bone's length from `start` and clear of the colliders, as near
/// to `position` as some alternating rounds get. If both are impossible, the length is kept.
[[nodiscard]] Eigen::Vector3d clear_of_colliders_at_length(const lab::Rig& rig, std::size_t i,
                                                           const Eigen::Quaterniond& head_rotation,
                                                           const Eigen::Vector3d& start,
                                                           const Eigen::Vector3d& position);

/// For methods that do not derive velocities from positions: moves a particle to the surface and removes its velocity
/// into it, relative to the moving head. True where something was touched.
bool push_out(const lab::Rig& rig, std::size_t i, const ParticleStep& step, Eigen::Vector3d& position,
              Eigen::Vector3d& velocity);

}  // namespace coif::research
