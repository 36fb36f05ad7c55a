#include "cook/cuts/split_mesh.h"

#include "cook/rig/skeleton.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace coif::cook {
namespace {

float mixed(float from, float to, float share) { return from + share * (to - from); }

/// Blends a unit vector, and the share stored beside it.
void mix_snorm(std::int16_t (&into)[4], const std::int16_t (&to)[4], float share) {
  Eigen::Vector3f direction;
  for (int k = 0; k < 3; ++k) direction[k] = mixed(float(into[k]), float(to[k]), share);
  // Opposite ones have nothing between them.
  if (direction.norm() > 1) {
    direction.normalize();
    for (int k = 0; k < 3; ++k) into[k] = std::int16_t(std::lround(direction[k] * 32767.0f));
  }
  into[3] = std::int16_t(std::lround(mixed(float(into[3]), float(to[3]), share)));
}

VertexRecord mixed(VertexRecord from, const VertexRecord& to, float share) {
  for (int k = 0; k < 3; ++k) from.position[k] = mixed(from.position[k], to.position[k], share);
  for (int k = 0; k < 2; ++k) from.uv[k] = mixed(from.uv[k], to.uv[k], share);
  mix_snorm(from.normal, to.normal, share);
  mix_snorm(from.tangent, to.tangent, share);
  return from;
}

SkinRecord mixed(const SkinRecord& from, const SkinRecord& to, float share) {
  std::vector<BoneWeight> weights;
  for (std::size_t k = 0; k < std::size(from.bone); ++k)
    add_weight(weights, from.bone[k], (1 - share) * from.weight[k]);
  for (std::size_t k = 0; k < std::size(to.bone); ++k) add_weight(weights, to.bone[k], share * to.weight[k]);
  return quantize_skin({std::move(weights)}).front();
}

}  // namespace

std::size_t finest_patch_count(const AssetContents& contents) {
  return contents.lods.empty() ? contents.patches.size() : contents.lods.front().patch_count;
}

std::size_t finest_triangle_count(const AssetContents& contents) {
  std::size_t indices = 0;
  for (std::size_t p = 0; p < finest_patch_count(contents); ++p) indices += contents.patches[p].index_count;
  return indices / 3;
}

SplitMesh::SplitMesh(const AssetContents& contents) : vertices_(contents.vertices), skin_(contents.skin) {
  for (const VertexRecord& vertex : vertices_) place_.push_back(place_of(vertex));
  for (std::uint32_t p = 0; p < finest_patch_count(contents); ++p) {
    const PatchRecord& patch = contents.patches[p];
    for (std::uint32_t i = patch.first_index; i < patch.first_index + patch.index_count; i += 3) {
      const auto origin = std::uint32_t(triangles_.size());
      triangles_.push_back({{contents.indices[i], contents.indices[i + 1], contents.indices[i + 2]}, p, origin});
      join(origin);
    }
  }
}

std::size_t SplitMesh::count_at(std::uint32_t from, std::uint32_t to) const {
  const auto found = at_edge_.find(edge_between(from, to));
  return found == at_edge_.end() ? 0 : found->second.size();
}

std::vector<SplitMesh::Halves> SplitMesh::split_edge(std::uint32_t from, std::uint32_t to, float share) {
  std::vector<Halves> halves;
  /// The new vertices so far: most triangles at an edge share its vertices.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> made;
  const std::uint32_t from_place = place_[from], to_place = place_[to];
  const std::vector<std::uint32_t> split = at_edge_[edge_between(from, to)];
  for (const std::uint32_t t : split) {
    const Triangle whole = triangles_[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = whole.vertex[k], b = whole.vertex[(k + 1) % 3], tip = whole.vertex[(k + 2) % 3];
      const bool along = place_[a] == from_place && place_[b] == to_place;
      if (!along && !(place_[a] == to_place && place_[b] == from_place)) continue;
      const auto ends = along ? std::pair(a, b) : std::pair(b, a);
      auto middle = made.find(ends);
      if (middle == made.end()) middle = made.emplace(ends, add_between(ends.first, ends.second, share)).first;
      leave(t);
      triangles_[t].vertex = {a, middle->second, tip};
      join(t);
      const auto added = std::uint32_t(triangles_.size());
      triangles_.push_back({{middle->second, b, tip}, whole.patch, whole.origin});
      join(added);
      halves.push_back({t, added, tip, middle->second});
      break;
    }
  }
  return halves;
}

std::vector<std::uint32_t> SplitMesh::write_to(AssetContents& contents) const {
  std::vector<std::uint32_t> order(triangles_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {},
                           [&](std::uint32_t t) { return triangles_[t].origin; });  // patches are in this order
  const std::vector<std::uint32_t> indices = std::move(contents.indices);
  contents.indices.clear();
  const std::size_t finest = finest_patch_count(contents);
  for (PatchRecord& patch : std::span(contents.patches).first(finest)) patch.index_count = 0;
  std::vector<std::uint32_t> origins;
  for (const std::uint32_t t : order) {
    const Triangle& triangle = triangles_[t];
    PatchRecord& patch = contents.patches[triangle.patch];
    if (patch.index_count == 0) patch.first_index = std::uint32_t(contents.indices.size());
    patch.index_count += 3;
    contents.indices.insert(contents.indices.end(), triangle.vertex.begin(), triangle.vertex.end());
    origins.push_back(triangle.origin);
  }
  for (PatchRecord& patch : std::span(contents.patches).subspan(finest)) {
    const auto first = indices.begin() + patch.first_index;
    patch.first_index = std::uint32_t(contents.indices.size());
    contents.indices.insert(contents.indices.end(), first, first + patch.index_count);
  }
  contents.vertices = vertices_;
  contents.skin = skin_;
  return origins;
}

SplitMesh::Edge SplitMesh::edge_between(std::uint32_t from, std::uint32_t to) const {
  const auto [low, high] = std::minmax(place_[from], place_[to]);
  return Edge(low) << 32 | high;
}

std::uint32_t SplitMesh::place_of(const VertexRecord& vertex) {
  const float* p = vertex.position;
  return places_.try_emplace({p[0], p[1], p[2]}, std::uint32_t(places_.size())).first->second;
}

/// Always from the place that came first, whichever way the edge is named, so that all its vertices get the same place.
std::uint32_t SplitMesh::add_between(std::uint32_t from, std::uint32_t to, float share) {
  if (place_[from] > place_[to]) {
    std::swap(from, to);
    share = 1 - share;
  }
  vertices_.push_back(mixed(vertices_[from], vertices_[to], share));
  place_.push_back(place_of(vertices_.back()));
  if (!skin_.empty()) skin_.push_back(mixed(skin_[from], skin_[to], share));
  return std::uint32_t(vertices_.size() - 1);
}

void SplitMesh::join(std::uint32_t triangle) {
  const auto& v = triangles_[triangle].vertex;
  for (std::size_t k = 0; k < 3; ++k) at_edge_[edge_between(v[k], v[(k + 1) % 3])].push_back(triangle);
}

void SplitMesh::leave(std::uint32_t triangle) {
  const auto& v = triangles_[triangle].vertex;
  for (std::size_t k = 0; k < 3; ++k) std::erase(at_edge_[edge_between(v[k], v[(k + 1) % 3])], triangle);
}

}  // namespace coif::cook
