#include "import/source_model_check.h"

#include <fmt/format.h>

#include <cmath>

namespace coif {
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
  for (const auto& position : mesh.positions) {
    if (!position.allFinite()) return "position not finite";
  }
  for (const auto& normal : mesh.normals) {
    if (!(std::abs(normal.norm() - 1.0f) < kUnitLengthTolerance)) return "normal not of unit length";
  }
  for (const auto& uv : mesh.uvs) {
    if (!uv.allFinite()) return "uv not finite";
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
  if (mesh.material != kNoIndex && mesh.material >= model.materials.size()) return "absent material";
  if (mesh.triangles.empty() || mesh.triangles.size() % 3 != 0) return "number of indices is not a multiple of three";
  for (const std::uint32_t index : mesh.triangles) {
    if (index >= mesh.positions.size()) return "index out of range";
  }
  if (std::string fault = vertex_arrays_fault(mesh); !fault.empty()) return fault;
  return influences_fault(mesh, model.nodes.size());
}

}  // namespace

std::string find_model_fault(const SourceModel& model) {
  if (std::string fault = nodes_fault(model); !fault.empty()) return fault;
  if (model.meshes.empty()) return "no mesh";
  for (const SourceMesh& mesh : model.meshes) {
    const std::string fault = mesh_fault(model, mesh);
    if (!fault.empty()) return fmt::format("mesh '{}': {}", mesh.name, fault);
  }
  for (const SourceMaterial& material : model.materials) {
    const std::uint32_t image = material.base_texture.image;
    if (image != kNoIndex && image >= model.images.size()) {
      return fmt::format("material '{}': absent image", material.name);
    }
    if (!material.base_color.allFinite()) return fmt::format("material '{}': colour not finite", material.name);
  }
  return {};
}

}  // namespace coif
