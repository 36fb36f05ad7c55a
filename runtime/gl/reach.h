#pragma once

#include <coif/asset.h>

namespace coif {

/// A ball that hair never leaves, head space, metres.
struct Reach {
  float center[3];
  float radius;
};

/// Bones do not stretch, so however a chain turns, a vertex stays as near to the chain's root as the bones up to it and
/// its own distance from its bone are long. The ball is around the middle of the mesh at rest.
[[nodiscard]] Reach reach_of(const Asset& asset);

}  // namespace coif
