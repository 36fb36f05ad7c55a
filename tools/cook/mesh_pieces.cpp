#include "cook/mesh_pieces.h"

#include "cook/disjoint_sets.h"
#include "cook/weld.h"

namespace coif {

MeshPieces find_pieces(const SourceMesh& mesh, double weld_distance) {
  const std::vector<std::uint32_t> place = weld_places(mesh.positions, weld_distance);
  DisjointSets sets(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    sets.unite(place[mesh.triangles[t]], place[mesh.triangles[t + 1]]);
    sets.unite(place[mesh.triangles[t]], place[mesh.triangles[t + 2]]);
  }
  MeshPieces pieces;
  std::vector<std::uint32_t> number(mesh.positions.size(), kNoIndex);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    std::uint32_t& piece = number[sets.find(place[mesh.triangles[t]])];
    if (piece == kNoIndex) piece = pieces.count++;
    pieces.piece_of.push_back(piece);
  }
  return pieces;
}

}  // namespace coif
