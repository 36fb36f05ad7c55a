#include "cook/strands/patches.h"

#include "cook/recipe/strip_recipe.h"
#include "cook/select/mesh_topology.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace coif::cook {
namespace {

constexpr std::size_t kFragment = 8;        ///< Fewer triangles are an exporter's work, not an artist's strip.
constexpr double kMostFragments = 0.25;     ///< Share of all triangles.
constexpr float kSameCoordinate = 1.0e-4f;  ///< In texture coordinates; a tenth of a texel of a large texture.

/// Numbers the sets by first appearance.
PatchSet number_sets(DisjointSets& sets, std::size_t count) {
  PatchSet result;
  std::vector<std::uint32_t> number(count, importer::kNoIndex);
  for (std::uint32_t t = 0; t < count; ++t) {
    std::uint32_t& patch = number[sets.find(t)];
    if (patch == importer::kNoIndex) patch = result.count++;
    result.patch_of.push_back(patch);
  }
  return result;
}

/// Groups triangles whose corners share an id; `id_of` maps vertices to ids below the vertex count.
PatchSet group_by_corners(const HairMesh& mesh, std::span<const std::uint32_t> id_of) {
  DisjointSets sets(mesh.triangle_count());
  std::vector<std::uint32_t> first(mesh.positions.size(), importer::kNoIndex);
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& other = first[id_of[mesh.triangles[3 * t + k]]];
      if (other == importer::kNoIndex) {
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

Ends ends_of(const HairMesh& mesh, std::span<const std::uint32_t> welded, const EdgeUse& use) {
  const std::uint32_t a = mesh.triangles[3 * use.triangle + use.side];
  const std::uint32_t b = mesh.triangles[3 * use.triangle + (use.side + 1) % 3];
  return welded[a] < welded[b] ? Ends{a, b} : Ends{b, a};
}

bool same_coordinates(const HairMesh& mesh, const Ends& a, const Ends& b) {
  if (mesh.uvs.empty()) return true;
  return (mesh.uvs[a.low] - mesh.uvs[b.low]).cwiseAbs().maxCoeff() <= kSameCoordinate &&
         (mesh.uvs[a.high] - mesh.uvs[b.high]).cwiseAbs().maxCoeff() <= kSameCoordinate;
}

PatchSet group_by_islands(const HairMesh& mesh, std::span<const std::uint32_t> welded) {
  constexpr std::size_t kMostCharts = 16;  ///< On one edge; more are a hedgehog, and comparing all would be quadratic.
  DisjointSets sets(mesh.triangle_count());
  std::vector<EdgeUse> charts;  ///< One use for each pair of texture coordinates that meets at the edge.
  for_each_edge(sorted_edges(mesh.triangles, welded), [&](std::span<const EdgeUse> uses) {
    charts.clear();
    for (const EdgeUse& use : uses) {
      const Ends ends = ends_of(mesh, welded, use);
      const auto same = std::ranges::find_if(
          charts, [&](const EdgeUse& chart) { return same_coordinates(mesh, ends, ends_of(mesh, welded, chart)); });
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
  const Connectivity fine = mesh.uvs.empty() ? Connectivity::kIndex : Connectivity::kIsland;
  result.chosen = shattered ? Connectivity::kPosition : fine;
  result.reason = fmt::format("by {}: {:.0f} % of the triangles are in fragments {}", word_of(result.chosen),
                              100 * fragments, mesh.uvs.empty() ? "by index" : "by texture island");
}

}  // namespace

const char* word_of(Connectivity connectivity) {
  switch (connectivity) {
    case Connectivity::kAuto: return "auto";
    case Connectivity::kIsland: return "island";
    case Connectivity::kIndex: return "index";
    case Connectivity::kPosition: break;
  }
  return "position";
}

ExtractedPatches extract_patches(const HairMesh& mesh, std::span<const std::uint32_t> welded,
                                 Connectivity connectivity) {
  std::vector<std::uint32_t> identity(mesh.positions.size());
  std::iota(identity.begin(), identity.end(), 0u);
  PatchSet by_index = group_by_corners(mesh, identity);
  PatchSet by_position = group_by_corners(mesh, welded);
  PatchSet by_island = group_by_islands(mesh, welded);

  ExtractedPatches result;
  result.by_index = by_index.count;
  result.by_position = by_position.count;
  result.by_island = by_island.count;
  result.chosen = connectivity;
  result.reason = fmt::format("by {}: the recipe says so", word_of(connectivity));
  if (connectivity == Connectivity::kAuto) choose(mesh, mesh.uvs.empty() ? by_index : by_island, by_position, result);
  result.patches = std::move(result.chosen == Connectivity::kPosition ? by_position
                             : result.chosen == Connectivity::kIndex  ? by_index
                                                                      : by_island);
  return result;
}

ExtractedPatches find_patches(HairStrips& hair, Connectivity connectivity, Findings& findings) {
  ExtractedPatches extracted = extract_patches(hair.mesh, hair.welded, connectivity);
  hair.patches = extracted.patches;
  hair.separate_patches();
  findings.note(fmt::format("patches {}", extracted.reason));
  return extracted;
}

void warn_of_odd_size(const HairMesh& hair, Findings& findings) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& at : hair.positions) box.extend(at);
  if (is_hair_sized(largest_side(box))) return;
  findings.warn(
      "S205",
      fmt::format("the hair is {:.3g} m large; hair has 0.05 .. 3 m: set \"source.metres_per_unit\" in the recipe",
                  largest_side(box)));
}

void warn_of_fragments(const HairMesh& hair, std::size_t patches, Connectivity by, Findings& findings) {
  if (!is_shattered(hair.triangle_count(), patches)) return;
  findings.warn("S206", fmt::format("{} triangles fall into {} patches by {}; set \"patches.connectivity\" to "
                                    "\"position\" or \"index\" in the recipe",
                                    hair.triangle_count(), patches, word_of(by)));
}

}  // namespace coif::cook
