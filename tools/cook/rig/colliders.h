#pragma once

#include "base/collider_shapes.h"
#include "cook/recipe/findings.h"
#include "cook/rig/skeleton.h"
#include "cook/select/head.h"
#include "write/asset_writer.h"

#include <coif/asset_records.h>

#include <vector>

namespace coif {

/// A body that moves with a rigid bone. Model space, metres; the meaning of each field is ColliderRecord's.
struct HeadCollider : ColliderSize {
  std::uint32_t bone = 0;
  bool keeps_inside = false;
};

/// What hair collides with, and which bones can.
struct Colliders {
  std::vector<HeadCollider> shapes;    ///< At most kMaxColliders.
  std::vector<std::uint32_t> of_bone;  ///< Per bone of the skeleton, bit i: its particle may touch shape i.
  std::vector<double> hit_radius;      ///< Per bone, metres; empty: 0 for all.
};

/// The head as a collider, unless the recipe wants none. A fitted head shrinks until no particle is inside it at rest,
/// since it would push the modelled pose about; a declared one is left alone. Warns of either.
[[nodiscard]] Colliders head_colliders(const FittedHead& head, const Skeleton& skeleton, const Recipe& recipe,
                                       Findings& findings);

/// The shapes that the springs of the skeleton's bones collide with, each bone with its own spring's set and its joint's
/// hit radius; empty sets and no shapes where no spring of the hair collides with anything on the head. The runtime moves
/// the head and nothing else of the body, so shapes that are not on the head bone or below it are left out; the others move
/// with the nearest rigid bone, since a shape that swings with the hair has no counterpart. `head_node` may be kNoIndex:
/// nothing is on it. A shape whose radius is 0 is left out: only its surface could be hit.
[[nodiscard]] Colliders spring_colliders(const SourceModel& source, std::uint32_t head_node, const Skeleton& skeleton,
                                         Findings& findings);

/// Takes out of each bone's set what it cannot touch: a particle is never farther from its chain's first joint than the
/// bones between are long, and stretch of kStretch on top of that.
void drop_colliders_out_of_reach(const Skeleton& skeleton, Colliders& colliders);

/// Says how many bones can collide at all, and warns of those that are inside a shape at rest with their hit radius, with
/// the greatest depth: they will be pushed out of the modelled pose.
void report_rest_penetration(const Skeleton& skeleton, const Colliders& colliders, Findings& findings);

/// Leaves colliders out that are in no bone's set; the sets count afresh.
void leave_out_colliders(Colliders& colliders, Findings& findings);

/// All of the above: the file's own colliders where its springs use any that the head carries, else the head as fitted.
[[nodiscard]] Colliders find_colliders(const SourceModel& source, const HeadBone& head_bone, const FittedHead& head,
                                       const Skeleton& skeleton, const Recipe& recipe, Findings& findings);

/// Writes skeleton, bones, names, chains and colliders of `contents`, in head space, and the hit radius of the dynamics
/// that are there. Rest directions are in the parent's frame, which at rest has the axes of the model.
void pack_skeleton(const Skeleton& skeleton, const Colliders& colliders, AssetContents& contents);

}  // namespace coif
