#pragma once

#include <coif/asset_records.h>
#include <coif/math.h>
#include <coif/particle.h>

#include <span>

namespace coif {

/// Puts the particles of one instance where they rest under a head of this rotation, without velocity.
void place_at_rest(std::span<const BoneRecord> bones, const Quat& head_rotation, std::span<Particle> particles);

}  // namespace coif
