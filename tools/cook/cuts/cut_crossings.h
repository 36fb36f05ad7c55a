#pragma once

#include "cook/cuts/seen_crossings.h"
#include "cook/cuts/split_mesh.h"

#include <cstddef>
#include <span>

namespace coif::cook {

struct CutSettings {
  std::size_t most_added = 0;  ///< Triangles.
  float shortest_edge =
      0;  ///< Metres: no edge is cut nearer to its ends, since views have to see each piece to place it.
  double least_gain = 0;  ///< Weight of samples that each triangle added must put right.
};

struct CutResult {
  std::size_t cuts = 0;   ///< Lines that triangles were cut along.
  std::size_t added = 0;  ///< Triangles.
  double gained = 0;      ///< Of SeenCrossings::unavoidable: what is so no longer.
};

/// Cuts triangles in two or three where they cross others as far as pictures show it, the cuts first that put most
/// right for each triangle they add: along the other one's plane, or only from a corner to where that plane meets an
/// edge, which adds half as many. The numbers of triangles in the samples are those of the mesh. The same for the same
/// samples.
CutResult cut_crossings(const SeenCrossings& crossings, const CutSettings& settings, SplitMesh& mesh);

}  // namespace coif::cook
