#pragma once

#include "report/chain_solver.h"
#include "report/rig.h"

namespace coif {

/// One step as a solver of particles sees it. Metres from the head's position at the end of the step, world axes.
struct ParticleStep {
  double dt = 0;
  Eigen::Quaterniond head_rotation;    ///< World from head space, at the end of the step.
  Eigen::Quaterniond rotation_before;  ///< At its start.
  Eigen::Vector3d gravity;             ///< m/s^2
  Eigen::Vector3d air_velocity;        ///< m/s
  Eigen::Vector3d head_velocity;       ///< m/s, mean over the step.
  Eigen::Vector3d head_spin;           ///< rad/s, world axes, mean over the step.

  /// Of the point of the head that is at `point` now, m/s.
  [[nodiscard]] Eigen::Vector3d head_velocity_at(const Eigen::Vector3d& point) const {
    return head_velocity + head_spin.cross(point);
  }
};

/// Base of the solvers that hold a point mass at every bone's tail. They work relative to the head as the runtime does,
/// in double precision, so that what is compared is the method and not its number format.
class ParticleSolver : public ChainSolver {
 public:
  ParticleSolver(const Rig& rig, const SolverScene& scene);

  void reset(const HeadPose& head) final;
  /// Refuses what is not finite, steps that are not above zero, and to begin without reset().
  /// A head that jumps is taken as the runtime takes it; as these methods know no better, the hair starts again from rest.
  [[nodiscard]] bool step(const HeadPose& head, double dt) final;
  [[nodiscard]] std::span<const Eigen::Vector3d> bone_ends() const final { return ends_; }

 protected:
  /// Advances positions and velocities. When it is called the positions have been moved against the head's way, so they
  /// are where the particles were, seen from where the head now is; velocities are the world's.
  virtual void advance(const ParticleStep& step) = 0;
  /// Called after reset(): positions are the rest pose, velocities zero, and `still` says how the head is turned.
  virtual void on_reset(const ParticleStep& still) { static_cast<void>(still); }

  [[nodiscard]] const Rig& rig() const { return rig_; }
  [[nodiscard]] std::size_t bone_count() const { return rig_.bones.size(); }
  [[nodiscard]] const RigBone& bone(std::size_t i) const { return rig_.bones[i]; }
  [[nodiscard]] bool hangs_from_head(std::size_t i) const { return rig_.bones[i].parent < 0; }
  [[nodiscard]] std::size_t parent(std::size_t i) const { return std::size_t(rig_.bones[i].parent); }
  /// Where bone i starts now: its parent's particle, or its joint on the turned head.
  [[nodiscard]] Eigen::Vector3d start(std::size_t i, const ParticleStep& step) const;

  /// Where velocities_[i] is after gravity and friction, which decays exactly: what follows pulls and corrects.
  [[nodiscard]] Eigen::Vector3d falling_velocity(std::size_t i, const ParticleStep& step) const;

  /// Default directions, root to tip, as Algorithm 1 (5.2) has them: each bone's rest direction in its parent's present
  /// frame, the frame turned by the shortest arc from there to where the bone points now. Unit, one per bone.
  [[nodiscard]] std::vector<Eigen::Vector3d> default_directions(const ParticleStep& step) const;

  /// Where the pose pulls to when only RigBone::parent_share of it turns with the parent and the rest with the head: the
  /// mean of both directions, which is shorter than unit where they disagree.
  [[nodiscard]] std::vector<Eigen::Vector3d> shared_directions(const ParticleStep& step) const;

  std::vector<Eigen::Vector3d> positions_;
  std::vector<Eigen::Vector3d> velocities_;

 private:
  void renew_ends();

  Rig rig_;
  SolverScene scene_;
  HeadPose head_;
  std::vector<bool> has_children_;
  bool turns_with_parents_ = false;  ///< Whether any bone has a parent_share.
  std::vector<Eigen::Vector3d> ends_;
};

}  // namespace coif
