#include "cook/strands/patches.h"

#include "cook/select/mesh_topology.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace coif {

std::vector<PatchView> view_patches(const HairMesh& mesh, const PatchSet& patches) {
  std::vector<PatchView> views(patches.count);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) views[patches.patch_of[t]].triangles.push_back(3 * t);
  for (PatchView& view : views) {
    for (std::size_t t : view.triangles) {
      for (std::size_t k = 0; k < 3; ++k) view.vertices.push_back(mesh.triangles[t + k]);
    }
    std::ranges::sort(view.vertices);
    view.vertices.erase(std::ranges::unique(view.vertices).begin(), view.vertices.end());
  }
  return views;
}

float doubled_area(const HairMesh& mesh, std::size_t t) {
  const Eigen::Vector3f& a = mesh.positions[mesh.triangles[t]];
  return (mesh.positions[mesh.triangles[t + 1]] - a).cross(mesh.positions[mesh.triangles[t + 2]] - a).norm();
}

namespace {

constexpr std::size_t kFragment = 8;        ///< Fewer triangles are an exporter's work, not an artist's strip.
constexpr double kMostFragments = 0.25;     ///< Of all triangles.
constexpr float kSameCoordinate = 1.0e-4f;  ///< Of the texture; a tenth of a texel of a large one.

/// Numbers the sets by first appearance.
PatchSet number_sets(DisjointSets& sets, std::size_t count) {
  PatchSet result;
  std::vector<std::uint32_t> number(count, kNoIndex);
  for (std::uint32_t t = 0; t < count; ++t) {
    std::uint32_t& patch = number[sets.find(t)];
    if (patch == kNoIndex) patch = result.count++;
    result.patch_of.push_back(patch);
  }
  return result;
}

/// Groups triangles whose corners share an id; `id_of` maps vertices to ids below the vertex count.
PatchSet group_by_corners(const HairMesh& mesh, std::span<const std::uint32_t> id_of) {
  DisjointSets sets(mesh.triangle_count());
  std::vector<std::uint32_t> first(mesh.positions.size(), kNoIndex);
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& other = first[id_of[mesh.triangles[3 * t + k]]];
      if (other == kNoIndex) {
        other = t;
      } else {
        sets.unite(other, t);
      }
    }
  }
  return number_sets(sets, mesh.triangle_count());
}

/// The two ends of a side, the one with the smaller place first.
struct Ends {
  std::uint32_t low, high;
};

Ends ends_of(const HairMesh& mesh, std::span<const std::uint32_t> place, const EdgeUse& use) {
  const std::uint32_t a = mesh.triangles[3 * use.triangle + use.side];
  const std::uint32_t b = mesh.triangles[3 * use.triangle + (use.side + 1) % 3];
  return place[a] < place[b] ? Ends{a, b} : Ends{b, a};
}

bool same_coordinates(const HairMesh& mesh, const Ends& a, const Ends& b) {
  if (mesh.uvs.empty()) return true;
  return (mesh.uvs[a.low] - mesh.uvs[b.low]).cwiseAbs().maxCoeff() <= kSameCoordinate &&
         (mesh.uvs[a.high] - mesh.uvs[b.high]).cwiseAbs().maxCoeff() <= kSameCoordinate;
}

PatchSet group_by_islands(const HairMesh& mesh, std::span<const std::uint32_t> place) {
  constexpr std::size_t kMostCharts = 16;  ///< On one edge; more are a hedgehog, and comparing all would be quadratic.
  DisjointSets sets(mesh.triangle_count());
  std::vector<EdgeUse> charts;  ///< One use for each pair of texture coordinates that meets at the edge.
  for_each_edge(sorted_edges(mesh.triangles, place), [&](std::span<const EdgeUse> uses) {
    charts.clear();
    for (const EdgeUse& use : uses) {
      const Ends ends = ends_of(mesh, place, use);
      const auto same = std::ranges::find_if(
          charts, [&](const EdgeUse& chart) { return same_coordinates(mesh, ends, ends_of(mesh, place, chart)); });
      if (same != charts.end()) {
        sets.unite(same->triangle, use.triangle);
      } else if (charts.size() < kMostCharts) {
        charts.push_back(use);
      }
    }
  });
  return number_sets(sets, mesh.triangle_count());
}

std::vector<std::size_t> sizes_of(const PatchSet& patches) {
  std::vector<std::size_t> sizes(patches.count, 0);
  for (std::uint32_t patch : patches.patch_of) ++sizes[patch];
  return sizes;
}

/// Share of the triangles that are in a fragment though their place is larger.
double fragment_share(const PatchSet& patches, const PatchSet& by_position) {
  const std::vector<std::size_t> sizes = sizes_of(patches), largest = sizes_of(by_position);
  std::size_t fragments = 0;
  for (std::size_t t = 0; t < patches.patch_of.size(); ++t) {
    fragments += sizes[patches.patch_of[t]] < kFragment && largest[by_position.patch_of[t]] >= kFragment ? 1 : 0;
  }
  return double(fragments) / double(patches.patch_of.size());
}

void choose(const HairMesh& mesh, const PatchSet& finest, const PatchSet& by_position, ExtractedPatches& result) {
  const double fragments = fragment_share(finest, by_position);
  const bool shattered = fragments > kMostFragments;
  const std::string fine = mesh.uvs.empty() ? "index" : "island";
  result.chosen = shattered ? "position" : fine;
  result.reason = fmt::format("by {}: {:.0f} % of the triangles are in fragments {}", result.chosen, 100 * fragments,
                              mesh.uvs.empty() ? "by index" : "by texture island");
}

}  // namespace

ExtractedPatches extract_patches(const HairMesh& mesh, std::span<const std::uint32_t> place,
                                 const std::string& connectivity) {
  std::vector<std::uint32_t> identity(mesh.positions.size());
  std::iota(identity.begin(), identity.end(), 0u);
  PatchSet by_index = group_by_corners(mesh, identity);
  PatchSet by_position = group_by_corners(mesh, place);
  PatchSet by_island = group_by_islands(mesh, place);

  ExtractedPatches result;
  result.by_index = by_index.count;
  result.by_position = by_position.count;
  result.by_island = by_island.count;
  result.chosen = connectivity;
  result.reason = fmt::format("by {}: the recipe says so", connectivity);
  if (connectivity == "auto") choose(mesh, mesh.uvs.empty() ? by_index : by_island, by_position, result);
  result.patches = std::move(result.chosen == "position" ? by_position
                             : result.chosen == "index"  ? by_index
                                                         : by_island);
  return result;
}

std::vector<std::uint32_t> separate_patches(HairMesh& mesh, const PatchSet& patches) {
  constexpr std::uint32_t kNobody = kNoIndex;
  std::vector<std::uint32_t> owner(mesh.positions.size(), kNobody);
  // A vertex's copies for other patches; most vertices have none.
  std::vector<std::pair<std::uint64_t, std::size_t>> foreign;  ///< Patch and vertex, corner.
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t patch = patches.patch_of[i / 3], v = mesh.triangles[i];
    if (owner[v] == kNobody) owner[v] = patch;
    if (owner[v] != patch) foreign.emplace_back(std::uint64_t(patch) << 32 | v, i);
  }
  std::ranges::sort(foreign);
  std::vector<std::uint32_t> original;
  for (std::size_t i = 0; i < foreign.size(); ++i) {
    const auto& [key, corner] = foreign[i];
    const bool is_new = i == 0 || foreign[i - 1].first != key;
    if (is_new) {
      mesh.append_copy(std::uint32_t(key));
      original.push_back(std::uint32_t(key));
    }
    mesh.triangles[corner] = std::uint32_t(mesh.positions.size() - 1);
  }
  return original;
}

namespace {

using Eigen::Vector3f;

Vector3f face_vector(const HairMesh& mesh, std::size_t t) {
  const Vector3f& a = mesh.positions[mesh.triangles[t]];
  return (mesh.positions[mesh.triangles[t + 1]] - a).cross(mesh.positions[mesh.triangles[t + 2]] - a);
}

bool is_unit(const Vector3f& n) { return std::abs(n.squaredNorm() - 1.0f) < 0.02f; }

}  // namespace

std::size_t complete_normals(HairMesh& mesh, std::span<const std::uint32_t> place) {
  mesh.normals.resize(mesh.positions.size(), Vector3f::Zero());
  std::size_t missing = 0;
  for (const Vector3f& n : mesh.normals) missing += is_unit(n) ? 0 : 1;
  if (missing == 0) return 0;

  std::vector<Vector3f> own(mesh.positions.size(), Vector3f::Zero()), mean = own;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    for (int k = 0; k < 3; ++k) own[mesh.triangles[t + std::size_t(k)]] += face_vector(mesh, t);
  }
  // Each corner adds its face to every side of the place that looks the same way; a side is known by its first vertex.
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (own[v].dot(own[place[v]]) >= 0) mean[place[v]] += own[v];
  }
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (is_unit(mesh.normals[v])) continue;
    const Vector3f& around = mean[place[v]];
    const bool same_side = own[v].dot(around) > 0;
    const Vector3f normal = same_side ? around : own[v];
    mesh.normals[v] = normal.norm() > 0 ? Vector3f(normal.normalized()) : Vector3f(Vector3f::UnitY());
  }
  return missing;
}

}  // namespace coif
