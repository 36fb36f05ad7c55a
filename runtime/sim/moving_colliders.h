#pragma once
// Colliders that move against the head: the game's own and those that hang on the bones of a body. What hosts told, and
// where that is during a step, in head space and metres of the hair.

#include "lanes/lane_layout.h"
#include "lanes/step_parts.h"
#include "placed_colliders.h"

#include <coif/character.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

struct CrowdState;

/// Of one head: those of its asset that hang on a body, and the game's.
inline constexpr std::uint32_t kMaxPlaces = kMaxBodyColliders + kMaxMovingColliders;
static_assert(kMaxPlaces <= 64, "each has a bit");

/// As told: world. Kept for each head and place that it may have a collider in.
struct ToldCollider {
  MovingCollider now;
  double center_before[3] = {};  ///< At the end of the head's last step.
  Quat rotation_before;
  float extent = 0;         ///< From its center, in its own metres: all of it is within.
  bool has_way = false;     ///< It was there at the end of the last step too.
  bool is_of_body = false;  ///< Its lengths are the hair's, not the world's.
  bool keeps_inside = false;
};

/// One collider of one head during a step.
struct ColliderWay {
  ColliderShape shape = ColliderShape::kSphere;
  bool keeps_inside = false;
  std::uint32_t place = 0;  ///< Among the head's: of the body's colliders the number in the asset comes first.
  Vec3 radii;               ///< Sphere, capsules: at both ends. Box: half extents.
  float rounding = 0;       ///< Box.
  Vec3 center[2];           ///< At the step's start and end. In between it goes straight.
  Vec3 axis[2];             ///< As PlacedCollider::axis.
  OwnAxes axes[2];          ///< Box.
  Vec3 velocity;            ///< At the end, against what is rigid to the head, head axes: of the centre, m/s,
  Vec3 turning;             ///< and rad/s.
  Vec3 bound_center;        ///< A ball around the whole way.
  float bound_radius = 0;
  std::uint32_t looks = 1;  ///< So many moments of the step have to be looked at so that it jumps through nothing.
};

/// Where the colliders of sixteen heads may be during a step, one lane for each head: a ball around the whole way.
struct ColliderBounds {
  Lanes3 center;
  Lanes radius;
};

/// Where it is at the share `s` of the step.
void place_at(const ColliderWay& way, float s, PlacedCollider& placed);

/// Where the colliders of a block's heads go in this step, for those that hair may reach; `put` has a bit for each head
/// that was put somewhere, and its colliders with it.
void begin_colliders(CrowdState& crowd, std::uint32_t block, const HeadStepLanes& step, std::uint16_t put,
                     const StepParts& parts);

}  // namespace coif
