#pragma once

#include "cook/select/hair_evidence.h"
#include "cook/select/mesh_topology.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

namespace coif::cook {

/// One island of a mesh: triangles that hang together in its surface and its texture.
struct SurfaceIsland {
  std::uint32_t mesh = 0;
  std::uint32_t piece = 0;  ///< Pieces hang together in the surface alone.
  PieceEvidence evidence;
  Eigen::AlignedBox3d box;
  double area = 0;
  Eigen::AlignedBox2f cell;  ///< Box in the texture.
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  bool has_color = true;
};

/// The islands of all meshes of a model, one mesh after the other.
struct SurfaceIslands {
  std::vector<SurfaceIsland> list;
  std::vector<MeshPieces> of_mesh;   ///< Per mesh: the island of each triangle, from 0 on.
  std::vector<std::uint32_t> first;  ///< Per mesh: the number in `list` of its island 0.
};

/// `head`: the head's node, or kNoIndex. `only_on_head`: cells and colours are those of islands on it alone.
[[nodiscard]] SurfaceIslands find_surface_islands(const importer::SourceModel& source, std::uint32_t head,
                                                  bool only_on_head, double weld_distance);

}  // namespace coif::cook
