#pragma once

#include "lab/placed_solid.h"
#include "lab/rig.h"

#include <coif/asset.h>
#include <coif/character.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace coif::report {

/// The motion since rest of a part of the body, world, for a head that rests at the origin. `joint`: the start of its
/// bone at rest.
using BodyMotion = std::function<Eigen::Isometry3d(const Eigen::Vector3d& joint, double seconds)>;

/// The body that an asset's hair keeps out of, moved under stress: the poses for the host to set, and its colliders by
/// the lab's own formulas.
class StressBody {
 public:
  StressBody(const Asset& asset, const lab::RigSample& sample);

  /// Moves it to its place when the head is at `head`.
  void move(const BodyMotion& motion, double seconds, const HeadPose& head);

  /// Poses of the asset's body bones.
  [[nodiscard]] std::span<const BodyPose> poses() const { return poses_; }
  /// All colliders of the body, in the asset's order; head space.
  [[nodiscard]] std::span<const lab::PlacedSolid> solids() const { return solids_; }
  /// For the sample's bones: a bit for each collider that keeps the bone outside.
  [[nodiscard]] std::span<const std::uint32_t> sets() const { return sets_; }

 private:
  const Asset& asset_;
  std::vector<BodyPose> poses_;
  std::vector<lab::PlacedSolid> solids_;
  std::vector<std::uint32_t> sets_;
};

}  // namespace coif::report
