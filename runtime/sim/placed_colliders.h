#pragma once

#include <coif/asset_records.h>
#include <coif/math.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// Factor by which bounds are larger than exact ones, so that rounding does not matter for a bone that grazes them.
inline constexpr float kBoundMargin = 1.0001f;

/// A collider's axes in head space, perpendicular to each other.
struct OwnAxes {
  Vec3 x, y, z;
};

/// A collider in head space, metres, with derived values that hair would otherwise compute again and again.
struct PlacedCollider {
  ColliderShape shape = ColliderShape::kSphere;
  bool keeps_inside = false;
  Vec3 center;
  Vec3 axis;           ///< Capsules: to the segment's other end. Plane: unit normal.
  Vec3 radii;          ///< Box: half extents.
  float rounding = 0;  ///< Box: its edges are rounded outwards by this much.
  Vec3 way_out;  ///< Unit. The direction in which a particle at the very centre, or on a capsule's segment, leaves.
  OwnAxes axes;  ///< Unit axes of an ellipsoid or box.
  /// The axes divided by the semi-axes, 1/m: they map to the space in which the ellipsoid is the unit sphere.
  OwnAxes unit_axes;
  float size = 0;  ///< The smallest radius; depths are relative to it.

  float taper = 0;  ///< Capsules: how much thinner the other end is; negative: thicker.
  float axis2 = 0;  ///< Capsules: the axis's squared length, and one divided by it.
  float per_axis2 = 0;
  /// Tapered capsules: how far along the axis a point's nearest ball moves per metre of distance from the axis.
  float slant = 0;

  Vec3 bound_center;  ///< Centre of a ball around the whole collider. Plane: a point on it.
  float bound_radius = 0;
  float farthest = 0;  ///< See PlacedColliders::farthest().
};

[[nodiscard]] inline bool is_capsule(ColliderShape shape) {
  return shape == ColliderShape::kCapsule || shape == ColliderShape::kTaperedCapsule;
}

/// A collider's own axes, turned by the unit quaternion `q`.
[[nodiscard]] OwnAxes axes_of(const Quat& q);

/// Derives the remaining values from shape, centre, axis, radii and, for an ellipsoid or box, axes.
void complete(PlacedCollider& placed);

/// The colliders of an asset. Small enough for the stack.
class PlacedColliders {
 public:
  PlacedColliders() {}  ///< No colliders.

  /// At most kMaxColliders.
  explicit PlacedColliders(std::span<const ColliderRecord> colliders);

  /// A mask with the first `count` bits set.
  [[nodiscard]] static std::uint32_t first(std::size_t count) {
    return count >= kMaxColliders ? 0xFFFFFFFFu : (1u << count) - 1u;
  }

  /// Puts a collider at place `i`, below kMaxColliders.
  void place(std::uint32_t i, const ColliderRecord& collider);

  /// The collider at place `i`, which must have been placed.
  const PlacedCollider& operator[](std::uint32_t i) const { return placed_[i]; }

  /// Distance from the head's position within which each of `set` lies, however the head is turned, metres; infinite
  /// for planes and for colliders that keep hair inside.
  [[nodiscard]] float farthest(std::uint32_t set) const {
    float most = 0;
    for (std::uint32_t left = set & existing_; left != 0; left &= left - 1) {
      const float own = placed_[std::countr_zero(left)].farthest;
      most = own > most ? own : most;
    }
    return most;
  }

 private:
  /// Not initialised: clearing room for all colliders would cost more than the one collider that most hair has.
  union {
    PlacedCollider placed_[kMaxColliders];
  };
  std::uint32_t existing_ = 0;  ///< A bit for each.
};

}  // namespace coif
