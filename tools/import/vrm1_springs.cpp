#include "import/vrm_springs.h"

#include "gltf/document.h"

#include <fmt/format.h>

namespace coif::importer {
namespace {

using nlohmann::json;
using Shape = SourceCollider::Shape;

bool read_shape(const json& shape, SourceCollider& out) {
  constexpr std::pair<const char*, Shape> kShapes[] = {
      {"sphere", Shape::kSphere}, {"capsule", Shape::kCapsule}, {"plane", Shape::kPlane}};
  for (const auto& [name, kind] : kShapes) {
    const json& values = member(shape, name);
    if (!values.is_object()) continue;
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    out.shape = kind;
    out.center = gltf::vector_of(member(values, "offset")).value_or(zero);
    out.tail = kind == Shape::kCapsule ? gltf::vector_of(member(values, "tail")).value_or(zero) : zero;
    out.radius = kind == Shape::kPlane ? 0 : number_of(member(values, "radius")).value_or(0);
    if (kind == Shape::kPlane)
      out.normal = gltf::vector_of(member(values, "normal")).value_or(Eigen::Vector3d::UnitZ());
    out.keeps_inside = member(values, "inside") == json(true);
    return true;
  }
  return false;
}

std::optional<std::uint32_t> read_collider(const json& value, std::size_t number, SpringSink& sink) {
  const auto node = sink.find_node(member(value, "node"));
  if (!node) {
    sink.ignore(fmt::format("collider {}: its node is not in the scene; ignored", number));
    return std::nullopt;
  }
  SourceCollider collider;
  collider.node = *node;
  const json& extended = member(member(value, "extensions"), "VRMC_springBone_extended_collider");
  if (read_shape(member(extended, "shape"), collider) || read_shape(member(value, "shape"), collider)) {
    return sink.add_collider(collider);
  }
  sink.ignore(fmt::format("collider {}: its shape is not known; ignored", number));
  return std::nullopt;
}

using ColliderNumbers = std::vector<std::optional<std::uint32_t>>;

std::vector<ColliderSet> read_groups(const json& list, const ColliderNumbers& colliders, SpringSink& sink) {
  std::vector<ColliderSet> groups;
  for (const json& group : list_of(list)) {
    ColliderSet set;
    for (const json& reference : list_of(member(group, "colliders"))) {
      const auto index = index_of(reference, colliders.size());
      if (!index) sink.ignore(fmt::format("collider group {}: a collider is absent; ignored", groups.size()));
      if (index && colliders[*index]) set.set(*colliders[*index]);
    }
    groups.push_back(set);
  }
  return groups;
}

/// Completes a joint once its tail is known.
void end_joint(SourceSpringJoint& joint, std::uint32_t tail, const SpringSink& sink) {
  joint.length = sink.distance(joint.node, tail);
  if (joint.limit.kind == SourceLimit::Kind::kUnlimited) return;
  joint.limit.rotation = (limit_axes(sink.model(), joint.node, tail) * joint.limit.rotation).normalized();
}

void read_joints(const json& list, SourceSpring& spring, SpringSink& sink) {
  for (const json& value : list_of(list)) {
    const auto node = sink.find_node(member(value, "node"));
    const char* why = nullptr;
    if (!node) {
      why = "is not in the scene";
    } else if (!spring.joints.empty() && !sink.descends_from(*node, spring.joints.back().node)) {
      why = "is not below the joint before it";
    } else if (!sink.claim_joint(*node)) {
      why = "is a joint of two springs";
    }
    if (why != nullptr) {
      const std::string name = node ? sink.model().nodes[*node].name : "?";
      sink.ignore(fmt::format("spring '{}': node '{}' {}; the joint is ignored", spring.name, name, why));
      continue;
    }
    if (!spring.joints.empty()) end_joint(spring.joints.back(), *node, sink);
    spring.joints.push_back(read_settings(value, "stiffness", 0.5, gltf::vector_of(member(value, "gravityDir"))));
    spring.joints.back().node = *node;
    spring.joints.back().limit = read_limit(value, fmt::format("spring '{}'", spring.name), sink);
  }
  if (!spring.joints.empty()) spring.joints.back().limit = {};
}

void read_spring(const json& value, std::size_t number, const std::vector<ColliderSet>& groups, SpringSink& sink) {
  SourceSpring spring;
  spring.name = printable_text_of(member(value, "name"));
  if (spring.name.empty()) spring.name = fmt::format("{}", number);
  const json& center = member(value, "center");
  spring.center = sink.find_node(center).value_or(kNoIndex);
  if (!center.is_null() && spring.center == kNoIndex) {
    sink.ignore(fmt::format("spring '{}': its center is not in the scene; ignored", spring.name));
  }
  ColliderSet colliders;
  for (const json& reference : list_of(member(value, "colliderGroups"))) {
    const auto index = index_of(reference, groups.size());
    if (!index) sink.ignore(fmt::format("spring '{}': a collider group is absent; ignored", spring.name));
    if (index) colliders |= groups[*index];
  }
  read_joints(member(value, "joints"), spring, sink);
  if (spring.joints.size() >= 2) return sink.add_spring(std::move(spring), colliders);
  sink.ignore(fmt::format("spring '{}' is ignored: it takes two joints to swing", spring.name));
}

}  // namespace

void read_vrm1_springs(const json& spring_bone, SpringSink& sink) {
  const std::string version = printable_text_of(member(spring_bone, "specVersion"));
  if (version != "1.0" && version != "1.0-beta") {
    sink.ignore(fmt::format("spring bones of VRMC_springBone '{}' are read as version 1.0", version));
  }
  ColliderNumbers colliders;
  for (const json& value : list_of(member(spring_bone, "colliders"))) {
    colliders.push_back(read_collider(value, colliders.size(), sink));
  }
  const std::vector<ColliderSet> groups = read_groups(member(spring_bone, "colliderGroups"), colliders, sink);
  std::size_t number = 0;
  for (const json& value : list_of(member(spring_bone, "springs"))) {
    if (sink.full()) return sink.ignore("springs beyond the most that are read are ignored");
    read_spring(value, number++, groups, sink);
  }
}

}  // namespace coif::importer
