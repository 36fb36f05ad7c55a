#pragma once
// The continuous model that `coif` solves and reports measure against (runtime/docs/MODEL.md), as equations of motion.

#include "motion/head_path.h"
#include "report/chain_solver.h"
#include "report/rig.h"

#include <span>

namespace coif {

/// What the model remembers of a bone. World axes.
struct BoneState {
  Eigen::Quaterniond frame;  ///< Rotation from rest; the bone points along frame * rest_direction.
  Eigen::Vector3d turning;   ///< Rate of that direction, 1/s; perpendicular to it.
};

/// How BoneState changes.
struct BoneRates {
  Eigen::Vector4d frame;  ///< Of the quaternion's coefficients (x, y, z, w), 1/s.
  Eigen::Vector3d turning;
};

/// What a bone, or the head where one begins, is to the bones that hang from it. Metres from the head, world axes.
struct BoneMotion {
  Eigen::Vector3d end;
  Eigen::Vector3d velocity;      ///< World, m/s.
  Eigen::Vector3d acceleration;  ///< World, m/s^2.
  Eigen::Vector3d angular_velocity;
  Eigen::Quaterniond frame;
};

/// Where a bone is pulled to. World axes.
struct BoneTarget {
  Eigen::Vector3d
      direction;  ///< From the bone's start in lengths; unit where it turns with the parent or the head alone.
  Eigen::Vector3d turning;  ///< Its rate, 1/s.
};

/// Of a joint that moves rigidly with the head.
[[nodiscard]] BoneMotion motion_of_joint(const Eigen::Vector3d& joint, const HeadState& head);

[[nodiscard]] BoneTarget target_of(const RigBone& bone, const BoneMotion& parent, const HeadState& head);

/// Angular velocity of a bone with this state: as its direction turns, and about it as the parent does, less the rate at
/// which a twist between them goes back. Without twist (kShortestArc) as the shortest arc from the parent's frame turns.
[[nodiscard]] Eigen::Vector3d angular_velocity_of(const RigBone& bone, const BoneMotion& parent,
                                                  const BoneState& state);

/// Does a bone with this rate of torsion keep the shortest arc from its parent's frame at all times?
[[nodiscard]] inline bool never_twists(const RigBone& bone) { return bone.torsion >= double(kShortestArc); }

/// The frame of a bone that never twists and points along the unit vector `direction` (world).
[[nodiscard]] Eigen::Quaterniond frame_of_arc(const RigBone& bone, const Eigen::Quaterniond& parent_frame,
                                              const Eigen::Vector3d& direction);

/// Equations of motion of bones whose parents come first, without contacts. `motions` is scratch; all spans are as long
/// as `bones`.
void free_rates(std::span<const RigBone> bones, const SolverScene& scene, const HeadState& head,
                std::span<const BoneState> states, std::span<BoneMotion> motions, std::span<BoneRates> rates);

/// Turns the unit vector `from` to the unit vector `to`; about some axis where they are opposite.
[[nodiscard]] Eigen::Quaterniond shortest_arc(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace coif
