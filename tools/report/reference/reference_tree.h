#pragma once

#include "report/reference/hair_segment.h"
#include "report/reference/reference_model.h"

#include <cstdint>
#include <vector>

namespace coif {

/// What the head does during one step of the reference, which lies within one smooth piece of its path.
struct HeadStep {
  double dt = 0;
  HeadState start, middle, end;
};

/// The bones that hang from one joint of the head, moved by the classical Runge-Kutta method in double precision: fourth
/// order where nothing touches, first order through contacts. Trees do not act on each other. Steps allocate nothing.
class ReferenceTree {
 public:
  /// `members`: bones of the rig, a root and all that hangs from it, parents first.
  ReferenceTree(const Rig& rig, std::vector<std::uint32_t> members, const SolverScene& scene);

  /// The rest pose, moving rigidly with the head.
  void reset(const HeadState& head);

  /// Free movement; then, from root to tip, whatever left its angle limit or entered a collider is turned back the
  /// shortest way and loses the velocity that led there. A bone whose parent was held keeps its own tail's velocity.
  void step(const HeadStep& step);

  /// The head is somewhere else: the hair is carried along rigidly, and its velocities turn with it.
  void jump(const Eigen::Quaterniond& turn);

  /// Tails of members(), head space, metres. `ends` has one entry each.
  void bone_ends(const Eigen::Quaterniond& head_rotation, std::span<Eigen::Vector3d> ends) const;

  [[nodiscard]] std::span<const std::uint32_t> members() const { return members_; }

  /// Of any bone's direction, 1/s.
  [[nodiscard]] double fastest_turning() const;

  /// Steps per second below which the integrator cannot follow the stiffest bone.
  [[nodiscard]] double least_steps_per_second() const;

 private:
  void integrate(const HeadStep& step);
  void untwist_all(const Eigen::Quaterniond& head_rotation);
  void hold(const HeadState& head);
  bool hold_limit(const RigBone& bone, const BoneMotion& parent, const HeadState& head, BoneState& state) const;
  bool hold_colliders(const RigBone& bone, const BoneMotion& parent, const HeadState& head, BoneState& state) const;

  std::vector<std::uint32_t> members_;
  std::vector<RigBone> bones_;  ///< Parents are indices into bones_.
  std::vector<SolidShape> solids_;
  SolverScene scene_;
  bool is_free_ = true;  ///< No bone can touch anything or has an angle limit.
  std::vector<BoneState> states_;

  // Scratch of one step.
  std::vector<BoneState> trial_;
  std::vector<BoneMotion> motions_;
  std::vector<BoneMotion> free_motions_;
  std::vector<BoneRates> rates_[4];
  std::vector<Eigen::Vector3d> before_;  ///< Directions at the start of the step.
  std::vector<char> moved_;
};

/// Each root of the rig with all that hangs from it; bones in the rig's order.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> trees_of(const Rig& rig);

}  // namespace coif
