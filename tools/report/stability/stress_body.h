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

/// How what hangs from a bone of the body has moved since rest, world, of a head that rests at the origin; `joint`:
/// where the bone starts at rest.
using BodyMotion = std::function<Eigen::Isometry3d(const Eigen::Vector3d& joint, double seconds)>;

/// The body that an asset's hair keeps out of, moved under stress: what a host is to say of it, and where that puts its
/// colliders by formulas of the lab's own.
class StressBody {
 public:
  StressBody(const Asset& asset, const lab::RigSample& sample);

  /// Where it is when the head is at `head`.
  void move(const BodyMotion& motion, double seconds, const HeadPose& head);

  /// Of the asset's body bones.
  [[nodiscard]] std::span<const BodyPose> poses() const { return poses_; }
  /// All colliders of the body, in the asset's order; head space.
  [[nodiscard]] std::span<const lab::PlacedSolid> solids() const { return solids_; }
  /// Of the sample's bones: a bit for each of those that keep the bone outside.
  [[nodiscard]] std::span<const std::uint32_t> sets() const { return sets_; }

 private:
  const Asset& asset_;
  std::vector<BodyPose> poses_;
  std::vector<lab::PlacedSolid> solids_;
  std::vector<std::uint32_t> sets_;
};

}  // namespace coif::report
