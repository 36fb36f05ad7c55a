#include "render/stage_renderer.h"

#include "base/geometry.h"
#include "base/words.h"
#include "import/source_model.h"
#include "render/patch_color.h"

#include <coif/skinning.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace coif::render {
namespace {

std::vector<Eigen::Vector3f> smooth_normals(const importer::SourceMesh& mesh) {
  std::vector<Eigen::Vector3f> normals(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const std::uint32_t* corner = &mesh.triangles[i];
    const Eigen::Vector3f& a = mesh.positions[corner[0]];
    // Not normalised: large triangles shall count for more.
    const Eigen::Vector3f n = (mesh.positions[corner[1]] - a).cross(mesh.positions[corner[2]] - a);
    for (int k = 0; k < 3; ++k) normals[corner[k]] += n;
  }
  for (Eigen::Vector3f& n : normals) n = n.squaredNorm() > 0 ? n.normalized() : Eigen::Vector3f::UnitY();
  return normals;
}

}  // namespace

namespace {

/// For each node its share of the head's turn; empty where nothing follows the head's bone.
std::vector<float> turning_of_nodes(const importer::SourceModel& model, const std::string& head_bone) {
  const auto head = std::ranges::find(model.nodes, head_bone, &importer::SourceNode::name);
  if (head_bone.empty() || head == model.nodes.end()) return {};
  const auto head_node = std::size_t(head - model.nodes.begin());
  std::vector<float> turning(model.nodes.size(), 0);
  turning[head_node] = 1;
  for (std::size_t n = head_node + 1; n < model.nodes.size(); ++n) {
    const std::uint32_t parent = model.nodes[n].parent;
    if (parent != importer::kNoIndex && turning[parent] == 1) turning[n] = 1;
  }
  const std::uint32_t above = head->parent;
  if (above != importer::kNoIndex && matches(model.nodes[above].name, "*neck*")) turning[above] = 0.5f;
  const bool follows = std::ranges::any_of(model.meshes, [&](const importer::SourceMesh& mesh) {
    return std::ranges::any_of(mesh.influences,
                               [&](const importer::SourceInfluence& i) { return turning[i.node] > 0; });
  });
  return follows ? turning : std::vector<float>{};
}

float turning_of(const importer::SourceMesh& mesh, std::size_t vertex, std::span<const float> turning) {
  if (mesh.influences.empty()) return turning[mesh.node];
  float sum = 0, all = 0;
  for (std::uint32_t i = mesh.influence_begin[vertex]; i < mesh.influence_begin[vertex + 1]; ++i) {
    sum += mesh.influences[i].weight * turning[mesh.influences[i].node];
    all += mesh.influences[i].weight;
  }
  return all > 0 ? sum / all : 0;
}

}  // namespace

std::vector<float> turning_shares(const importer::SourceModel& model, const importer::SourceMesh& mesh,
                                  const std::string& head_bone) {
  const std::vector<float> of_nodes = turning_of_nodes(model, head_bone);
  std::vector<float> shares;
  for (std::size_t i = 0; i < mesh.positions.size() && !of_nodes.empty(); ++i)
    shares.push_back(turning_of(mesh, i, of_nodes));
  return shares;
}

SolidMesh body_mesh(const importer::SourceModel& model, const importer::SourceMesh& mesh,
                    const Eigen::Vector3f& head_joint, const BodyTurn& pose) {
  const std::vector<Eigen::Vector3f> normals = mesh.normals.empty() ? smooth_normals(mesh) : mesh.normals;
  SolidMesh solid;
  solid.vertices.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    SolidVertex& vertex = solid.vertices.emplace_back();
    vertex.position = mesh.positions[i] - head_joint;
    vertex.normal = normals[i];
    if (!mesh.uvs.empty()) vertex.uv = mesh.uvs[i];
  }
  turn_back(turning_shares(model, mesh, pose.head_bone), pose.turn, solid.vertices);
  solid.triangles = mesh.triangles;
  if (mesh.material < model.materials.size()) {
    const importer::SourceMaterial& material = model.materials[mesh.material];
    const bool textured = !material.base_texture.path.empty() || material.base_texture.image != importer::kNoIndex;
    // The colour beneath a texture is white as a rule: clay until somebody has the texture.
    if (!textured) solid.color = material.base_color.head<3>();
    solid.roughness = material.roughness;
  }
  return solid;
}

void dress(const importer::SourceModel& model, const importer::SourceMesh& mesh, const BodyTextures& textures,
           SolidMesh& solid) {
  if (mesh.material >= std::min(textures.size(), model.materials.size()) || mesh.uvs.empty()) return;
  if (textures[mesh.material] == nullptr) return;
  constexpr float kBlendedCutoff = 0.5f;  // Blended texels are holes or not, too: bodies are not sorted.
  const importer::SourceMaterial& material = model.materials[mesh.material];
  solid.texture = textures[mesh.material];
  solid.color = material.base_color.head<3>();
  if (material.alpha_use == importer::AlphaUse::kMask) solid.alpha_cutoff = material.alpha_cutoff;
  if (material.alpha_use == importer::AlphaUse::kBlend) solid.alpha_cutoff = kBlendedCutoff;
}

namespace {

/// Empty where the palette is not the asset's.
std::vector<SkinnedVertex> skin(const Asset& asset, std::span<const Mat34> palette) {
  std::vector<SkinnedVertex> skinned(asset.vertices().size());
  if (skin_vertices(asset, palette, 0, skinned) != Status::kOk) skinned.clear();
  return skinned;
}

SolidVertex solid(const SkinnedVertex& vertex) {
  return {to_eigen(vertex.position), to_eigen(vertex.normal).normalized()};
}

SolidMesh patch_surface(const Asset& asset, std::span<const SkinnedVertex> skinned, const PatchRecord& patch) {
  SolidMesh mesh;
  std::unordered_map<std::uint32_t, std::uint32_t> place_of;  // a patch uses few of the asset's vertices
  for (const std::uint32_t index : asset.indices().subspan(patch.first_index, patch.index_count)) {
    const auto [place, is_new] = place_of.try_emplace(index, std::uint32_t(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(solid(skinned[index]));
    mesh.triangles.push_back(place->second);
  }
  return mesh;
}

}  // namespace

std::vector<SolidMesh> patch_surfaces(const Asset& asset, std::span<const Mat34> palette, std::uint32_t lod) {
  const std::vector<SkinnedVertex> skinned = skin(asset, palette);
  std::vector<SolidMesh> meshes;
  if (skinned.empty()) return meshes;
  for (const PatchRecord& patch : asset.lod_patches(lod)) {
    meshes.push_back(patch_surface(asset, skinned, patch));
    meshes.back().color = patch_color(meshes.size() - 1);
  }
  return meshes;
}

void mark_patch(std::size_t marked, std::span<SolidMesh> patches) {
  for (std::size_t i = 0; i < patches.size(); ++i) {
    patches[i].color = i == marked ? Eigen::Vector3f(0.8f, 0.02f, 0.02f) : Eigen::Vector3f(0.25f, 0.25f, 0.25f);
  }
}

}  // namespace coif::render
