#pragma once

#include <coif/asset_records.h>
#include <coif/math.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// By how much bounds are larger than exact, so that what rounding says of a grazing bone does not matter.
inline constexpr float kBoundMargin = 1.0001f;

/// The axes of a collider in head space, at right angles.
struct OwnAxes {
  Vec3 x, y, z;
};

/// A collider in head space, metres, with what hair that meets it would otherwise compute again and again.
struct PlacedCollider {
  ColliderShape shape = ColliderShape::kSphere;
  bool keeps_inside = false;
  Vec3 center;
  Vec3 axis;           ///< Capsules: to the segment's other end. Plane: unit normal.
  Vec3 radii;          ///< Box: half extents.
  float rounding = 0;  ///< Box: of its edges, outwards.
  Vec3 way_out;        ///< Unit. Where a particle at the very centre, or on a capsule's segment, leaves.
  OwnAxes axes;        ///< Of an ellipsoid or box; unit.
  OwnAxes unit_axes;   ///< By the semi-axes, 1/m: into the space where the ellipsoid is the unit sphere.
  float size = 0;      ///< The smallest radius: what depths are compared with.

  float taper = 0;  ///< Capsules: how much thinner the other end is; negative: thicker.
  float axis2 = 0;  ///< Capsules: the axis's length squared, and one by it.
  float per_axis2 = 0;
  float slant = 0;  ///< Tapered capsules: by how much of the axis a point's nearest ball is off per metre beside it.

  Vec3 bound_center;  ///< A ball around the whole collider. Plane: a point on it.
  float bound_radius = 0;
  float farthest = 0;  ///< See PlacedColliders::farthest().
};

[[nodiscard]] inline bool is_capsule(ColliderShape shape) {
  return shape == ColliderShape::kCapsule || shape == ColliderShape::kTaperedCapsule;
}

/// A collider's own axes, turned by the unit quaternion `q`.
[[nodiscard]] OwnAxes axes_of(const Quat& q);

/// Fills in what follows from shape, centre, axis, radii and, of an ellipsoid or box, axes.
void complete(PlacedCollider& placed);

/// The colliders of an asset. Small enough for the stack.
class PlacedColliders {
 public:
  PlacedColliders() {}  ///< None.

  /// At most kMaxColliders.
  explicit PlacedColliders(std::span<const ColliderRecord> colliders);

  /// A bit for each of the first so many.
  [[nodiscard]] static std::uint32_t first(std::size_t count) {
    return count >= kMaxColliders ? 0xFFFFFFFFu : (1u << count) - 1u;
  }

  /// Puts a collider at place `i`, below kMaxColliders.
  void place(std::uint32_t i, const ColliderRecord& collider);

  /// `i` of one that has been placed.
  const PlacedCollider& operator[](std::uint32_t i) const { return placed_[i]; }

  /// Metres from the head's position within which each of `set` lies, whatever way the head is turned; infinite for
  /// planes and for what keeps hair inside.
  [[nodiscard]] float farthest(std::uint32_t set) const {
    float most = 0;
    for (std::uint32_t left = set & existing_; left != 0; left &= left - 1) {
      const float own = placed_[std::countr_zero(left)].farthest;
      most = own > most ? own : most;
    }
    return most;
  }

 private:
  /// Not initialised: clearing room for all would cost more than the one collider that most hair has.
  union {
    PlacedCollider placed_[kMaxColliders];
  };
  std::uint32_t existing_ = 0;  ///< A bit for each.
};

}  // namespace coif
