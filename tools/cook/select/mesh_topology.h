#pragma once

#include "cook/select/hair_mesh.h"
#include "import/source_model.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace coif::cook {

/// Union-find with path halving and union by size: near-linear in the number of calls.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count), size_(count, 1) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::uint32_t find(std::uint32_t item) {
    while (parent_[item] != item) {
      parent_[item] = parent_[parent_[item]];
      item = parent_[item];
    }
    return item;
  }

  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> size_;
};

/// One side of one triangle.
struct EdgeUse {
  std::uint64_t edge = 0;      ///< The ids of both ends, the same for every triangle along it.
  std::uint32_t triangle = 0;  ///< Its number, not its first index.
  std::uint32_t side = 0;      ///< From corner `side` to the next, 0..2.
};

/// All sides of all triangles; those of one edge lie together, in the order of the triangles. `id_of` maps vertices to
/// ids: themselves, or places. Sides whose ends have one id are left out.
[[nodiscard]] inline std::vector<EdgeUse> sorted_edges(std::span<const std::uint32_t> triangles,
                                                       std::span<const std::uint32_t> id_of) {
  std::vector<EdgeUse> uses;
  uses.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t first = i / 3 * 3, side = i % 3;
    const std::uint32_t a = id_of[triangles[i]], b = id_of[triangles[first + (side + 1) % 3]];
    if (a == b) continue;
    uses.push_back({std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), std::uint32_t(i / 3), std::uint32_t(side)});
  }
  std::ranges::stable_sort(uses, {}, &EdgeUse::edge);
  return uses;
}

/// Calls `visit` with the uses of each edge.
template <typename Visit>
void for_each_edge(std::span<const EdgeUse> uses, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].edge == uses[begin].edge) ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

/// Connected pieces of one source mesh: triangles that share places, since exporters split vertices freely.
struct MeshPieces {
  std::vector<std::uint32_t> piece_of;  ///< For each triangle, numbered by first appearance.
  std::uint32_t count = 0;
};

[[nodiscard]] MeshPieces find_pieces(const importer::SourceMesh& mesh, double weld_distance);

/// Pieces of triangles that share places and, if the mesh has them, texture coordinates.
[[nodiscard]] MeshPieces find_islands(const importer::SourceMesh& mesh, double weld_distance);

/// For each vertex the smallest vertex at its place: closer than `distance` metres along a chain of neighbours. 0: a
/// 50,000th of the diagonal of all positions, so that a model's size does not decide what is joined. Linear time,
/// unless all vertices are within one spot of that size.
[[nodiscard]] std::vector<std::uint32_t> weld_places(std::span<const Eigen::Vector3f> positions, double distance);

/// Makes vertices that agree in every attribute one, in order of first use, and drops unused ones. Importers write
/// three vertices per triangle; only after this do indices show what the artist joined.
void weld_vertices(HairMesh& mesh);

struct MergedFaces {
  std::size_t back_faces = 0;  ///< Triangles that only showed another one from behind.
  std::size_t copies = 0;      ///< Triangles that were there twice.
};

/// Keeps one of the triangles between the same three places; `place` is per vertex. Modellers without two-sided
/// materials copy every strip and turn the copy round, which doubles the triangles and cannot be sorted. If any were
/// merged, the mesh is marked double-sided.
MergedFaces merge_back_faces(HairMesh& mesh, std::span<const std::uint32_t> place);

/// True where nearly all triangles belong to closed surfaces, whose back faces nobody sees.
[[nodiscard]] bool is_closed(const HairMesh& mesh, std::span<const std::uint32_t> place);

}  // namespace coif::cook
