#pragma once

#include "cook/select/hair_mesh.h"

#include <span>
#include <string>
#include <vector>

namespace coif {

/// What belongs to one patch.
struct PatchView {
  std::vector<std::size_t> triangles;   ///< First index of each.
  std::vector<std::uint32_t> vertices;  ///< Ascending, each once.
};

/// Every patch's triangles and vertices.
[[nodiscard]] std::vector<PatchView> view_patches(const HairMesh& mesh, const PatchSet& patches);

/// Twice the area of the triangle whose first index is at `t`, square metres.
[[nodiscard]] float doubled_area(const HairMesh& mesh, std::size_t t);

struct ExtractedPatches {
  PatchSet patches;
  std::uint32_t by_index = 0;     ///< Groups of triangles that share vertices.
  std::uint32_t by_position = 0;  ///< Groups of triangles that share places.
  std::uint32_t by_island = 0;    ///< Groups of triangles that share an edge and its texture coordinates.
  std::string chosen;             ///< "index", "position" or "island".
  std::string reason;             ///< Why, for the report.
};

/// Algorithm 2 of the thesis, connected triangles are one patch, by union-find: near-linear where the published form
/// compares each triangle with each group. What counts as connected is `connectivity`:
///  - "index": shared vertices, as published. Exporters split vertices at hard edges and seams, so this may shatter.
///  - "position": shared places. Strips whose roots touch, or that lie on each other, become one.
///  - "island": a shared edge with the same texture coordinates at both ends, whatever its normals. A strip is unwrapped
///    in one piece, and two strips that touch are not.
///  - "auto": islands (indices without texture coordinates), unless more than a quarter of the triangles are then in
///    fragments of fewer than 8 whose place has more: such a file is unwrapped face by face, and positions decide.
/// `place` of each vertex from weld_places().
[[nodiscard]] ExtractedPatches extract_patches(const HairMesh& mesh, std::span<const std::uint32_t> place,
                                               const std::string& connectivity);

/// Gives each patch its own vertices: copies those that several share. Returns, for each vertex appended, which it equals.
std::vector<std::uint32_t> separate_patches(HairMesh& mesh, const PatchSet& patches);

/// Fills in normals that are missing or not unit: the mean of the faces around a place, weighted by area, as far as they
/// look the same way as the vertex's own faces (a strip's two sides share places). `place` of each vertex from
/// weld_places(). Returns how many were filled in.
std::size_t complete_normals(HairMesh& mesh, std::span<const std::uint32_t> place);

}  // namespace coif
