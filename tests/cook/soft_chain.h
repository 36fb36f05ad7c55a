#pragma once

#include "sim/test_rig.h"

#include <cmath>

namespace coif {

struct SoftChain {
  int bones = 5;
  float length = 0.4f;      ///< Of the whole chain, metres.
  float stiffness = 600;    ///< At the root, 1/s^2; a quarter of it at the tip.
  float damping_ratio = 0;  ///< Of critical damping against the pose.
};

/// A head with one chain that hangs down behind it, without friction.
[[nodiscard]] inline TestRig rig_of_chain(const SoftChain& chain) {
  TestRig rig;
  std::uint32_t parent = 0;
  for (int i = 0; i < chain.bones; ++i) {
    const float share = chain.bones > 1 ? float(i) / float(chain.bones - 1) : 0;
    const float stiffness = chain.stiffness * (1 - 0.75f * share);
    parent = rig.add({.parent = parent,
                      .joint = {0, 0.02f, -0.12f},
                      .rest_direction = {0, -0.8f, -0.6f},
                      .length = chain.length / float(chain.bones),
                      .stiffness = stiffness,
                      .damping = 2 * chain.damping_ratio * std::sqrt(stiffness + 200),
                      .torsion = 20});
  }
  return rig;
}

}  // namespace coif
