#pragma once

#include "cook/select/select_hair.h"

#include <Eigen/Geometry>

#include <vector>

namespace coif::cook {

/// Triangles out of several meshes, three vertices each.
struct TriangleSoup {
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> triangles;
  Eigen::AlignedBox3f box;

  void add(const importer::SourceMesh& mesh, std::size_t triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      triangles.push_back(std::uint32_t(positions.size()));
      positions.push_back(mesh.positions[mesh.triangles[3 * triangle + k]]);
      box.extend(positions.back());
    }
  }
};

/// What a choice takes.
[[nodiscard]] inline TriangleSoup chosen_hair(const importer::SourceModel& source, const HairChoice& choice) {
  TriangleSoup hair;
  for (std::size_t m = 0; m < source.meshes.size(); ++m) {
    for (std::size_t t = 0; t < source.meshes[m].triangles.size() / 3; ++t) {
      if (choice.takes(m, t)) hair.add(source.meshes[m], t);
    }
  }
  return hair;
}

}  // namespace coif::cook
