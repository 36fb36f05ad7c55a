#include "import/assimp_scene.h"
#include "import/scene_surface.h"

#include "import/collada_document.h"
#include "import/raw_mesh.h"
#include "import/shown_meshes.h"
#include "import/source_warnings.h"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace coif::importer {
namespace {

Eigen::Vector3f vector(const aiVector3D& v) { return {v.x, v.y, v.z}; }

// assimp knows bones by name alone.
void add_bones(const aiMesh& mesh, const SceneNodes& nodes, const std::string& label, RawMesh& out,
               Diagnostics& warnings) {
  for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones)) {
    const auto found = nodes.joint_named.find(bone->mName.C_Str());
    const Eigen::Affine3d bone_from_mesh = affine_of(bone->mOffsetMatrix);
    if (found == nodes.joint_named.end() || !bone_from_mesh.matrix().allFinite()) {
      warn(warnings, source_code::kSkin, "{}: bone '{}' dropped: {}", label, text_of(bone->mName),
           found == nodes.joint_named.end() ? "no node has its name" : "its bind matrix is not finite");
      continue;
    }
    const auto number = static_cast<std::uint32_t>(out.bones.size());
    out.bones.push_back({found->second, bone_from_mesh});
    for (const aiVertexWeight& weight : std::span(bone->mWeights, bone->mNumWeights)) {
      out.weights.push_back({weight.mVertexId, number, weight.mWeight});
    }
  }
}

/// In some formats the reader has to normalise weights; users who need the original values must be told.
void warn_of_sums(const RawMesh& mesh, const std::string& label, Diagnostics& warnings) {
  constexpr double kLeastError = 0.01;  // programs that write percent stay below it
  std::vector<double> sums(mesh.positions.size(), 0);
  for (const RawWeight& weight : mesh.weights) {
    if (weight.vertex < sums.size() && weight.weight > 0) sums[weight.vertex] += double{weight.weight};
  }
  const auto is_off = [](double sum) { return sum > 0 && std::isfinite(sum) && std::abs(sum - 1) > kLeastError; };
  const auto first = std::ranges::find_if(sums, is_off);
  if (first == sums.end()) return;
  warn(warnings, source_code::kSkin,
       "{}: the weights of {} vertices do not add up to 1 (of vertex {} to {:.4g}) and were scaled until "
       "they do; normalize the weights "
       "(Blender: Weights > Normalize All) and export again where bones should hold less",
       label, std::ranges::count_if(sums, is_off), first - sums.begin(), *first);
}

void add_triangles(const aiMesh& mesh, RawMesh& out) {
  for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
    if (face.mNumIndices == 3) {
      out.triangles.insert(out.triangles.end(), face.mIndices, face.mIndices + 3);
    } else {
      ++out.points_and_lines;
    }
  }
}

// A cluster of an FBX takes over where the geometric transform ends.
void move_to_bound_space(RawMesh& mesh) {
  if (mesh.node_from_mesh.matrix().isIdentity(0)) return;
  const Eigen::Matrix3d turn = mesh.node_from_mesh.linear().inverse().transpose();
  for (Eigen::Vector3f& position : mesh.positions)
    position = (mesh.node_from_mesh * position.cast<double>()).cast<float>();
  for (Eigen::Vector3f& normal : mesh.normals) normal = (turn * normal.cast<double>()).cast<float>();
  mesh.node_from_mesh.setIdentity();
}

std::vector<Eigen::Vector2f> uvs_of(const aiMesh& mesh, const TexturePlace& place, const std::string& label,
                                    Diagnostics& warnings) {
  std::vector<Eigen::Vector2f> uvs;
  const unsigned set = mesh.HasTextureCoords(place.uv_set) ? place.uv_set : 0;
  if (!mesh.HasTextureCoords(set)) return uvs;
  if (set != place.uv_set) {
    warn(warnings, source_code::kUvs, "{}: its texture names UV set {}, which the mesh lacks; the first is taken",
         label, place.uv_set);
  }
  for (const aiVector3D& given : std::span(mesh.mTextureCoords[set], mesh.mNumVertices)) {
    const Eigen::Vector2f placed = place({given.x, given.y});
    // assimp's V grows upwards whatever the file, this project's downwards.
    uvs.emplace_back(placed.x(), 1.0f - placed.y());
  }
  return uvs;
}

RawMesh raw_mesh(const aiScene& scene, const aiMesh& mesh, std::uint32_t node, const SceneNodes& nodes,
                 const SourceSurface& surface, FbxShapeKeys& shape_keys, Diagnostics& warnings) {
  RawMesh out;
  out.name = text_of(mesh.mName);
  if (surface.names != nullptr) out.name = ColladaNames::find(surface.names->geometries, out.name);
  if (out.name.empty()) out.name = nodes.nodes[node].name;
  const std::string label = fmt::format("mesh '{}'", out.name);
  if (mesh.mMaterialIndex < scene.mNumMaterials)
    out.material = mesh.mMaterialIndex;
  else
    warn(warnings, source_code::kMaterials, "{}: refers to an absent material; a plain one is used", label);
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    out.positions.push_back(vector(mesh.mVertices[v]));
    if (mesh.HasNormals()) out.normals.push_back(vector(mesh.mNormals[v]));
  }
  shape_keys.apply(mesh, node, out, warnings);
  add_bones(mesh, nodes, label, out, warnings);
  warn_of_sums(out, label, warnings);
  out.node_from_mesh = nodes.node_from_mesh[node];
  if (!out.bones.empty()) move_to_bound_space(out);
  add_triangles(mesh, out);
  out.colors = vertex_colors(mesh);
  const TexturePlace place = out.material == kNoIndex ? TexturePlace{}
                                                      : texture_place(*scene.mMaterials[out.material],
                                                                      text_of(mesh.mName), surface, label, warnings);
  out.uvs = uvs_of(mesh, place, label, warnings);
  return out;
}

}  // namespace

std::vector<SourceMesh> convert_meshes(const aiScene& scene, const SceneNodes& nodes, const SourceSurface& surface,
                                       Diagnostics& warnings) {
  std::vector<SourceMesh> meshes;
  std::vector<std::string> hidden, coarser;
  FbxShapeKeys shape_keys(nodes);
  for (std::uint32_t n = 0; n < nodes.nodes.size(); ++n) {
    const aiNode& node = *nodes.origin[n];
    if (nodes.is_hidden[n] && node.mNumMeshes != 0) {
      hidden.push_back(nodes.nodes[n].name);
      continue;
    }
    if (nodes.is_coarser[n] && node.mNumMeshes != 0) {
      coarser.push_back(nodes.nodes[n].name);
      continue;
    }
    for (const unsigned index : std::span(node.mMeshes, node.mNumMeshes)) {
      if (index >= scene.mNumMeshes) {
        warn(warnings, source_code::kRepaired, "node '{}': refers to an absent mesh", nodes.nodes[n].name);
        continue;
      }
      const RawMesh raw = raw_mesh(scene, *scene.mMeshes[index], n, nodes, surface, shape_keys, warnings);
      keep_mesh(raw, place_mesh(raw, n, nodes.nodes, warnings), meshes, warnings);
    }
  }
  warn_of_hidden(hidden, warnings);
  warn_of_coarser(coarser, {}, warnings);
  return meshes;
}

}  // namespace coif::importer
