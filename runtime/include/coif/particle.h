#pragma once

#include <coif/math.h>

namespace coif {

/// The tail of one simulated bone. The position is relative to the head's, so that its precision does not depend on
/// where in the world the head is; the axes are the world's, so that gravity needs no rotation.
struct Particle {
  Vec3 position;  ///< Metres from the head's position, world axes.
  Vec3 velocity;  ///< Metres per second, world (not relative to the head).
};

}  // namespace coif
