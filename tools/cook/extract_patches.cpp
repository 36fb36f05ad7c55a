#include "cook/extract_patches.h"

#include "cook/disjoint_sets.h"
#include "cook/weld.h"

#include <numeric>

namespace coif {
namespace {

/// Groups triangles whose corners share an id; `id_of` maps vertices to ids below the vertex count.
PatchSet group_triangles(const HairMesh& mesh, std::span<const std::uint32_t> id_of) {
  DisjointSets sets(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    sets.unite(id_of[mesh.triangles[t]], id_of[mesh.triangles[t + 1]]);
    sets.unite(id_of[mesh.triangles[t]], id_of[mesh.triangles[t + 2]]);
  }
  PatchSet result;
  std::vector<std::uint32_t> number(mesh.positions.size(), kNoIndex);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    std::uint32_t& patch = number[sets.find(id_of[mesh.triangles[t]])];
    if (patch == kNoIndex) patch = result.count++;
    result.patch_of.push_back(patch);
  }
  return result;
}

constexpr double kShatteredTriangles = 8;  ///< Fewer per group on average is an exporter's work, not an artist's.

bool is_shattered(const HairMesh& mesh, const PatchSet& by_index, const PatchSet& by_position) {
  return by_index.count > by_position.count &&
         double(mesh.triangle_count()) < kShatteredTriangles * double(by_index.count);
}

}  // namespace

ExtractedPatches extract_patches(const HairMesh& mesh, const ExtractSettings& settings) {
  std::vector<std::uint32_t> identity(mesh.positions.size());
  std::iota(identity.begin(), identity.end(), 0u);
  PatchSet by_index = group_triangles(mesh, identity);
  PatchSet by_position = group_triangles(mesh, weld_places(mesh.positions, settings.weld_distance));

  ExtractedPatches result;
  result.by_index = by_index.count;
  result.by_position = by_position.count;
  result.chose_position = settings.connectivity == "position" ||
                          (settings.connectivity == "auto" && is_shattered(mesh, by_index, by_position));
  result.patches = std::move(result.chose_position ? by_position : by_index);
  return result;
}

}  // namespace coif
