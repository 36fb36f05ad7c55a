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

/// A shape that moves with a rigid bone. Model space, metres; each field means the same as in ColliderRecord.
struct HeadCollider : ColliderSize {
  std::uint32_t bone = 0;
  bool keeps_inside = false;
};

/// The colliders, and which bones may touch them.
struct Colliders {
  std::vector<HeadCollider> shapes;    ///< At most kMaxColliders.
  std::vector<std::uint32_t> of_bone;  ///< Per bone of the skeleton, bit i: its particle may touch shape i.
  std::vector<double> hit_radius;      ///< Per bone, metres; empty: 0 for all.
};

/// The head as a collider, unless the recipe wants none. A fitted head shrinks until no particle is inside it at rest,
/// since it would push the modelled pose about; a declared one is left alone. Warns of either.
[[nodiscard]] Colliders head_colliders(const FittedHead& head, const Skeleton& skeleton, Findings& findings);

/// The shapes on the head that the springs of the skeleton's bones collide with. Each bone has its own spring's set and
/// its joint's hit radius; all is empty where no spring of the hair collides with anything there. Shapes that are not
/// on or below the head bone belong to the body (body_colliders.h). The others move with the nearest rigid bone, since
/// a shape that swings with the hair has no counterpart. `head_node` may be kNoIndex: nothing is on it. A shape with
/// radius 0 is left out: only its surface could be hit.
[[nodiscard]] Colliders spring_colliders(const importer::SourceModel& source, std::uint32_t head_node,
                                         const Skeleton& skeleton, Findings& findings);

/// True where the head carries this collider of the source.
[[nodiscard]] bool is_on_head(const importer::SourceModel& source, std::uint32_t head_node,
                              const importer::SourceCollider& collider);

/// True for a shape that can be hit and stored: a plane, or one with a radius.
[[nodiscard]] bool has_size(const importer::SourceCollider& collider);

/// The source's shape, on bone 0.
[[nodiscard]] HeadCollider shape_of(const importer::SourceCollider& collider);

/// The range of a bone's particle around the start of its chain, metres.
struct BoneReach {
  Eigen::Vector3d root = Eigen::Vector3d::Zero();  ///< Start of the chain's first bone, model space.
  double length = 0;                               ///< Sum of the bones from there on; 0 for rigid bones.
};
[[nodiscard]] std::vector<BoneReach> reach_of_bones(const Skeleton& skeleton);

/// Depth of a particle with this hit radius in the shape, or outside of one that keeps hair in, metres; zero or
/// negative where it may be.
[[nodiscard]] double depth_of(const HeadCollider& shape, const Eigen::Vector3d& particle, double radius);

/// Removes from each bone's set the colliders that it cannot touch: a particle's distance from its chain's first joint
/// is at most the length of the bones between, plus kStretch.
void drop_colliders_out_of_reach(const Skeleton& skeleton, Colliders& colliders);

/// Reports how many bones can collide at all, and warns of those that are inside a shape at rest with their hit radius,
/// with the greatest depth: they will be pushed out of the modelled pose. `what` and `cure` are words for the messages.
void report_rest_penetration(const Skeleton& skeleton, const Colliders& colliders, const char* what, const char* cure,
                             Findings& findings);

/// Leaves colliders out that are in no bone's set; the sets count afresh.
void leave_out_colliders(Colliders& colliders, Findings& findings);

/// All of the above: the file's own colliders if its springs use any on the head, else the fitted head.
[[nodiscard]] Colliders find_colliders(const importer::SourceModel& source, const HeadBone& head_bone,
                                       const FittedHead& head, const Skeleton& skeleton, const RigRecipe& recipe,
                                       Findings& findings);

/// Writes skeleton, bones, names, chains and colliders of `contents`, in head space, and the hit radius of the dynamics
/// that are there. Rest directions are in the parent's frame, which at rest has the axes of the model.
void pack_skeleton(const Skeleton& skeleton, const Colliders& colliders, AssetContents& contents);

}  // namespace coif::cook
