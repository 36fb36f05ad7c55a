#include "import/vrm_springs.h"

#include "base/geometry.h"
#include "gltf/document.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace coif::importer {
namespace {

using nlohmann::json;

// 0.x lists bones with their names, 1.0 has them as members.
const json& head_entry(const json& extensions) {
  const json& bones1 = member(member(member(extensions, "VRMC_vrm"), "humanoid"), "humanBones");
  if (bones1.is_object()) return member(member(bones1, "head"), "node");
  for (const json& bone : list_of(member(member(member(extensions, "VRM"), "humanoid"), "humanBones"))) {
    if (printable_text_of(member(bone, "bone")) == "head") return member(bone, "node");
  }
  return member(json(), "");
}

void read_head(const json& extensions, SpringSink& sink) {
  const json& entry = head_entry(extensions);
  if (entry.is_null()) return;
  if (const auto node = sink.find_node(entry)) {
    sink.set_head(*node);
  } else {
    sink.ignore("the humanoid's head is not a node of the scene; the head is found by its name");
  }
}

}  // namespace

void read_vrm_extensions(const json& extensions, const std::vector<std::uint32_t>& source_of,
                         const Eigen::Affine3d& model_from_file, SourceModel& model) {
  if (!extensions.is_object()) return;
  // 0.x looks along -Z of the file, 1.0 along +Z.
  if (member(extensions, "VRMC_vrm").is_object()) {
    model.facing = Facing::kForwards;
  } else if (member(extensions, "VRM").is_object()) {
    model.facing = Facing::kBackwards;
  }
  SpringSink sink(source_of, model_from_file, model);
  read_head(extensions, sink);
  const json& springs1 = member(extensions, "VRMC_springBone");
  if (springs1.is_null()) {
    read_vrm0_springs(member(member(extensions, "VRM"), "secondaryAnimation"), sink);
  } else {
    read_vrm1_springs(springs1, sink);
  }
}

namespace {

constexpr std::size_t kSpelledOut = 12;
constexpr double kFarthest = 1.0e6;  // metres; keeps every sum of such numbers finite in float too
constexpr double kStrongest = 1.0e6;

double longest_axis(const Eigen::Affine3d& transform) { return transform.linear().colwise().norm().maxCoeff(); }

bool is_near(const Eigen::Vector3d& point) { return point.cwiseAbs().maxCoeff() < kFarthest; }

}  // namespace

SourceSpringJoint read_settings(const json& value, const char* stiffness, double drag,
                                const std::optional<Eigen::Vector3d>& gravity_direction) {
  SourceSpringJoint joint;
  joint.stiffness = number_of(member(value, stiffness)).value_or(1);
  joint.gravity_power = number_of(member(value, "gravityPower")).value_or(0);
  joint.gravity_direction = gravity_direction.value_or(-Eigen::Vector3d::UnitY());
  joint.drag = number_of(member(value, "dragForce")).value_or(drag);
  joint.hit_radius = number_of(member(value, "hitRadius")).value_or(0);
  return joint;
}

SpringSink::SpringSink(const std::vector<std::uint32_t>& source_of, const Eigen::Affine3d& model_from_file,
                       SourceModel& model)
    : model_(model),
      rotation_(rotation_part(model_from_file)),
      metres_per_unit_(longest_axis(model_from_file)),
      source_of_(source_of),
      children_(model.nodes.size()),
      subtree_end_(model.nodes.size()),
      is_joint_(model.nodes.size(), false) {
  for (auto n = static_cast<std::uint32_t>(model.nodes.size()); n-- > 0;) {
    subtree_end_[n] = std::max(subtree_end_[n], n + 1);
    const std::uint32_t parent = model.nodes[n].parent;
    if (parent != kNoIndex) subtree_end_[parent] = std::max(subtree_end_[parent], subtree_end_[n]);
  }
  for (std::uint32_t n = 0; n < model.nodes.size(); ++n) {
    if (model.nodes[n].parent != kNoIndex) children_[model.nodes[n].parent].push_back(n);
  }
}

SpringSink::~SpringSink() {
  if (ignored_ <= kSpelledOut) return;
  warn(model_.warnings, source_code::kSprings, "spring bones: {} more faults of these kinds", ignored_ - kSpelledOut);
}

std::optional<std::uint32_t> SpringSink::find_node(const nlohmann::json& index) const {
  const auto in_file = index_of(index, source_of_.size());
  if (!in_file || source_of_[*in_file] == kNoIndex) return std::nullopt;
  return source_of_[*in_file];
}

bool SpringSink::descends_from(std::uint32_t node, std::uint32_t ancestor) const {
  return node > ancestor && node < subtree_end_[ancestor];
}

double SpringSink::distance(std::uint32_t a, std::uint32_t b) const {
  const auto place = [this](std::uint32_t n) -> Eigen::Vector3d {
    return model_.nodes[n].model_from_node.translation();
  };
  return (place(b) - place(a)).norm();
}

std::optional<std::uint32_t> SpringSink::add_collider(SourceCollider collider) {
  const SourceNode& node = model_.nodes[collider.node];
  const auto reject = [&](const char* why) {
    ignore(fmt::format("a collider on node '{}' is ignored: {}", node.name, why));
    return std::nullopt;
  };
  if (model_.colliders.size() >= kMaxSourceColliders) return reject("there are too many");
  collider.center = node.model_from_node * collider.center;
  collider.tail = node.model_from_node * collider.tail;
  if (collider.shape != SourceCollider::Shape::kCapsule) collider.tail.setZero();
  collider.radius *= longest_axis(node.model_from_node);
  const Eigen::Vector3d normal = node.model_from_node.linear().inverse().transpose() * collider.normal;
  collider.normal = normal.stableNormalized();
  if (!is_near(collider.center) || !is_near(collider.tail)) return reject("its place is not in the model");
  if (!(collider.radius >= 0 && collider.radius < kFarthest)) return reject("its radius is no length");
  if (!(std::abs(collider.normal.norm() - 1) < 1.0e-6)) return reject("its normal has no direction");
  model_.colliders.push_back(collider);
  return static_cast<std::uint32_t>(model_.colliders.size() - 1);
}

bool SpringSink::claim_joint(std::uint32_t node) {
  if (is_joint_[node]) return false;
  is_joint_[node] = true;
  return true;
}

void SpringSink::repair(SourceSpringJoint& joint, const std::string& spring) {
  const SourceSpringJoint given = joint;
  joint.stiffness = std::clamp(given.stiffness, 0.0, kStrongest);
  joint.gravity_power = std::clamp(given.gravity_power, -kStrongest, kStrongest);
  joint.drag = std::clamp(given.drag, 0.0, 1.0);
  joint.hit_radius = std::clamp(given.hit_radius, 0.0, kFarthest);
  joint.length = std::clamp(given.length, 0.0, kFarthest);
  const double length = given.gravity_direction.stableNorm();
  const bool has_direction = length > 0 && std::isfinite(length);
  if (!has_direction) joint.gravity_direction = -Eigen::Vector3d::UnitY();
  const bool changed = joint.stiffness != given.stiffness || joint.gravity_power != given.gravity_power ||
                       joint.drag != given.drag || joint.hit_radius != given.hit_radius;
  if (changed) ignore(fmt::format("spring '{}': a joint's settings out of range were limited", spring));
  if (!has_direction && joint.gravity_power != 0) {
    ignore(fmt::format("spring '{}': a joint's gravity has no direction; down is taken", spring));
  }
  joint.gravity_direction = rotation_ * joint.gravity_direction.stableNormalized();
  joint.stiffness = metres(joint.stiffness);
  joint.gravity_power = metres(joint.gravity_power);
  joint.hit_radius = metres(joint.hit_radius);
}

void SpringSink::add_spring(SourceSpring spring, const ColliderSet& colliders) {
  for (SourceSpringJoint& joint : spring.joints) repair(joint, spring.name);
  for (std::uint32_t c = 0; c < model_.colliders.size(); ++c) {
    if (colliders[c]) spring.colliders.push_back(c);
  }
  model_.springs.push_back(std::move(spring));
}

void SpringSink::ignore(std::string sentence) {
  if (++ignored_ <= kSpelledOut) warn(model_.warnings, source_code::kSprings, "{}", sentence);
}

}  // namespace coif::importer
