#include "import/source_model.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace coif::importer {
namespace {

constexpr float kWeightSumTolerance = 1e-3f;
constexpr float kUnitLengthTolerance = 1e-3f;

std::string nodes_fault(const SourceModel& model) {
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const SourceNode& node = model.nodes[i];
    if (node.parent != kNoIndex && node.parent >= i) return fmt::format("node {}: parent not earlier", i);
    if (!node.model_from_node.matrix().allFinite()) return fmt::format("node {}: transform not finite", i);
  }
  return {};
}

std::string vertex_arrays_fault(const SourceMesh& mesh) {
  const std::size_t count = mesh.positions.size();
  if (!mesh.normals.empty() && mesh.normals.size() != count) return "normals of another size than positions";
  if (!mesh.uvs.empty() && mesh.uvs.size() != count) return "uvs of another size than positions";
  if (!mesh.colors.empty() && mesh.colors.size() != count) return "colours of another size than positions";
  for (const auto& position : mesh.positions) {
    if (!position.allFinite()) return "position not finite";
  }
  for (const auto& normal : mesh.normals) {
    if (!(std::abs(normal.norm() - 1.0f) < kUnitLengthTolerance)) return "normal not of unit length";
  }
  for (const auto& uv : mesh.uvs) {
    if (!uv.allFinite()) return "uv not finite";
  }
  for (const auto& color : mesh.colors) {
    if (!color.allFinite() || !(color.minCoeff() >= 0)) return "vertex colour not finite or below zero";
  }
  return {};
}

std::string influences_fault(const SourceMesh& mesh, std::size_t node_count) {
  const auto& begin = mesh.influence_begin;
  if (begin.empty()) return mesh.influences.empty() ? "" : "influences without a table";
  if (begin.size() != mesh.positions.size() + 1) return "influence table of another size than positions";
  if (begin.front() != 0 || begin.back() != mesh.influences.size()) return "influence table does not span influences";
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    if (begin[v] > begin[v + 1] || begin[v + 1] > mesh.influences.size()) return "influence table not ascending";
    float sum = 0;
    for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
      const SourceInfluence& influence = mesh.influences[i];
      if (influence.node >= node_count) return "influence of an absent node";
      if (!(influence.weight > 0)) return "influence without weight";
      sum += influence.weight;
    }
    if (!(std::abs(sum - 1.0f) < kWeightSumTolerance)) return "influences do not add up to one";
  }
  return {};
}

std::string mesh_fault(const SourceModel& model, const SourceMesh& mesh) {
  if (mesh.node >= model.nodes.size()) return "absent node";
  if (mesh.posed_node != kNoIndex && mesh.posed_node >= model.nodes.size()) return "absent posed node";
  if (!std::isfinite(mesh.posed_degrees)) return "pose not finite";
  if (mesh.material != kNoIndex && mesh.material >= model.materials.size()) return "absent material";
  if (mesh.triangles.empty() || mesh.triangles.size() % 3 != 0) return "number of indices is not a multiple of three";
  for (const std::uint32_t index : mesh.triangles) {
    if (index >= mesh.positions.size()) return "index out of range";
  }
  if (std::string fault = vertex_arrays_fault(mesh); !fault.empty()) return fault;
  return influences_fault(mesh, model.nodes.size());
}

std::string level_fault(const SourceModel& model, const SourceLevel& level) {
  if (std::string fault = mesh_fault(model, level.mesh); !fault.empty()) return fault;
  const std::size_t vertices = level.mesh.positions.size(), triangles = level.mesh.triangles.size() / 3;
  if (level.along.size() != vertices || level.place.size() != vertices) return "strands of another size than positions";
  for (std::size_t v = 0; v < vertices; ++v) {
    if (!(std::abs(level.along[v].norm() - 1.0f) < kUnitLengthTolerance)) return "strand not of unit length";
    if (!(level.place[v] >= 0 && level.place[v] <= 1)) return "place outside 0..1";
  }
  if (level.strip_of.size() != triangles) return "strips of another size than triangles";
  for (std::size_t t = 0; t < triangles; ++t) {
    const std::uint32_t before = t == 0 ? 0 : level.strip_of[t - 1];
    if (level.strip_of[t] < before || level.strip_of[t] > before + (t == 0 ? 0 : 1)) return "strips not ascending";
  }
  return {};
}

bool is_unit(const Eigen::Vector3d& direction) {
  return std::abs(direction.norm() - 1.0) < double{kUnitLengthTolerance};
}

bool is_length(double value) { return std::isfinite(value) && value >= 0; }

std::string material_fault(const SourceModel& model, const SourceMaterial& material) {
  for (const std::uint32_t image : {material.base_texture.image, material.normal_texture.image,
                                    material.strand_texture.image, material.opacity_texture.image}) {
    if (image != kNoIndex && image >= model.images.size()) return "absent image";
  }
  if (!material.base_color.allFinite()) return "colour not finite";
  if (!(material.alpha_cutoff >= 0 && material.alpha_cutoff <= 1)) return "alpha cutoff outside 0..1";
  if (!(material.roughness >= 0 && material.roughness <= 1)) return "roughness outside 0..1";
  if (!(material.normal_strength >= 0 && material.normal_strength <= kMostNormalStrength))
    return "normal strength outside 0..16";
  return {};
}

std::string collider_fault(const SourceModel& model, const SourceCollider& collider) {
  if (collider.node >= model.nodes.size()) return "absent node";
  if (!collider.center.allFinite() || !collider.tail.allFinite()) return "place not finite";
  if (!is_unit(collider.normal)) return "normal not of unit length";
  if (!is_length(collider.radius)) return "radius is no length";
  return {};
}

std::string limit_fault(const SourceLimit& limit) {
  const bool is_spherical = limit.kind == SourceLimit::Kind::kSpherical;
  const double most[2] = {limit.kind == SourceLimit::Kind::kUnlimited ? 0 : std::numbers::pi,
                          is_spherical ? std::numbers::pi / 2 : 0};
  for (int k = 0; k < 2; ++k) {
    if (!(limit.angles[k] >= 0 && limit.angles[k] <= most[k])) return "limit's angle out of range";
  }
  return std::abs(limit.rotation.norm() - 1) < 1.0e-6 ? "" : "limit's rotation not of unit length";
}

std::string joint_fault(const SourceSpringJoint& joint) {
  if (!is_length(joint.length) || !is_length(joint.hit_radius)) return "joint's size is no length";
  if (!is_length(joint.stiffness) || !std::isfinite(joint.gravity_power)) return "joint's forces not finite";
  if (!(joint.drag >= 0 && joint.drag <= 1)) return "joint's drag outside 0..1";
  if (!is_unit(joint.gravity_direction)) return "gravity direction not of unit length";
  return limit_fault(joint.limit);
}

bool descends_from(const SourceModel& model, std::uint32_t node, std::uint32_t ancestor) {
  // Parents have smaller numbers, so the walk ends as soon as it passes the ancestor.
  while (node != kNoIndex && node > ancestor) node = model.nodes[node].parent;
  return node == ancestor;
}

std::string spring_fault(const SourceModel& model, const SourceSpring& spring, std::vector<bool>& is_joint) {
  if (spring.joints.empty()) return "no joints";
  if (spring.center != kNoIndex && spring.center >= model.nodes.size()) return "absent centre";
  for (std::size_t c = 0; c < spring.colliders.size(); ++c) {
    if (spring.colliders[c] >= model.colliders.size()) return "absent collider";
    if (c > 0 && spring.colliders[c] <= spring.colliders[c - 1]) return "colliders not ascending";
  }
  for (std::size_t j = 0; j < spring.joints.size(); ++j) {
    const std::uint32_t node = spring.joints[j].node;
    if (node >= model.nodes.size()) return "absent node";
    if (is_joint[node]) return "node is a joint twice";
    is_joint[node] = true;
    if (j > 0 && !descends_from(model, node, spring.joints[j - 1].node)) return "joint not below the one before it";
    if (std::string fault = joint_fault(spring.joints[j]); !fault.empty()) return fault;
  }
  return {};
}

std::string springs_fault(const SourceModel& model) {
  if (model.head_node != kNoIndex && model.head_node >= model.nodes.size()) return "absent head node";
  if (model.springs.size() > kMaxSourceSprings) return "too many springs";
  if (model.colliders.size() > kMaxSourceColliders) return "too many colliders";
  for (std::size_t c = 0; c < model.colliders.size(); ++c) {
    const std::string fault = collider_fault(model, model.colliders[c]);
    if (!fault.empty()) return fmt::format("collider {}: {}", c, fault);
  }
  std::vector<bool> is_joint(model.nodes.size(), false);
  for (const SourceSpring& spring : model.springs) {
    const std::string fault = spring_fault(model, spring, is_joint);
    if (!fault.empty()) return fmt::format("spring '{}': {}", spring.name, fault);
  }
  return {};
}

}  // namespace

std::string find_model_fault(const SourceModel& model) {
  if (std::string fault = nodes_fault(model); !fault.empty()) return fault;
  if (model.meshes.empty()) return "no mesh";
  for (const SourceMesh& mesh : model.meshes) {
    const std::string fault = mesh_fault(model, mesh);
    if (!fault.empty()) return fmt::format("mesh '{}': {}", mesh.name, fault);
  }
  for (std::size_t k = 0; k < model.coarser.size(); ++k) {
    const std::string fault = level_fault(model, model.coarser[k]);
    if (!fault.empty()) return fmt::format("level {}: {}", k + 1, fault);
  }
  for (const SourceMaterial& material : model.materials) {
    const std::string fault = material_fault(model, material);
    if (!fault.empty()) return fmt::format("material '{}': {}", material.name, fault);
  }
  return springs_fault(model);
}

}  // namespace coif::importer
