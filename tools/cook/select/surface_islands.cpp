#include "cook/select/hair_evidence.h"

namespace coif::cook {
namespace {

using Eigen::Vector3f;
using importer::SourceMesh, importer::SourceModel;

void add_triangle(const SourceModel& source, const SourceMesh& mesh, std::size_t t, bool is_seen,
                  SurfaceIsland& island) {
  Vector3f corner[3];
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k] = mesh.positions[mesh.triangles[3 * t + k]];
    island.box.extend(corner[k].cast<double>());
  }
  if (!is_seen) return;
  for (std::size_t k = 0; k < 3 && !mesh.uvs.empty(); ++k) island.cell.extend(mesh.uvs[mesh.triangles[3 * t + k]]);
  const double area = 0.5 * double((corner[1] - corner[0]).cross(corner[2] - corner[0]).norm());
  const auto color = color_without_texture(source, mesh, t);
  island.has_color = island.has_color && color;
  if (color) island.color += float(area) * *color;
  island.area += area;
}

}  // namespace

SurfaceIslands find_surface_islands(const SourceModel& source, std::uint32_t head, bool only_on_head,
                                    double weld_distance) {
  const std::vector<bool> bones = find_hair_bones(source);
  SurfaceIslands found;
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    const auto first = std::uint32_t(found.list.size());
    const MeshPieces islands = find_islands(mesh, weld_distance), pieces = find_pieces(mesh, weld_distance);
    for (const PieceEvidence& evidence : weigh_pieces(source, mesh, islands, bones, head)) {
      SurfaceIsland& island = found.list.emplace_back();
      island.mesh = m;
      island.evidence = evidence;
    }
    for (std::size_t t = 0; t < islands.piece_of.size(); ++t) {
      SurfaceIsland& island = found.list[first + islands.piece_of[t]];
      island.piece = pieces.piece_of[t];
      add_triangle(source, mesh, t, !only_on_head || island.evidence.head_share >= kOnHead, island);
    }
    for (std::uint32_t i = first; i < found.list.size(); ++i) {
      SurfaceIsland& island = found.list[i];
      island.has_color = island.has_color && island.area > 0;
      if (island.has_color) island.color /= float(island.area);
    }
    found.first.push_back(first);
    found.of_mesh.push_back(islands);
  }
  return found;
}

}  // namespace coif::cook
