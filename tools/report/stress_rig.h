#pragma once

#include "report/opened_asset.h"

#include <cstdint>
#include <vector>

namespace coif {

/// Chains that exist in no model, made to be simulated under stress. They start behind a head sphere, and hang.
struct StressRig {
  std::uint32_t chains = 2;     ///< Side by side, with `chain_spacing` between them.
  double chain_spacing = 0.04;  ///< Metres; 0: all in the same place.
  std::uint32_t bones_per_chain = 8;
  std::uint32_t branching = 1;  ///< Children of each bone; 1: none branches.
  double bone_length = 0.04;    ///< Metres.
  double length_ratio = 1;      ///< Every second bone is longer by this factor.
  double root_resistance = 0.3, tip_resistance = 0.08;
  double friction = 1;  ///< 1/s
  double gravity_scale = 1;
  double torsion = 20;        ///< 1/s; kShortestArc: never a twist.
  double head_radius = 0.1;   ///< Metres; the surface stays where it is behind the head's joint.
  double root_offset = 0.01;  ///< Metres from the surface to the chains' roots; negative: inside the head.
};

/// An asset in memory.
class StressAsset {
 public:
  /// Simulates as cooked hair does: stiffness from the resistance, damped to critical or more.
  explicit StressAsset(const StressRig& rig);

  /// False where the format does not allow such a rig.
  [[nodiscard]] bool is_open() const { return asset().is_open(); }
  [[nodiscard]] const Asset& asset() const { return opened_.asset(); }

 private:
  OpenedAsset opened_;
};

}  // namespace coif
