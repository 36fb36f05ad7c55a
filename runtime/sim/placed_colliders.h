#pragma once

#include <coif/asset_records.h>
#include <coif/math.h>

#include <bit>
#include <cstdint>
#include <span>

namespace coif {

/// A collider under the head's present rotation: metres from the head's position, world axes, as particles are.
struct PlacedCollider {
  ColliderShape shape = ColliderShape::kSphere;
  bool keeps_inside = false;
  Vec3 center;
  Vec3 axis;  ///< Capsules: to the segment's other end. Plane: unit normal.
  Vec3 radii;
  Vec3 way_out;       ///< Unit. Where a particle at the very centre, or on a capsule's segment, leaves.
  Quat rotation;      ///< Ellipsoid: world from its own axes.
  Vec3 bound_center;  ///< A ball around the whole collider. Plane: a point on it.
  float bound_radius = 0;
  float farthest = 0;  ///< See PlacedColliders::farthest().
};

/// The ball out of which a capsule is made that is nearest to a point.
struct CapsuleBall {
  Vec3 center;
  float radius;
};

/// Of a plain or tapered capsule, for a point that is not on its segment.
[[nodiscard]] CapsuleBall nearest_ball(const PlacedCollider& capsule, const Vec3& point);

/// The colliders of one instance for one step. Small enough for the stack.
class PlacedColliders {
 public:
  PlacedColliders() {}  ///< None.

  /// At most kMaxColliders.
  PlacedColliders(std::span<const ColliderRecord> colliders, const Quat& head_rotation);

  /// `position` (metres from the head, world axes) moved the shortest way that keeps `hit_radius` metres from each
  /// collider of `set`, one after another: bit i stands for collider i, bits without one are ignored. On overlapping
  /// colliders the last has its way.
  ///
  /// A particle inside an ellipsoid leaves along the radius of the space where the ellipsoid is a unit sphere, and
  /// hit_radius is added to the semi-axes: the distance kept is exact where they end and a little less in between.
  /// A hit_radius beyond the radius of a shape that keeps hair inside leaves its centre or segment.
  [[nodiscard]] Vec3 clear(std::uint32_t set, float hit_radius, const Vec3& position) const;

  /// `i` below the number given.
  const PlacedCollider& operator[](std::uint32_t i) const { return placed_[i]; }

  /// True where each of `set` is a sphere that keeps hair outside.
  [[nodiscard]] bool only_spheres(std::uint32_t set) const { return (set & ~spheres_) == 0; }
  /// The set of them.
  [[nodiscard]] std::uint32_t spheres() const { return spheres_; }

  /// Metres from the head's position within which each of `set` lies, whatever way the head is turned; infinite for planes
  /// and for what keeps hair inside.
  [[nodiscard]] float farthest(std::uint32_t set) const {
    float most = 0;
    for (std::uint32_t left = set & existing_; left != 0; left &= left - 1) {
      const float own = placed_[std::countr_zero(left)].farthest;
      most = own > most ? own : most;
    }
    return most;
  }

  /// Calls `visit(collider)` for each collider of `set`.
  template <typename Visit>
  void for_each(std::uint32_t set, const Visit& visit) const {
    for (std::uint32_t left = set & existing_; left != 0; left &= left - 1) visit(placed_[std::countr_zero(left)]);
  }

 private:
  /// Not initialised: clearing room for all would cost more than the one collider that most hair has.
  union {
    PlacedCollider placed_[kMaxColliders];
  };
  std::uint32_t existing_ = 0;  ///< A bit for each.
  std::uint32_t spheres_ = 0;   ///< A bit for each that is a sphere and keeps hair outside.
};

}  // namespace coif
