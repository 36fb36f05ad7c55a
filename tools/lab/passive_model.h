#pragma once

// The equations of motion of the passive model (runtime/docs/MODEL.md), in which bones pull on their parents.

#include "lab/reference_model.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace coif::lab {

/// Everything that hangs from a bone's start, about that place; bones weigh a kilogram per metre, with the mass at
/// their tails.
struct Carried {
  double inertia = 0;  ///< kg m^2
  double arm = 0;      ///< First moment, kg m: its lever as a pendulum under gravity.
};

/// One for each bone, at rest. Parents come first.
[[nodiscard]] std::vector<Carried> carried_at_rest(std::span<const RigBone> bones);

/// 1/s: the fastest rate that an explicit solution of the passive model has to follow. A joint's spring and damper
/// carry everything that hangs from it, and may move its own bone alone: as fast as the fourth difference of a beam
/// lets it.
[[nodiscard]] double fastest_rate(std::span<const RigBone> bones);

/// Forces and motion of bones, parents first, with the scratch of one step.
class PassiveModel {
 public:
  explicit PassiveModel(std::span<const RigBone> bones);

  /// As free_rates(), for bones that never twist, without contacts. `motions` and `rates` are as long as the bones.
  void rates(const SolverScene& scene, const motion::HeadState& head, std::span<const BoneState> states,
             std::span<BoneMotion> motions, std::span<BoneRates> rates);

  /// The velocities nearest to those of `motions`, weighted by mass, that stretch no bone and lead into no collider;
  /// `states` is updated with them.
  void keep_links(const motion::HeadState& head, std::span<const BoneContact> contacts, std::span<BoneMotion> motions,
                  std::span<BoneState> states);

  /// The ways of the particles that lift each contact by its depth and stretch no bone, the shortest by mass.
  void lift(std::span<const BoneContact> contacts, std::span<const double> depths,
            std::span<const Eigen::Vector3d> directions, std::vector<Eigen::Vector3d>& ways);

  /// Kinetic energy, and that of weight and bending, joules; relative to the head's rotation and the gravity of
  /// `scene`.
  [[nodiscard]] double energy(const SolverScene& scene, const motion::HeadState& head,
                              std::span<const BoneState> states) const;

 private:
  /// The effect of everything below a bone on its particle: `mass` times its acceleration is `push` minus the bone's
  /// own pull.
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

  /// The smallest change, weighted by mass, of all particles' values with which no bone is stretched (`opening` each)
  /// and none enters a collider (`entering`, negative, at each contact).
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
