#pragma once

#include <coif/asset_records.h>
#include <coif/math.h>
#include <coif/particle.h>

#include <span>

namespace coif {

/// Moves every particle that is inside the collider to its surface: along the radius of a sphere, and along the
/// radius in the space where an ellipsoid is the unit sphere. A particle at the very centre leaves along the
/// collider's own +Y. Velocities are left alone.
void push_out(const ColliderRecord& collider, const Quat& head_rotation, std::span<Particle> particles);

}  // namespace coif
