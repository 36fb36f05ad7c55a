#include "cook/pack/pack.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::cook {
namespace {

std::int16_t to_snorm16(float value) { return std::int16_t(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767.0f)); }

VertexRecord pack_vertex(const HairStrips& hair, const Eigen::Vector3f& origin, std::uint32_t v) {
  const HairMesh& mesh = hair.mesh;
  const StrandField& strands = hair.strands;
  VertexRecord record{};
  const Eigen::Vector3f position = mesh.positions[v] - origin;
  for (int k = 0; k < 3; ++k) {
    record.position[k] = position[k];
    record.normal[k] = to_snorm16(mesh.normals[v][k]);
    record.tangent[k] = to_snorm16(strands.tangent[v][k]);
  }
  record.normal[3] = to_snorm16(1);  // nothing shades it yet
  record.tangent[3] = to_snorm16(std::max(0.0f, strands.place[v]));
  const Eigen::Vector2f uv = mesh.uvs.empty() ? Eigen::Vector2f(0.5f, strands.place[v]) : mesh.uvs[v];
  record.uv[0] = uv.x();
  record.uv[1] = uv.y();
  return record;
}

/// Orders the triangles for the vertex cache. Numbers the vertices anew: with the whole mesh's numbers each patch would
/// cost as much as the mesh.
class CacheOrder {
 public:
  explicit CacheOrder(std::size_t vertices) : number_(vertices, importer::kNoIndex) {}

  std::vector<std::uint32_t> operator()(std::span<const std::uint32_t> triangles) {
    vertices_.clear();
    std::vector<std::uint32_t> order;
    for (std::uint32_t v : triangles) {
      if (number_[v] == importer::kNoIndex) {
        number_[v] = std::uint32_t(vertices_.size());
        vertices_.push_back(v);
      }
      order.push_back(number_[v]);
    }
    meshopt_optimizeVertexCache(order.data(), order.data(), order.size(), vertices_.size());
    for (std::uint32_t& index : order) index = vertices_[index];
    for (std::uint32_t v : vertices_) number_[v] = importer::kNoIndex;
    return order;
  }

 private:
  std::vector<std::uint32_t> number_, vertices_;
};

/// Appends the level's indices, patches in draw order, each patch's triangles ordered for the vertex cache: only inside
/// a patch, across patches it would destroy the draw order.
void lay_out_level(const DetailLevel& level, const PatchOrder& order, CacheOrder& for_cache,
                   std::vector<std::uint32_t>& indices, AssetContents& contents) {
  LodRecord record{std::uint32_t(contents.patches.size()), 0, level.screen_size, level.error};
  for (std::size_t i = 0; i < order.patch.size(); ++i) {
    const auto& triangles = level.triangles_of[order.patch[i]];
    if (triangles.empty()) continue;
    const std::vector<std::uint32_t> patch = for_cache(triangles);
    contents.patches.push_back(
        {std::uint32_t(indices.size()), std::uint32_t(patch.size()), float(order.distance[i]), 0, order.file_place[i]});
    indices.insert(indices.end(), patch.begin(), patch.end());
  }
  record.patch_count = std::uint32_t(contents.patches.size()) - record.first_patch;
  contents.lods.push_back(record);
}

/// In how many levels each bone is simulated; each level simulates fewer than the one before.
std::vector<std::uint8_t> count_levels(std::span<const DetailLevel> levels) {
  std::vector<std::uint8_t> counts(levels.front().simulated.size(), 0);
  for (const DetailLevel& level : levels) {
    for (std::size_t b = 0; b < counts.size(); ++b) {
      if (level.simulated[b]) ++counts[b];
    }
  }
  return counts;
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

void pack_mesh(const HairStrips& hair, const HairRig& rig, std::span<const DetailLevel> levels, const PatchOrder& order,
               AssetContents& contents) {
  const std::size_t vertices = hair.mesh.positions.size();
  std::vector<std::uint32_t> indices;
  CacheOrder for_cache(vertices);
  for (const DetailLevel& level : levels) lay_out_level(level, order, for_cache, indices, contents);
  if (levels.size() == 1) {
    contents.lods.clear();
  } else {
    contents.lod_bones = count_levels(levels);
  }
  const std::vector<SkinRecord> skin = quantize_skin(rig.weights);
  const Eigen::Vector3f origin = rig.skeleton.bones[0].start.cast<float>();
  std::vector<std::uint32_t> new_place(vertices);
  const std::size_t used = meshopt_optimizeVertexFetchRemap(new_place.data(), indices.data(), indices.size(), vertices);
  contents.vertices.resize(used);
  contents.skin.resize(used);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    if (new_place[v] == importer::kNoIndex) continue;
    contents.vertices[new_place[v]] = pack_vertex(hair, origin, v);
    contents.skin[new_place[v]] = skin[v];
  }
  contents.indices.reserve(indices.size());
  for (std::uint32_t index : indices) contents.indices.push_back(new_place[index]);
  for (PatchRecord& patch : contents.patches) patch.bone = heaviest_bone(contents, patch);
}

}  // namespace coif::cook
