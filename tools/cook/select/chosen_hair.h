#pragma once

#include "cook/select/select_hair.h"

#include <Eigen/Geometry>

#include <vector>

namespace coif {

/// The triangles that a choice takes, as one mesh of three vertices each.
struct ChosenHair {
  std::vector<Eigen::Vector3f> positions;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> group;  ///< All 0: for TriangleGrid.
  Eigen::AlignedBox3f box;

  ChosenHair(const SourceModel& source, const HairChoice& choice) {
    for (std::size_t m = 0; m < source.meshes.size(); ++m) {
      const SourceMesh& mesh = source.meshes[m];
      for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (!choice.takes(m, i / 3)) continue;
        triangles.push_back(std::uint32_t(positions.size()));
        positions.push_back(mesh.positions[mesh.triangles[i]]);
        box.extend(positions.back());
      }
    }
    group.assign(triangles.size() / 3, 0);
  }
};

}  // namespace coif
