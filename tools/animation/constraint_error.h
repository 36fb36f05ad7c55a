#pragma once
// How far a simulated pose breaks the two constraints that the solver should keep.

#include <coif/asset.h>
#include <coif/math.h>

#include <span>

namespace coif {

/// Worst |length / rest length - 1| over the simulated bones; 0 for an asset without any.
/// `bone_ends`: one per bone, head space, metres, as Hair::bone_ends() gives them.
[[nodiscard]] float worst_stretch(const Asset& asset, std::span<const Vec3> bone_ends);

/// Worst depth of a simulated particle inside a collider of its bone's set, as a share of the collider's radius: 0
/// outside, 1 at the centre; where hair is kept inside, how far it is outside. Planes count as if their radius were
/// 0.1 m. Hit radii are a margin and not counted. Exact for spheres and capsules. For an ellipsoid the depth is taken along the line through its centre, in the space
/// where it is a unit sphere; the nearest way out can be shorter, so flat ellipsoids read too deep, never too shallow.
[[nodiscard]] float worst_penetration(const Asset& asset, std::span<const Vec3> bone_ends);

}  // namespace coif
