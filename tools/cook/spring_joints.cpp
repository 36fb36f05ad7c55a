#include "cook/spring_joints.h"

namespace coif {
namespace {

/// The bone that is this node and not only carries its vertices; kNone: there is none.
std::uint32_t own_bone(const SourceModel& source, const Skeleton& skeleton, std::uint32_t node) {
  if (node >= skeleton.bone_of_node.size()) return kNone;
  const std::uint32_t bone = skeleton.bone_of_node[node];
  const std::uint32_t parent = source.nodes[node].parent;
  const bool inherited = parent != kNoIndex && skeleton.bone_of_node[parent] == bone;
  return inherited ? kNone : bone;
}

}  // namespace

std::vector<BoneJoint> joints_of_bones(const SourceModel& source, const Skeleton& skeleton) {
  std::vector<BoneJoint> joints(skeleton.bones.size());
  for (const SourceSpring& spring : source.springs) {
    for (const SourceSpringJoint& joint : spring.joints) {
      const std::uint32_t bone = own_bone(source, skeleton, joint.node);
      if (bone == kNone || skeleton.bones[bone].kind != BoneKind::kSimulated || !(joint.length > 0)) continue;
      joints[bone] = {&spring, &joint};
    }
  }
  return joints;
}

}  // namespace coif
