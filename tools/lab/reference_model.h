#pragma once

// The directions that a LimitRecord allows, in double precision and by angles: independent of the runtime's method,
// which is measured against it.

#include "base/geometry.h"
#include "lab/hair_segment.h"
#include "lab/rig.h"
#include "lab/runtime_solver.h"
#include "motion/head_path.h"

#include <coif/asset_records.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace coif::lab {

/// A bone's direction and where its limit has it. All in the limit's own axes.
struct BoundedDirection {
  Eigen::Vector3d direction;  ///< The nearest that is allowed, unit.
  double beyond = 0;          ///< Radians between the two; 0: allowed.
  /// Unit directions in which the bone may not go further; zero where it may.
  Eigen::Vector3d outwards[2] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  bool is_locked[2] = {};  ///< It may not go back either: the limit's angle is 0.
};

/// `direction` unit.
[[nodiscard]] BoundedDirection bounded(const LimitRecord& limit, const Eigen::Vector3d& direction);

/// The rate `turning` of a direction that a limit stopped, without the part that leads further; in the limit's axes,
/// 1/s.
[[nodiscard]] Eigen::Vector3d stopped(const BoundedDirection& at, Eigen::Vector3d turning);

// The continuous model that `coif` solves and reports measure against (runtime/docs/MODEL.md), as equations of motion.

/// What the model remembers of a bone. World axes.
struct BoneState {
  Eigen::Quaterniond frame;  ///< Rotation from rest; the bone points along frame * rest_direction.
  Eigen::Vector3d turning;   ///< Rate of that direction, 1/s; perpendicular to it.
};

/// The part of a vector that is perpendicular to a unit one.
[[nodiscard]] inline Eigen::Vector3d across(const Eigen::Vector3d& vector, const Eigen::Vector3d& direction) {
  return vector - direction * direction.dot(vector);
}

/// The rates of BoneState.
struct BoneRates {
  Eigen::Vector4d frame;  ///< The quaternion's coefficients (x, y, z, w), 1/s.
  Eigen::Vector3d turning;
};

/// The motion of a bone, or of the head, for the bones that hang from it. Metres from the head, world axes.
struct BoneMotion {
  Eigen::Vector3d end;
  Eigen::Vector3d velocity;      ///< World, m/s.
  Eigen::Vector3d acceleration;  ///< World, m/s^2.
  Eigen::Vector3d angular_velocity;
  Eigen::Quaterniond frame;
};

/// The target of a bone's pull. World axes.
struct BoneTarget {
  /// From the bone's start, in lengths; unit where it turns only with the parent or only with the head.
  Eigen::Vector3d direction;
  Eigen::Vector3d turning;  ///< Its rate, 1/s.
};

/// The joint moves rigidly with the head.
[[nodiscard]] BoneMotion motion_of_joint(const Eigen::Vector3d& joint, const motion::HeadState& head);

[[nodiscard]] BoneTarget target_of(const RigBone& bone, const BoneMotion& parent, const motion::HeadState& head);
/// The target for a direction that is `unbent` in the parent's frame.
[[nodiscard]] BoneTarget target_of(const RigBone& bone, const Eigen::Vector3d& unbent, const BoneMotion& parent,
                                   const motion::HeadState& head);

/// Angular velocity of a bone with this state. It consists of the angular velocity of the bone's direction and, about
/// the direction, the parent's minus the rate at which a twist between them decays. Without twist (kShortestArc) it is
/// the angular velocity of the shortest arc from the parent's frame.
[[nodiscard]] Eigen::Vector3d angular_velocity_of(const RigBone& bone, const BoneMotion& parent,
                                                  const BoneState& state);

/// This direction (world, unit) in the axes of the bone's limit, and the rotation of these: world from axes.
struct BoundedBone {
  Eigen::Quaterniond axes;
  BoundedDirection at;
};
[[nodiscard]] BoundedBone bounded(const RigBone& bone, const Eigen::Quaterniond& parent_frame,
                                  const Eigen::Vector3d& direction);

/// Does a bone with this rate of torsion keep the shortest arc from its parent's frame at all times?
[[nodiscard]] inline bool never_twists(const RigBone& bone) { return bone.torsion >= double(kShortestArc); }

/// The frame of a bone that never twists and points along the unit vector `direction` (world).
[[nodiscard]] Eigen::Quaterniond frame_of_arc(const RigBone& bone, const Eigen::Quaterniond& parent_frame,
                                              const Eigen::Vector3d& direction);

/// Equations of motion of bones, parents first, without contacts. `motions` is scratch; all spans are as long as
/// `bones`.
void free_rates(std::span<const RigBone> bones, const SolverScene& scene, const motion::HeadState& head,
                std::span<const BoneState> states, std::span<BoneMotion> motions, std::span<BoneRates> rates);

/// Turns the unit vector `from` to the unit vector `to`; about some axis where they are opposite.
[[nodiscard]] Eigen::Quaterniond shortest_arc(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// The head's motion during one step of the reference, which lies within one smooth piece of its path.
struct HeadStep {
  double dt = 0;
  motion::HeadState start, middle, end;
};

/// A contact of a bone of the passive model with a collider.
struct BoneContact {
  std::size_t bone = 0;
  double share = 0;         ///< Share of the bone's length from its start to the place of contact.
  Eigen::Vector3d normal;   ///< Unit, world, from the collider to the hair.
  Eigen::Vector3d surface;  ///< Velocity of the collider's surface there, m/s.
};

class PassiveModel;
class ReferenceLinks;

/// The bones that hang from one joint of the head, and those of joints whose bones are linked to them, moved by the
/// classical Runge-Kutta method in double precision: fourth order where nothing touches, first order through contacts
/// and links. Trees do not act on each other. Steps allocate nothing.
class ReferenceTree {
 public:
  /// `members`: bones of the rig, roots and all that hangs from them, parents first; where bones are linked, by depth.
  /// Linked chains are of one model, or the first one's moves all.
  ReferenceTree(const Rig& rig, std::vector<std::uint32_t> members, const SolverScene& scene);
  ReferenceTree(ReferenceTree&&) noexcept;
  ~ReferenceTree();

  /// The rest pose, moving rigidly with the head.
  void reset(const motion::HeadState& head);

  /// First the free movement. Then chains of the passive model leave colliders as a whole, by the shortest way weighted
  /// by mass. Then, from root to tip, bones that left their limits or entered a collider are turned back the shortest
  /// way and lose the velocity that led there; limits about axes of their own come last. Last, the passive model's
  /// velocities become the nearest by mass that stretch nothing and lead into no collider. A bone whose parent was held
  /// keeps its own tail's velocity.
  void step(const HeadStep& step);

  /// The head is somewhere else: the hair is carried along rigidly, and its velocities turn with it.
  void jump(const Eigen::Quaterniond& turn);

  /// Tails of members(), head space, metres. `ends` has one entry each.
  void bone_ends(const Eigen::Quaterniond& head_rotation, std::span<Eigen::Vector3d> ends) const;

  [[nodiscard]] std::span<const std::uint32_t> members() const { return members_; }

  [[nodiscard]] std::span<const BoneState> states() const { return states_; }

  /// Fastest rate of any bone's direction, 1/s.
  [[nodiscard]] double fastest_turning() const;

  /// Steps per second below which the integrator cannot follow the stiffest bone.
  [[nodiscard]] double least_steps_per_second() const;

 private:
  void find_links(const Rig& rig, std::span<const int> place);
  void integrate(const HeadStep& step);
  void find_rates(const motion::HeadState& head, const std::vector<BoneState>& states, std::vector<BoneRates>& rates);
  void untwist_all(const Eigen::Quaterniond& head_rotation);
  void hold(const motion::HeadState& head);
  void lift(const motion::HeadState& head);
  void hold_bone(std::size_t i, const motion::HeadState& head);
  void hold_links(std::size_t begin, std::size_t end, const motion::HeadState& head);
  bool hold_limit(const RigBone& bone, const BoneMotion& parent, const motion::HeadState& head, BoneState& state) const;
  bool hold_bounds(const RigBone& bone, const BoneMotion& parent, BoneState& state) const;
  /// Turns the bone out of its colliders. A bone of the cascade also loses the velocity that leads into them; contacts
  /// of a passive bone are added to contacts_, for keep_links().
  bool hold_colliders(std::size_t i, const BoneMotion& parent, const motion::HeadState& head);

  std::vector<std::uint32_t> members_;
  std::vector<RigBone> bones_;             ///< Parents are indices into bones_.
  std::unique_ptr<PassiveModel> passive_;  ///< Null: a cascade.
  std::unique_ptr<ReferenceLinks> links_;  ///< Null: none.
  std::vector<std::size_t> level_ends_;    ///< Where depths end in bones_, if some are linked.
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
  std::vector<char> turned_;  ///< By links.
  std::vector<BoneContact> contacts_;
  std::vector<Eigen::Vector3d> velocities_;  ///< Velocities of the particles before anything holds them.
};

/// The independent parts: each root of the rig with everything that hangs from it, and the roots that are linked to it.
/// Bones are in the rig's order, or by depth where some are linked.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> trees_of(const Rig& rig);

}  // namespace coif::lab
