#include "cook/disjoint_sets.h"
#include "validate/asset_checks.h"
#include "validate/strip_size.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>

namespace coif {
namespace {

constexpr float kTooWide = 1.5f;     // of the head's radius: the cooker cuts what is wider than 0.75
constexpr float kHeadRadius = 0.1f;  // metres, where no collider tells
constexpr std::size_t kSections = 8;

using Eigen::Vector3f;
using Corners = std::span<const std::uint32_t>;

/// Groups of triangles that share a place.
std::size_t pieces_of(const Asset& asset, Corners corners) {
  std::map<std::array<float, 3>, std::uint32_t> places;
  DisjointSets sets(corners.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const float(&at)[3] = asset.vertices()[corners[i]].position;
    sets.unite(i, places.try_emplace({at[0], at[1], at[2]}, i).first->second);
    if (i % 3 != 0) sets.unite(i, i - 1);
  }
  std::set<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < corners.size(); ++i) roots.insert(sets.find(i));
  return roots.size();
}

std::size_t section_of(const VertexRecord& vertex) {
  const auto place = std::size_t(std::max<int>(0, vertex.tangent[3]));
  return std::min(kSections - 1, place * kSections / 32767);
}

/// Mean over sections from root to tip of what a section spans across the strands, metres.
float width_of(const Asset& asset, Corners corners) {
  std::array<Vector3f, kSections> along;
  along.fill(Vector3f::Zero());
  for (const std::uint32_t corner : corners) {
    const VertexRecord& vertex = asset.vertices()[corner];
    along[section_of(vertex)] += Vector3f(vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]);
  }
  std::array<Eigen::AlignedBox3f, kSections> boxes;
  for (const std::uint32_t corner : corners) {
    const VertexRecord& vertex = asset.vertices()[corner];
    const Vector3f direction = along[section_of(vertex)].stableNormalized();
    const Vector3f at(vertex.position);
    boxes[section_of(vertex)].extend(Vector3f(at - direction * direction.dot(at)));
  }
  float sum = 0, count = 0;
  for (const Eigen::AlignedBox3f& box : boxes) {
    if (box.isEmpty()) continue;
    sum += box.diagonal().norm();
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}

float head_radius(const Asset& asset) {
  float radius = 0;
  for (const ColliderRecord& collider : asset.colliders()) {
    const bool keeps_out = (collider.flags & kColliderKeepsInside) == 0;
    if (keeps_out) radius = std::max({radius, collider.radii[0], collider.radii[1], collider.radii[2]});
  }
  return radius > 0 ? radius : kHeadRadius;
}

void find_unsortable(const Asset& asset, Issues& issues) {
  const float widest = kTooWide * head_radius(asset);
  for (std::size_t i = 0; i < asset.lod_patches(0).size(); ++i) {
    const PatchRecord& patch = asset.lod_patches(0)[i];
    const Corners corners = asset.indices().subspan(patch.first_index, patch.index_count);
    const std::size_t pieces = pieces_of(asset, corners);
    if (pieces > 1) {
      issues.push_back(patch_issue("A241", fmt::format("{} pieces that do not touch", pieces), i));
    }
    const float width = width_of(asset, corners);
    if (width > widest) {
      issues.push_back(
          patch_issue("A242", fmt::format("{:.2g} m wide across its strands, above {:.2g} m", width, widest), i));
    }
  }
}

}  // namespace

void check_patches(const Asset& asset, Issues& issues) {
  const std::size_t patches = asset.lod_patches(0).size();
  const std::size_t triangles = asset.lod_indices(0).size() / 3;
  if (is_shattered(triangles, patches)) {
    issues.push_back(make_issue("A243", fmt::format("{} triangles in {} patches", triangles, patches)));
  }
  find_unsortable(asset, issues);
}

}  // namespace coif
