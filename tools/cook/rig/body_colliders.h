#pragma once

#include "base/tool_error.h"
#include "cook/rig/colliders.h"

#include <Eigen/Geometry>

#include <string>
#include <vector>

namespace coif::cook {

struct RigRecipe;

/// A bone of the body at rest, in model space, metres.
struct BodyBone {
  std::string name;  ///< Its name in the file.
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< Model from the bone's own axes.
};

/// Colliders that the head does not carry: HeadCollider::bone is an index into `bones`. Hit radii are those for the
/// head.
struct BodyColliders : Colliders {
  std::vector<BodyBone> bones;
};

/// The recipe's body colliders, and those of the file's springs that are not on the head; each bone may touch its own
/// spring's set. A bone has one hit radius for head and body: its spring's, where `of_head` has the file's colliders.
/// Where `of_head` is fitted, bones have no hit radius; instead the file's body shapes are larger by the smallest hit
/// radius of the bones that may touch them. How far the body moves is not known here, so nothing counts as out of
/// reach. If there are more than kMaxBodyColliders, those nearest to the hair's range are kept, with the body at rest,
/// the recipe's before the file's. Errors (kBadInput): the recipe names bones that do not exist, or bones of the head
/// or the hair.
[[nodiscard]] tl::expected<BodyColliders, ToolError> find_body_colliders(const importer::SourceModel& source,
                                                                         const HeadBone& head_bone,
                                                                         const Skeleton& skeleton,
                                                                         const Colliders& of_head,
                                                                         const RigRecipe& recipe, Findings& findings);

/// Writes body bones, their names, colliders and sets of `contents`, in head space. Does nothing without a collider.
void pack_body(const Skeleton& skeleton, const BodyColliders& body, AssetContents& contents);

}  // namespace coif::cook
