#include "import/vrm_springs.h"

#include "gltf/document.h"

#include <fmt/format.h>

namespace coif::importer {
namespace {

using nlohmann::json;

constexpr double kLeafTail = 0.07;  // metres

std::optional<Eigen::Vector3d> from_unity(const json& value) {
  auto vector = gltf::vector_of(value);
  if (vector) vector->z() = -vector->z();
  return vector;
}

ColliderSet read_group(const json& group, std::size_t number, SpringSink& sink) {
  ColliderSet set;
  const auto node = sink.find_node(member(group, "node"));
  const json& list = list_of(member(group, "colliders"));
  if (!node) {
    if (!list.empty()) sink.ignore(fmt::format("collider group {}: its node is not in the scene; ignored", number));
    return set;
  }
  for (const json& item : list) {
    SourceCollider collider;
    collider.node = *node;
    collider.center = from_unity(member(item, "offset")).value_or(Eigen::Vector3d::Zero());
    collider.radius = number_of(member(item, "radius")).value_or(0);
    if (const auto index = sink.add_collider(collider)) set.set(*index);
  }
  return set;
}

/// The settings that all chains of one bone group share.
struct BoneGroup {
  SourceSpringJoint settings;
  std::uint32_t center = kNoIndex;
  ColliderSet colliders;
};

// The first-child path from `start`; the other children are added to `starts`.
SourceSpring follow_first_children(std::uint32_t start, const BoneGroup& group, SpringSink& sink,
                                   std::vector<std::uint32_t>& starts) {
  SourceSpring spring;
  spring.name = sink.model().nodes[start].name;
  spring.center = group.center;
  for (std::uint32_t node = start; node != kNoIndex && sink.claim_joint(node);) {
    SourceSpringJoint joint = group.settings;
    joint.node = node;
    joint.length = sink.metres(kLeafTail);
    const std::vector<std::uint32_t>& children = sink.children(node);
    node = children.empty() ? kNoIndex : children.front();
    if (!children.empty()) {
      joint.length = sink.distance(joint.node, node);
      starts.insert(starts.end(), children.begin() + 1, children.end());
    }
    spring.joints.push_back(joint);
  }
  return spring;
}

void read_root(std::uint32_t root, const BoneGroup& group, SpringSink& sink) {
  if (sink.is_joint(root)) {
    sink.ignore(fmt::format("spring '{}' is listed twice; the first counts", sink.model().nodes[root].name));
    return;
  }
  std::vector<std::uint32_t> starts{root};
  while (!starts.empty()) {
    if (sink.full()) return sink.ignore("springs beyond the most that are read are ignored");
    const std::uint32_t start = starts.back();
    starts.pop_back();
    SourceSpring spring = follow_first_children(start, group, sink, starts);
    if (!spring.joints.empty()) sink.add_spring(std::move(spring), group.colliders);
  }
}

void read_bone_group(const json& value, std::size_t number, const std::vector<ColliderSet>& groups, SpringSink& sink) {
  BoneGroup group;
  // The one name is spelt so in the specification.
  group.settings = read_settings(value, "stiffiness", 0.4, from_unity(member(value, "gravityDir")));
  group.center = sink.find_node(member(value, "center")).value_or(kNoIndex);  // -1 where there is none
  for (const json& reference : list_of(member(value, "colliderGroups"))) {
    if (const auto index = index_of(reference, groups.size())) {
      group.colliders |= groups[*index];
    } else {
      sink.ignore(fmt::format("bone group {}: a collider group is absent; ignored", number));
    }
  }
  for (const json& bone : list_of(member(value, "bones"))) {
    if (const auto root = sink.find_node(bone)) {
      read_root(*root, group, sink);
    } else {
      sink.ignore(fmt::format("bone group {}: a root bone is not in the scene; ignored", number));
    }
  }
}

}  // namespace

void read_vrm0_springs(const json& secondary_animation, SpringSink& sink) {
  std::vector<ColliderSet> groups;
  for (const json& group : list_of(member(secondary_animation, "colliderGroups"))) {
    groups.push_back(read_group(group, groups.size(), sink));
  }
  std::size_t number = 0;
  for (const json& group : list_of(member(secondary_animation, "boneGroups"))) {
    read_bone_group(group, number++, groups, sink);
  }
}

}  // namespace coif::importer
