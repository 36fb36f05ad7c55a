#include "cook/pack_mesh.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif {
namespace {

std::int16_t to_snorm16(float value) { return std::int16_t(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767.0f)); }

VertexRecord pack_vertex(const HairMesh& mesh, const StrandField& strands, const Eigen::Vector3f& origin,
                         std::uint32_t v) {
  VertexRecord record{};
  const Eigen::Vector3f position = mesh.positions[v] - origin;
  for (int k = 0; k < 3; ++k) {
    record.position[k] = position[k];
    record.normal[k] = to_snorm16(mesh.normals[v][k]);
    record.tangent[k] = to_snorm16(strands.tangent[v][k]);
  }
  record.tangent[3] = to_snorm16(std::max(0.0f, strands.place[v]));
  const Eigen::Vector2f uv = mesh.uvs.empty() ? Eigen::Vector2f(0.5f, strands.place[v]) : mesh.uvs[v];
  record.uv[0] = uv.x();
  record.uv[1] = uv.y();
  return record;
}

/// Indices of all patches in draw order, each patch's triangles ordered for the vertex cache; fills the patches' ranges.
std::vector<std::uint32_t> lay_out_indices(const HairMesh& mesh, const PatchSet& patches, const PatchOrder& order,
                                           std::vector<PatchRecord>& records) {
  std::vector<std::vector<std::uint32_t>> triangles(patches.count);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    auto& patch = triangles[patches.patch_of[t]];
    patch.insert(patch.end(), mesh.triangles.begin() + std::ptrdiff_t(3 * t),
                 mesh.triangles.begin() + std::ptrdiff_t(3 * t + 3));
  }
  std::vector<std::uint32_t> indices;
  indices.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < order.patch.size(); ++i) {
    auto& patch = triangles[order.patch[i]];
    // Only inside a patch: across patches it would destroy the draw order.
    meshopt_optimizeVertexCache(patch.data(), patch.data(), patch.size(), mesh.positions.size());
    records.push_back({std::uint32_t(indices.size()), std::uint32_t(patch.size()), float(order.distance[i]), 0});
    indices.insert(indices.end(), patch.begin(), patch.end());
  }
  return indices;
}

std::uint32_t heaviest_bone(const AssetContents& contents, const PatchRecord& patch) {
  std::array<std::uint64_t, kMaxBones> weight{};
  for (std::uint32_t i = patch.first_index; i < patch.first_index + patch.index_count; ++i) {
    const SkinRecord& skin = contents.skin[contents.indices[i]];
    for (int k = 0; k < 4; ++k) weight[skin.bone[k]] += skin.weight[k];
  }
  return std::uint32_t(std::ranges::max_element(weight) - weight.begin());
}

}  // namespace

void pack_mesh(const HairMesh& mesh, const PatchSet& patches, const PatchOrder& order, const StrandField& strands,
               const Eigen::Vector3d& head_joint, const SkinWeights& weights, AssetContents& contents) {
  const std::vector<std::uint32_t> indices = lay_out_indices(mesh, patches, order, contents.patches);
  const std::vector<SkinRecord> skin = quantize_skin(weights);
  const Eigen::Vector3f origin = head_joint.cast<float>();
  std::vector<std::uint32_t> new_place(mesh.positions.size());
  const std::size_t used =
      meshopt_optimizeVertexFetchRemap(new_place.data(), indices.data(), indices.size(), mesh.positions.size());
  contents.vertices.resize(used);
  contents.skin.resize(used);
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (new_place[v] == kNoIndex) continue;
    contents.vertices[new_place[v]] = pack_vertex(mesh, strands, origin, v);
    contents.skin[new_place[v]] = skin[v];
  }
  contents.indices.reserve(indices.size());
  for (std::uint32_t index : indices) contents.indices.push_back(new_place[index]);
  for (PatchRecord& patch : contents.patches) patch.bone = heaviest_bone(contents, patch);
}

}  // namespace coif
