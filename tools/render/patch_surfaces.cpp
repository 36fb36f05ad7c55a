#include "render/patch_surfaces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace coif {
namespace {

constexpr float kSnorm = 32767.0f;

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

using Rows = Eigen::Matrix<float, 3, 4, Eigen::RowMajor>;

/// What moves a vertex; nothing where the hair is rigid.
Rows blended(const Asset& asset, std::uint32_t index, std::span<const Mat34> palette) {
  if (asset.skin().empty()) return Rows::Identity();
  const SkinRecord& skin = asset.skin()[index];
  Rows sum = Rows::Zero();
  for (int k = 0; k < 4; ++k) {
    sum += float(skin.weight[k]) / 255.0f * Eigen::Map<const Rows>(&palette[skin.bone[k]].m[0][0]);
  }
  return sum;
}

SolidVertex skinned(const Asset& asset, std::span<const Mat34> palette, std::uint32_t index) {
  const VertexRecord& vertex = asset.vertices()[index];
  const Rows rows = blended(asset, index, palette);
  const Eigen::Map<const Eigen::Vector3f> position(vertex.position);
  const Eigen::Vector3f normal(float(vertex.normal[0]), float(vertex.normal[1]), float(vertex.normal[2]));
  return {rows * position.homogeneous(), (rows.leftCols<3>() * (normal / kSnorm)).normalized()};
}

SolidMesh patch_surface(const Asset& asset, std::span<const Mat34> palette, const PatchRecord& patch) {
  SolidMesh mesh;
  std::unordered_map<std::uint32_t, std::uint32_t> place_of;  // a patch uses few of the asset's vertices
  for (const std::uint32_t index : asset.indices().subspan(patch.first_index, patch.index_count)) {
    const auto [place, is_new] = place_of.try_emplace(index, std::uint32_t(mesh.vertices.size()));
    if (is_new) mesh.vertices.push_back(skinned(asset, palette, index));
    mesh.triangles.push_back(place->second);
  }
  return mesh;
}

}  // namespace

std::vector<SolidMesh> patch_surfaces(const Asset& asset, std::span<const Mat34> palette, std::uint32_t lod) {
  std::vector<SolidMesh> meshes;
  for (const PatchRecord& patch : asset.lod_patches(lod)) {
    meshes.push_back(patch_surface(asset, palette, patch));
    meshes.back().color = patch_color(meshes.size() - 1);
  }
  return meshes;
}

}  // namespace coif
