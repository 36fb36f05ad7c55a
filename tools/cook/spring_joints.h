#pragma once

#include "cook/skeleton.h"
#include "import/source_model.h"

#include <vector>

namespace coif {

/// What swings a bone in a file with spring bones.
struct BoneJoint {
  const SourceSpring* spring = nullptr;  ///< Null: the file has no spring for this bone.
  const SourceSpringJoint* joint = nullptr;

  explicit operator bool() const { return joint != nullptr; }
};

/// One per bone of the skeleton, pointing into `source`. VRM turns a joint's own node so that the node's tail, the next
/// joint, swings; the particle of the bone that the node became is that tail. So a joint's settings, hit radius included,
/// belong to its own node's bone. Rigid bones and fitted chains, which are not the file's nodes, have none; neither has
/// the last joint of a spring, which in VRM 1.0 turns nothing.
[[nodiscard]] std::vector<BoneJoint> joints_of_bones(const SourceModel& source, const Skeleton& skeleton);

}  // namespace coif
