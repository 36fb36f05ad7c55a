#include "render/patch_surfaces.h"

#include <coif/skinning.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace coif {
namespace {

/// Turning the hue by the golden section keeps the first n colours as far apart as n colours can be, for any n; a slow
/// change of brightness tells apart those that come round to the same hue.
Eigen::Vector3f patch_color(std::size_t patch) {
  const double turn = std::fmod(double(patch) * std::numbers::phi, 1.0);
  const float brightness = 0.35f + 0.15f * float(patch % 4);
  Eigen::Vector3f color;
  for (int channel = 0; channel < 3; ++channel) {
    const double distance = std::abs(std::fmod(turn + channel / 3.0, 1.0) - 0.5) * 6;  // 0..3
    color[channel] = brightness * float(std::clamp(distance - 1, 0.03, 1.0));
  }
  return color;
}

/// Empty where the palette is not the asset's.
std::vector<SkinnedVertex> skin(const Asset& asset, std::span<const Mat34> palette) {
  std::vector<SkinnedVertex> skinned(asset.vertices().size());
  if (skin_vertices(asset, palette, 0, skinned) != Status::kOk) skinned.clear();
  return skinned;
}

SolidVertex solid(const SkinnedVertex& vertex) {
  const Eigen::Vector3f normal(vertex.normal.x, vertex.normal.y, vertex.normal.z);
  return {{vertex.position.x, vertex.position.y, vertex.position.z}, normal.normalized()};
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

}  // namespace coif
