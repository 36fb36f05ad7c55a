#include "import/assimp_scene.h"

#include "import/fbx_objects.h"
#include "import/raw_mesh.h"
#include "import/shown_meshes.h"
#include "import/source_warnings.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

namespace coif::importer {
namespace {

constexpr std::size_t kMostSearchedModels = 4096;  // Bounds the time for a file whose nodes are not found.

/// assimp makes a node of each model in the file's order, and keeps names.
void match_models(const FbxObjects& objects, SceneNodes& nodes) {
  nodes.model.assign(nodes.nodes.size(), nullptr);
  std::vector<std::size_t> searched(nodes.nodes.size(), 0);
  for (std::size_t n = 1; n < nodes.nodes.size(); ++n) {
    const std::uint32_t parent = nodes.nodes[n].parent;
    if (parent != 0 && nodes.model[parent] == nullptr) continue;
    const auto below = objects.below(parent == 0 ? 0 : nodes.model[parent]->id);
    const std::string_view name(nodes.origin[n]->mName.C_Str());
    const std::size_t end = std::min(below.size(), searched[parent] + kMostSearchedModels);
    for (std::size_t i = searched[parent]; i < end; ++i) {
      const FbxObject* const object = objects.find(below[i].from);
      if (object == nullptr || object->kind != FbxKind::kModel || object->name != name) continue;
      nodes.model[n] = object;
      searched[parent] = i + 1;
      break;
    }
  }
}

void mark_hidden(SceneNodes& nodes) {
  std::vector<bool> is_hidden(nodes.nodes.size(), false);  // By Visibility alone.
  for (std::size_t n = 1; n < nodes.nodes.size(); ++n) {
    const bool is_below_hidden = is_hidden[nodes.nodes[n].parent];
    const FbxObject* const model = nodes.model[n];
    is_hidden[n] =
        model == nullptr ? is_below_hidden : !model->is_visible || (is_below_hidden && model->inherits_visibility);
    if (is_hidden[n]) nodes.is_hidden[n] = true;
  }
}

bool has_triangles(const aiScene& scene, const aiNode& node) {
  return std::ranges::any_of(std::span(node.mMeshes, node.mNumMeshes), [&](unsigned mesh) {
    return mesh < scene.mNumMeshes && (scene.mMeshes[mesh]->mPrimitiveTypes & aiPrimitiveType_TRIANGLE) != 0;
  });
}

/// Keeps the first child of each group that shows a mesh, itself or below it.
void mark_coarser(const aiScene& scene, SceneNodes& nodes) {
  const std::size_t count = nodes.nodes.size();
  std::vector<bool> shows_mesh(count, false);
  for (std::size_t n = count; n-- > 1;) {
    if (!nodes.is_hidden[n] && has_triangles(scene, *nodes.origin[n])) shows_mesh[n] = true;
    if (shows_mesh[n]) shows_mesh[nodes.nodes[n].parent] = true;
  }
  std::vector<bool> has_finest(count, false);
  for (std::size_t n = 1; n < count; ++n) {
    const std::uint32_t parent = nodes.nodes[n].parent;
    const bool is_level = nodes.model[parent] != nullptr && nodes.model[parent]->is_lod_group;
    nodes.is_coarser[n] = nodes.is_coarser[parent] || (is_level && has_finest[parent]);
    if (is_level && shows_mesh[n]) has_finest[parent] = true;
  }
}

std::vector<std::string> keys_that_are_on(std::span<const FbxShape> shapes) {
  std::vector<std::string> on;
  for (const FbxShape& shape : shapes) {
    if (shape.key_weight != 0) on.push_back(fmt::format("'{}' at {:g}", printable_text(shape.key), shape.key_weight));
  }
  return on;
}

void add_difference(const aiVector3D& target, const aiVector3D& base, double weight, Eigen::Vector3f& to) {
  to += (weight * Eigen::Vector3d(double(target.x) - base.x, double(target.y) - base.y, double(target.z) - base.z))
            .cast<float>();
}

/// An anim mesh of assimp is the whole mesh with the shape fully on.
void add_shape(const aiMesh& mesh, const aiAnimMesh& shape, double weight, RawMesh& out) {
  if (weight == 0 || shape.mNumVertices != mesh.mNumVertices) return;
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    if (shape.HasPositions()) add_difference(shape.mVertices[v], mesh.mVertices[v], weight, out.positions[v]);
    if (shape.HasNormals() && mesh.HasNormals())
      add_difference(shape.mNormals[v], mesh.mNormals[v], weight, out.normals[v]);
  }
}

}  // namespace

void add_fbx_objects(const FbxObjects& objects, const aiScene& scene, SceneNodes& nodes) {
  nodes.fbx = &objects;
  match_models(objects, nodes);
  mark_hidden(nodes);
  mark_coarser(scene, nodes);
}

void FbxShapeKeys::apply(const aiMesh& mesh, std::uint32_t node, RawMesh& out, Diagnostics& warnings) {
  if (nodes_.fbx == nullptr || nodes_.model[node] == nullptr) return;
  const FbxObject* unlike = nullptr;
  for (const FbxConnection& connection : nodes_.fbx->below(nodes_.model[node]->id)) {
    const FbxObject* const geometry = nodes_.fbx->find(connection.from);
    if (geometry == nullptr || geometry->kind != FbxKind::kMesh) continue;
    const auto shapes = nodes_.fbx->shapes(*geometry);
    if (shapes.size() != mesh.mNumAnimMeshes) {
      if (!keys_that_are_on(shapes).empty()) unlike = geometry;
      continue;
    }
    for (std::size_t s = 0; s < shapes.size(); ++s) add_shape(mesh, *mesh.mAnimMeshes[s], shapes[s].weight, out);
    if (told_.insert(geometry).second) warn_of_shape_keys(out.name, keys_that_are_on(shapes), warnings);
    return;
  }
  if (unlike == nullptr || !told_.insert(unlike).second) return;
  warn(warnings, source_code::kShapeKeys,
       "mesh '{}': shape keys are on and could not be read; apply them in the modelling tool and export again",
       out.name);
}

}  // namespace coif::importer
