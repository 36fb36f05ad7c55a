#pragma once

#include "base/collider_shapes.h"
#include "cook/recipe/findings.h"
#include "cook/rig/skeleton.h"
#include "cook/select/head.h"
#include "write/asset_writer.h"

#include <coif/asset_records.h>

#include <vector>

namespace coif::cook {

struct RigRecipe;

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
[[nodiscard]] Colliders head_colliders(const FittedHead& head, const Skeleton& skeleton, Findings& findings);

/// The shapes on the head that the springs of the skeleton's bones collide with, each bone with its own spring's set
/// and its joint's hit radius; empty sets and no shapes where no spring of the hair collides with anything there.
/// Shapes that are not on the head bone or below it are the body's (body_colliders.h); the others move with the nearest
/// rigid bone, since a shape that swings with the hair has no counterpart. `head_node` may be kNoIndex: nothing is on
/// it. A shape whose radius is 0 is left out: only its surface could be hit.
[[nodiscard]] Colliders spring_colliders(const importer::SourceModel& source, std::uint32_t head_node,
                                         const Skeleton& skeleton, Findings& findings);

/// True where the head carries this collider of the source.
[[nodiscard]] bool is_on_head(const importer::SourceModel& source, std::uint32_t head_node,
                              const importer::SourceCollider& collider);

/// True for what can be hit and stored: a plane, or a shape with a radius.
[[nodiscard]] bool has_size(const importer::SourceCollider& collider);

/// The shape as it is in the source, on bone 0.
[[nodiscard]] HeadCollider shape_of(const importer::SourceCollider& collider);

/// How far from where its chain begins a bone's particle can ever be, metres.
struct BoneReach {
  Eigen::Vector3d root = Eigen::Vector3d::Zero();  ///< Where the chain's first bone starts, model space.
  double length = 0;                               ///< Of all bones from there on; 0 for rigid bones.
};
[[nodiscard]] std::vector<BoneReach> reach_of_bones(const Skeleton& skeleton);

/// How deep a particle with this hit radius is in the shape, or out of one that keeps hair in, metres; negative or zero
/// where it may be.
[[nodiscard]] double depth_of(const HeadCollider& shape, const Eigen::Vector3d& particle, double radius);

/// Takes out of each bone's set what it cannot touch: a particle is never farther from its chain's first joint than the
/// bones between are long, and stretch of kStretch on top of that.
void drop_colliders_out_of_reach(const Skeleton& skeleton, Colliders& colliders);

/// Says how many bones can collide at all, and warns of those that are inside a shape at rest with their hit radius,
/// with the greatest depth: they will be pushed out of the modelled pose. `what` they collide with and the `cure` are
/// for the words.
void report_rest_penetration(const Skeleton& skeleton, const Colliders& colliders, const char* what, const char* cure,
                             Findings& findings);

/// Leaves colliders out that are in no bone's set; the sets count afresh.
void leave_out_colliders(Colliders& colliders, Findings& findings);

/// All of the above: the file's own colliders where its springs use any that the head carries, else the head as fitted.
[[nodiscard]] Colliders find_colliders(const importer::SourceModel& source, const HeadBone& head_bone,
                                       const FittedHead& head, const Skeleton& skeleton, const RigRecipe& recipe,
                                       Findings& findings);

/// Writes skeleton, bones, names, chains and colliders of `contents`, in head space, and the hit radius of the dynamics
/// that are there. Rest directions are in the parent's frame, which at rest has the axes of the model.
void pack_skeleton(const Skeleton& skeleton, const Colliders& colliders, AssetContents& contents);

}  // namespace coif::cook
