#include "cook/patch_view.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace coif {

std::vector<PatchView> view_patches(const HairMesh& mesh, const PatchSet& patches) {
  std::vector<PatchView> views(patches.count);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) views[patches.patch_of[t]].triangles.push_back(3 * t);
  for (PatchView& view : views) {
    for (std::size_t t : view.triangles) {
      for (std::size_t k = 0; k < 3; ++k) view.vertices.push_back(mesh.triangles[t + k]);
    }
    std::ranges::sort(view.vertices);
    view.vertices.erase(std::ranges::unique(view.vertices).begin(), view.vertices.end());
  }
  return views;
}

float doubled_area(const HairMesh& mesh, std::size_t t) {
  const Eigen::Vector3f& a = mesh.positions[mesh.triangles[t]];
  return (mesh.positions[mesh.triangles[t + 1]] - a).cross(mesh.positions[mesh.triangles[t + 2]] - a).norm();
}

}  // namespace coif
