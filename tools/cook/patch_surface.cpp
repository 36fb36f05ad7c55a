#include "cook/patch_surface.h"

#include <algorithm>
#include <numeric>

namespace coif {
namespace {

/// For each of the patch's vertices (by its position in PatchView::vertices) its point and its corner.
struct Numbering {
  std::vector<std::uint32_t> point, corner;
  std::vector<std::uint32_t> vertex_of_point, vertex_of_corner;
};

Numbering number_vertices(const HairMesh& mesh, std::span<const std::uint32_t> place, const PatchView& view) {
  const auto uv = [&](std::uint32_t v) {
    return mesh.uvs.empty() ? std::pair(0.0f, 0.0f) : std::pair(mesh.uvs[v].x(), mesh.uvs[v].y());
  };
  const auto key = [&](std::uint32_t i) { return std::pair(place[view.vertices[i]], uv(view.vertices[i])); };
  std::vector<std::uint32_t> order(view.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, key);
  Numbering numbering;
  numbering.point.resize(order.size());
  numbering.corner.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::uint32_t i = order[k], v = view.vertices[i];
    const bool new_point = k == 0 || place[v] != place[view.vertices[order[k - 1]]];
    const bool new_corner = new_point || uv(v) != uv(view.vertices[order[k - 1]]);
    if (new_point) numbering.vertex_of_point.push_back(v);
    if (new_corner) numbering.vertex_of_corner.push_back(v);
    numbering.point[i] = std::uint32_t(numbering.vertex_of_point.size() - 1);
    numbering.corner[i] = std::uint32_t(numbering.vertex_of_corner.size() - 1);
  }
  return numbering;
}

}  // namespace

PatchSurface make_patch_surface(const HairMesh& mesh, std::span<const std::uint32_t> place, const PatchView& view,
                                std::span<const Pose> poses) {
  const Numbering numbering = number_vertices(mesh, place, view);
  PatchSurface surface;
  surface.poses = poses.size();
  surface.vertex_of_corner = numbering.vertex_of_corner;
  for (const Pose& pose : poses) {
    for (std::uint32_t v : numbering.vertex_of_point) surface.positions.push_back(pose[v].cast<double>());
  }
  surface.triangles.resize(view.triangles.size());
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangles[view.triangles[t] + k];
      const auto i = std::size_t(std::ranges::lower_bound(view.vertices, vertex) - view.vertices.begin());
      surface.triangles[t].point[k] = numbering.point[i];
      surface.triangles[t].corner[k] = numbering.corner[i];
    }
  }
  return surface;
}

}  // namespace coif
