#pragma once
// What a character adds to its hair: colliders that move, and a body. See HairWorld in coif/hair_world.h, "On a
// character".

#include <coif/asset_records.h>
#include <coif/math.h>

#include <cstdint>

namespace coif {

/// Most colliders that a game may give one head at once; an asset's own come on top.
inline constexpr std::uint32_t kMaxMovingColliders = 16;

/// Something of the game's that hair keeps out of. World space, metres; no length is more than 1e6.
struct MovingCollider {
  ColliderShape shape = ColliderShape::kSphere;
  /// At the end of the coming step: the centre of a sphere, ellipsoid or box, one end of a capsule's segment, a point
  /// on a plane.
  double center[3] = {0, 0, 0};
  Quat rotation{};       ///< World from the collider's own axes. The next members are in these axes.
  Vec3 axis{0, 1, 0};    ///< Capsules: to the segment's other end, metres. Plane: normal, any length > 0.
  float radius = 0;      ///< Sphere and capsules, >= 0. Box: rounds edges and faces outwards by this much.
  float end_radius = 0;  ///< Tapered capsule: at the segment's other end.
  Vec3 half_extents{};   ///< Box, >= 0; ellipsoid: its semi-axes, > 0.
  /// True: `velocity` says how fast the collider moves when it arrives. False: its velocity follows from the collider's
  /// place in the step before. A new collider, one of another shape than its predecessor at the same index, or one that
  /// is further from it than thirty-two times its radius, appears at rest.
  bool is_velocity_known = false;
  /// How `center` moves at the end of the step, m/s and rad/s; used where is_velocity_known is set.
  HeadVelocity velocity{};
};

/// The pose of a bone of the body: world from the bone's own axes. Double precision like HeadPose; its scale is the
/// head's.
struct BodyPose {
  double position[3] = {0, 0, 0};  ///< Metres.
  Quat rotation;
};

}  // namespace coif
