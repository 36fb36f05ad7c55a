#pragma once

// The passive model (runtime/docs/MODEL.md), as equations of motion: bones that hold back what they hang from.

#include "lab/reference_model.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace coif::lab {

/// All that hangs from a bone's start, about that, where bones weigh a kilogram a metre, each at its tail.
struct Carried {
  double inertia = 0;  ///< kg m^2
  double arm = 0;      ///< First moment, kg m: what it swings by as a pendulum, with gravity.
};

/// One for each bone, at rest. Parents come first.
[[nodiscard]] std::vector<Carried> carried_at_rest(std::span<const RigBone> bones);

/// 1/s: what an explicit solution of the passive model has to follow. A joint's spring and damper carry all that hangs
/// from it, and may move its own bone alone: as fast as the fourth difference of a beam lets it.
[[nodiscard]] double fastest_rate(std::span<const RigBone> bones);

/// Forces and motion of bones whose parents come first, one step's scratch included.
class PassiveModel {
 public:
  explicit PassiveModel(std::span<const RigBone> bones);

  /// As free_rates(): of bones that never twist, without contacts. `motions` and `rates` are as long as the bones.
  void rates(const SolverScene& scene, const motion::HeadState& head, std::span<const BoneState> states,
             std::span<BoneMotion> motions, std::span<BoneRates> rates);

  /// The velocities nearest to those of `motions`, by mass, that stretch no bone and lead into no collider; `states`
  /// turn with them.
  void keep_links(const motion::HeadState& head, std::span<const BoneContact> contacts, std::span<BoneMotion> motions,
                  std::span<BoneState> states);

  /// The ways of the particles that lift each contact by its depth and stretch no bone, the shortest by mass.
  void lift(std::span<const BoneContact> contacts, std::span<const double> depths,
            std::span<const Eigen::Vector3d> directions, std::vector<Eigen::Vector3d>& ways);

  /// Kinetic energy, and that of weight and bending, joules; against the head's rotation and gravity of `scene`.
  [[nodiscard]] double energy(const SolverScene& scene, const motion::HeadState& head,
                              std::span<const BoneState> states) const;

 private:
  /// What all below a bone makes of its particle: `mass` times its acceleration is `push`, less the bone's own pull.
  struct Links {
    Eigen::Matrix3d mass;
    Eigen::Vector3d push;
    Eigen::Vector3d by_pull;  ///< mass^-1 direction
    double yields = 0;
    double pull = 0;
  };

  struct Bend {
    Eigen::Vector3d direction, arc;  ///< Unit, world.
    double per_fold = 0;
    Eigen::Vector3d torque, reaction;
  };

  /// What, by mass, changes least of what all particles do so that no bone is stretched, by `opening` each, nor enters
  /// a collider, by `entering` (negative) at each contact.
  [[nodiscard]] Eigen::VectorXd nearest(std::span<const BoneContact> contacts, const Eigen::VectorXd& opening,
                                        std::span<const double> entering) const;
  const Eigen::Matrix3d& turn_above(std::size_t i) const;
  void load(std::size_t i, const motion::HeadState& head, const BoneMotion& parent, const BoneMotion& motion);
  void gather(std::size_t i, double opening);
  Eigen::Vector3d release(std::size_t i, const Eigen::Vector3d& of_start) const;

  std::span<const RigBone> bones_;
  std::vector<Carried> carried_;
  Eigen::Matrix3d head_turn_;           ///< The head's rotation, and the frames of bones: turning by a quaternion takes
  std::vector<Eigen::Matrix3d> turns_;  ///< twice the time.
  std::vector<Bend> bends_;
  std::vector<Links> links_;
  std::vector<Eigen::Vector3d> forces_, torques_;
};

}  // namespace coif::lab
