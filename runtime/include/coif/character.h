#pragma once
// What a character that wears hair brings along besides its head: see Hair in coif/hair.h, "On a character".

#include <coif/asset_records.h>
#include <coif/math.h>

#include <cstdint>

namespace coif {

inline constexpr std::uint32_t kMaxMovingColliders =
    16;  ///< That a game gives one head at once; an asset's own come on top.

/// Something of the game that hair stays out of. World space, metres; no length is more than 1e6.
struct MovingCollider {
  ColliderShape shape = ColliderShape::kSphere;
  /// At the end of the coming step: the centre of a sphere, ellipsoid or box, one end of a capsule's segment, a point
  /// on a plane.
  double center[3] = {0, 0, 0};
  Quat rotation{};       ///< World from the collider's own axes, in which the next ones are.
  Vec3 axis{0, 1, 0};    ///< Capsules: to the segment's other end, metres. Plane: normal, any length > 0.
  float radius = 0;      ///< Sphere and capsules, >= 0; boxes: by how much their edges and faces are rounded outwards.
  float end_radius = 0;  ///< Tapered capsule: at the segment's other end.
  Vec3 half_extents{};   ///< Box, >= 0; ellipsoid: its semi-axes, > 0.
  /// How fast it moves when it arrives. Else that follows from where it was in the step before; one that is new, of
  /// another shape than the one in its place before, or further away from it than thirty-two times its radius appears
  /// at rest.
  bool is_velocity_known = false;
  HeadVelocity velocity{};  ///< How `center` moves, m/s and rad/s; counts where is_velocity_known is set.
};

/// Where a bone of the body is: world from the bone's own axes. Double precision as HeadPose; its scale is the head's.
struct BodyPose {
  double position[3] = {0, 0, 0};  ///< Metres.
  Quat rotation;
};

}  // namespace coif
