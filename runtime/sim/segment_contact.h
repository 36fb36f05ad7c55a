#pragma once

#include "placed_colliders.h"

#include <coif/math.h>

namespace coif {

/// A bone as a collider meets it: a segment with a thickness. Metres from the head's position, world axes.
struct BoneSegment {
  Vec3 start;
  Vec3 direction;  ///< Unit.
  float length = 0;
  float radius = 0;
};

/// Where a segment touches a collider after it was moved clear of it.
struct SegmentContact {
  bool touches = false;
  Vec3 normal;      ///< Unit, from the collider to the hair.
  float along = 0;  ///< Metres from the segment's start.
};

/// Turns the segment about its start, the shortest way, until no part of it is inside the collider (or outside, where it
/// keeps hair in: there only the end counts). Nothing stretches. A start that is inside itself cannot be helped; then
/// the end comes out if the segment is long enough, and points straight out if not.
///
/// `before` is the direction that the segment had before the step, carried along with the head: where the step turned
/// it so far that it passed through the collider, it stays on the side it came from.
///
/// Spheres and planes are solved in closed form; the others by Newton's method on the angle, to a depth of 1e-6 of the
/// collider's size.
SegmentContact clear_segment(const PlacedCollider& collider, const Vec3& before, BoneSegment& segment);

}  // namespace coif
