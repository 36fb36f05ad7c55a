#pragma once

#include "lab/reference_model.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace coif::lab {

/// Holds linked bones together in the reference (runtime/docs/MODEL.md, "Links"): by many small turns until all links
/// have their lengths to rounding. Independent of the runtime's method, which is measured against it.
class ReferenceLinks {
 public:
  /// `links` refer to `bones`, whose depths must not fall.
  ReferenceLinks(std::vector<RigLink> links, std::span<const RigBone> bones);

  /// Turns bones of one depth, from `begin` up to but not including `end`. `start_of(bone)` is the motion of the point
  /// that a bone hangs from. `motions` of these bones are updated, and `turned` marks the bones that were turned.
  template <typename StartOf>
  void hold(std::size_t begin, std::size_t end, const StartOf& start_of, std::span<BoneState> states,
            std::span<BoneMotion> motions, std::span<char> turned) {
    for (std::size_t i = begin; i < end; ++i) starts_[i] = start_of(i);
    hold({begin, end, states, motions, turned});
  }

 private:
  struct Level {
    std::size_t begin = 0, end = 0;
    std::span<BoneState> states;
    std::span<BoneMotion> motions;
    std::span<char> turned;
  };

  void hold(const Level& level) const;
  double shorten(const RigLink& link, const Level& level) const;
  double slow(const RigLink& link, const Level& level) const;
  void turn(std::size_t i, const Eigen::Vector3d& way, const Level& level) const;
  void push(std::size_t i, const Eigen::Vector3d& velocity, const Level& level) const;

  std::vector<RigLink> links_;  ///< By depth.
  std::span<const RigBone> bones_;
  std::vector<double> mobility_;    ///< 1/kg, as carried_at_rest() has masses.
  std::vector<BoneMotion> starts_;  ///< The points that the present bones hang from.
};

}  // namespace coif::lab
