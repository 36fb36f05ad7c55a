#pragma once

#include "cook/left_out.h"
#include "cook/settle_colliders.h"
#include "cook/spring_joints.h"

namespace coif {

struct SpringColliders {
  Colliders colliders;  ///< Empty sets and no shapes where no spring of the hair collides with anything on the head.
  std::vector<LeftOut> left_out;  ///< Shapes that the hair would touch but cannot follow the head, by node.
};

/// The shapes that the springs of the skeleton's bones collide with, each bone with its own spring's set and its joint's
/// hit radius. The runtime moves the head and nothing else of the body, so only shapes on the head bone or below it can
/// be kept; they move with the nearest rigid bone, since a shape that swings with the hair has no counterpart.
/// `head_node` may be kNoIndex: nothing is on it. A shape whose radius is 0 is left out: only its surface could be hit.
[[nodiscard]] SpringColliders spring_colliders(const SourceModel& source, std::uint32_t head_node,
                                               const Skeleton& skeleton);

}  // namespace coif
