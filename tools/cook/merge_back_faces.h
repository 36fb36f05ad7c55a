#pragma once

#include "cook/hair_mesh.h"

#include <cstddef>

namespace coif {

struct MergedFaces {
  std::size_t back_faces = 0;  ///< Triangles that only showed another one from behind.
  std::size_t copies = 0;      ///< Triangles that were there twice.
};

/// Keeps one of the triangles between the same three places, `place` of each vertex: modellers without two-sided
/// materials copy every strip and turn the copy round, which costs twice the triangles and sorts against itself. Where
/// any was merged the mesh is marked double-sided.
MergedFaces merge_back_faces(HairMesh& mesh, std::span<const std::uint32_t> place);

/// True where nearly all triangles are part of closed surfaces, whose back faces nobody sees.
[[nodiscard]] bool is_closed(const HairMesh& mesh, std::span<const std::uint32_t> place);

}  // namespace coif
