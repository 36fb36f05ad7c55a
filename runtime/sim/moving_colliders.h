#pragma once
// Colliders that move against the head: the game's own and those on the bones of a body. Keeps what hosts set, and
// finds where it is during a step, in head space and the hair's metres.

#include "lanes/lane_layout.h"
#include "lanes/step_parts.h"
#include "placed_colliders.h"

#include <coif/character.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

struct BlockStep;
struct RowHeads;
struct WorldState;

/// Colliders of one head: its asset's body colliders, and the game's.
inline constexpr std::uint32_t kMaxPlaces = kMaxBodyColliders + kMaxMovingColliders;
static_assert(kMaxPlaces <= 64, "each has a bit");

/// A collider as the host set it, in world space. Kept for each head and collider place.
struct ToldCollider {
  MovingCollider now;
  double center_before[3] = {};  ///< At the end of the head's last step.
  Quat rotation_before;
  float extent = 0;         ///< Radius around its center that contains all of it, in its own metres.
  bool has_way = false;     ///< It was there at the end of the last step too.
  bool is_of_body = false;  ///< Its lengths are in the hair's metres, not the world's.
  bool keeps_inside = false;
};

/// One collider of one head during a step.
struct ColliderWay {
  ColliderShape shape = ColliderShape::kSphere;
  bool keeps_inside = false;
  /// A body collider's number in its asset; kMaxBodyColliders for the game's.
  std::uint32_t place = 0;
  Vec3 radii;          ///< Sphere, capsules: at both ends. Box: half extents.
  float rounding = 0;  ///< Box.
  Vec3 center[2];      ///< At the step's start and end; it moves in a straight line between them.
  Vec3 axis[2];        ///< As PlacedCollider::axis.
  OwnAxes axes[2];     ///< Box.
  /// Velocity of the centre at the step's end relative to the head's rigid motion, head axes, m/s.
  Vec3 velocity;
  Vec3 turning;       ///< The same for its rotation, rad/s.
  Vec3 bound_center;  ///< Centre of a ball around the whole way.
  float bound_radius = 0;
  std::uint32_t looks = 1;  ///< Number of moments of the step to look at, so that it jumps through nothing.
};

/// Where the colliders of sixteen heads may be during a step, one lane per head: a ball around the whole way.
struct ColliderBounds {
  Lanes3 center;
  Lanes radius;
};

/// Places it where it is at the share `s` of the step.
void place_at(const ColliderWay& way, float s, PlacedCollider& placed);

/// Implements CharacterCode::begin, for those colliders that hair may reach.
void begin_colliders(WorldState& world, BlockStep& step);

/// Implements CharacterCode::gather.
void gather_bounds(const WorldState& world, RowHeads& heads);

}  // namespace coif
