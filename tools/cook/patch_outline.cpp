#include "cook/patch_outline.h"

#include "cook/mesh_edges.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace coif {
namespace {

constexpr double kCornerTurn = 50 * std::numbers::pi / 180;

std::vector<EdgeUse> edges_by_point(const PatchSurface& surface) {
  std::vector<std::uint32_t> corners, same(surface.points());
  for (const auto& triangle : surface.triangles)
    corners.insert(corners.end(), triangle.point.begin(), triangle.point.end());
  std::iota(same.begin(), same.end(), 0u);
  return sorted_edges(corners, same);
}

/// The border's directions at its points: the turn between the one that comes and the one that goes.
void fix_corners(const PatchSurface& surface, PatchOutline& outline) {
  std::vector<Eigen::Vector3d> arriving(surface.points(), Eigen::Vector3d::Zero()), leaving = arriving;
  std::vector<int> starts(surface.points(), 0), ends = starts;
  for (const PatchOutline::Edge& edge : outline.edges) {
    const Eigen::Vector3d along = (surface.at(0, edge.b) - surface.at(0, edge.a)).normalized();
    leaving[edge.a] = along;
    arriving[edge.b] = along;
    ++starts[edge.a];
    ++ends[edge.b];
  }
  for (std::uint32_t p = 0; p < surface.points(); ++p) {
    if (!outline.on_border[p]) continue;
    const bool simple = starts[p] == 1 && ends[p] == 1;
    if (!simple || arriving[p].dot(leaving[p]) < std::cos(kCornerTurn)) outline.fixed[p] = true;
  }
}

}  // namespace

PatchOutline find_outline(const PatchSurface& surface) {
  PatchOutline outline;
  outline.on_border.assign(surface.points(), false);
  outline.fixed.assign(surface.points(), false);
  for_each_edge(edges_by_point(surface), [&](std::span<const EdgeUse> uses) {
    const auto& points = surface.triangles[uses[0].triangle].point;
    const std::uint32_t a = points[uses[0].side], b = points[(uses[0].side + 1) % 3];
    if (uses.size() > 2) outline.fixed[a] = outline.fixed[b] = true;
    if (uses.size() != 1) return;
    outline.on_border[a] = outline.on_border[b] = true;
    outline.edges.push_back({a, b, uses[0].triangle});
  });
  fix_corners(surface, outline);
  return outline;
}

}  // namespace coif
