#pragma once

#include "placed_colliders.h"

#include <coif/math.h>

#include <cstdint>

namespace coif {

/// A bone on its way through a step, as its colliders see it: head space, where they stand still.
struct BoneContact {
  Vec3 start;           ///< Metres.
  Vec3 direction;       ///< In and out, unit.
  Vec3 before;          ///< The direction before the step, unit.
  Vec3 velocity;        ///< In and out: of the tail relative to the start, m/s.
  Vec3 start_velocity;  ///< Relative to the head's position.
  Vec3 head_turning;    ///< The head's angular velocity, rad/s.
  float length = 0;
  float hit_radius = 0;
  std::uint32_t colliders = 0;  ///< The set of those that it may touch.
};

/// Several colliders push each other's results about: until all agree, or this often.
inline constexpr int kContactRounds = 4;

/// A bone that turned further than this (its cosine) in one step may have jumped through a collider.
inline constexpr float kFarTurn = 0.9f;

/// A start no deeper in a collider than this, share of its size, is on the surface.
inline constexpr float kContactSkin = 1e-3f;

/// Turns the bone until it is clear of its colliders and takes from its velocity what leads into them (MODEL.md,
/// "Contacts").
void keep_clear(const PlacedColliders& colliders, BoneContact& bone);

}  // namespace coif
