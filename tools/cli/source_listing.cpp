#include "cli/asset_summary.h"

#include "base/json.h"
#include "base/text.h"
#include "cli/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace coif::cli {
namespace {

using nlohmann::ordered_json;

std::string texture_name(const importer::SourceModel& model, const importer::SourceTexture& texture) {
  if (!texture.path.empty()) return texture.path;
  return texture.image < model.images.size() ? fmt::format("embedded {}", model.images[texture.image].name) : "";
}

/// Nodes that a mesh is skinned to.
std::vector<bool> find_bones(const importer::SourceModel& model) {
  std::vector<bool> is_bone(model.nodes.size(), false);
  for (const importer::SourceMesh& mesh : model.meshes) {
    for (const importer::SourceInfluence& influence : mesh.influences) is_bone[influence.node] = true;
  }
  return is_bone;
}

/// Two blanks deeper with each parent.
std::string node_tree(const importer::SourceModel& model) {
  const std::vector<bool> is_bone = find_bones(model);
  std::vector<std::vector<std::size_t>> children(model.nodes.size());
  std::vector<std::pair<std::size_t, std::size_t>> open;  // node, depth; no recursion: files choose the depth
  for (std::size_t i = model.nodes.size(); i-- > 0;) {
    const std::uint32_t parent = model.nodes[i].parent;
    if (parent == importer::kNoIndex) {
      open.emplace_back(i, 1);
    } else {
      children[parent].push_back(i);
    }
  }
  std::string text;
  while (!open.empty()) {
    const auto [node, depth] = open.back();
    open.pop_back();
    text += fmt::format("{:{}}{}{}\n", "", 2 * depth, printable_text(model.nodes[node].name),
                        is_bone[node] ? "  (bone)" : "");
    for (const std::size_t child : children[node]) open.emplace_back(child, depth + 1);
  }
  return text;
}

const char* shape_word(importer::SourceCollider::Shape shape) {
  switch (shape) {
    case importer::SourceCollider::Shape::kSphere: return "sphere";
    case importer::SourceCollider::Shape::kCapsule: return "capsule";
    case importer::SourceCollider::Shape::kPlane: return "plane";
  }
  return "";
}

std::size_t limited_joints(const importer::SourceModel& model) {
  std::size_t count = 0;
  for (const importer::SourceSpring& spring : model.springs) {
    count += std::size_t(std::ranges::count_if(spring.joints, [](const importer::SourceSpringJoint& joint) {
      return joint.limit.kind != importer::SourceLimit::Kind::kUnlimited;
    }));
  }
  return count;
}

/// Empty for a file without spring bones.
std::string springs_text(const importer::SourceModel& model) {
  if (model.springs.empty() && model.colliders.empty()) return {};
  std::string text =
      fmt::format("spring bones\n  {}, {} with a limit\n", counted(model.springs.size(), "spring", "springs"),
                  counted(limited_joints(model), "joint", "joints"));
  for (std::size_t c = 0; c < model.colliders.size(); ++c) {
    const importer::SourceCollider& collider = model.colliders[c];
    text += fmt::format("  collider {} on '{}'  {}{}", c, printable_text(model.nodes[collider.node].name),
                        shape_word(collider.shape), collider.keeps_inside ? ", keeps inside" : "");
    text += collider.shape == importer::SourceCollider::Shape::kPlane
                ? "\n"
                : fmt::format(", radius {:.3g} m\n", collider.radius);
  }
  return text;
}

}  // namespace

std::string list_text(const importer::SourceModel& model) {
  std::string text = fmt::format("{}\nmeshes\n", printable_text(model.path));
  for (const importer::SourceMesh& mesh : model.meshes) {
    text += fmt::format("  {}  {}, material '{}', {}, {}\n", printable_text(mesh.name),
                        counted(mesh.triangles.size() / 3, "triangle", "triangles"),
                        printable_text(importer::material_name(model, mesh)), mesh.uvs.empty() ? "no UV" : "UV",
                        mesh.influences.empty() ? "rigid" : "skinned");
  }
  text += "materials\n";
  for (const importer::SourceMaterial& material : model.materials) {
    const std::string texture = texture_name(model, material.base_texture);
    text += fmt::format("  {}  {}\n", printable_text(material.name),
                        texture.empty() ? "no texture" : printable_text(texture));
  }
  return text + springs_text(model) + "nodes\n" + node_tree(model);
}

std::string list_json(const importer::SourceModel& model) {
  ordered_json meshes = ordered_json::array();
  for (const importer::SourceMesh& mesh : model.meshes) {
    meshes.push_back({{"name", mesh.name},
                      {"triangles", mesh.triangles.size() / 3},
                      {"material", importer::material_name(model, mesh)},
                      {"uv", !mesh.uvs.empty()},
                      {"skinned", !mesh.influences.empty()}});
  }
  ordered_json materials = ordered_json::array();
  for (const importer::SourceMaterial& material : model.materials) {
    materials.push_back({{"name", material.name}, {"texture", texture_name(model, material.base_texture)}});
  }
  ordered_json nodes = ordered_json::array();
  const std::vector<bool> is_bone = find_bones(model);
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const importer::SourceNode& node = model.nodes[i];
    const std::string parent = node.parent == importer::kNoIndex ? "" : model.nodes[node.parent].name;
    nodes.push_back({{"name", node.name}, {"parent", parent}, {"bone", bool(is_bone[i])}});
  }
  ordered_json listing = {{"path", model.path},
                          {"meshes", std::move(meshes)},
                          {"materials", std::move(materials)},
                          {"nodes", std::move(nodes)}};
  for (const importer::SourceCollider& collider : model.colliders) {
    listing["colliders"].push_back({{"node", model.nodes[collider.node].name},
                                    {"shape", shape_word(collider.shape)},
                                    {"keeps_inside", collider.keeps_inside},
                                    {"radius", collider.radius}});
  }
  if (limited_joints(model) > 0) listing["limited_joints"] = limited_joints(model);
  return json_text(listing);
}

}  // namespace coif::cli
