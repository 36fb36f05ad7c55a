#include "cook/lods/collapse_patch.h"
#include "cook/select/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::cook {
namespace {

std::vector<std::uint32_t> points_of_corners(const PatchSurface& surface) {
  std::vector<std::uint32_t> point(surface.vertex_of_corner.size(), 0);
  for (const PatchSurface::Triangle& triangle : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) point[triangle.corner[k]] = triangle.point[k];
  }
  return point;
}

bool has_area(const std::array<std::uint32_t, 3>& points) {
  return points[0] != points[1] && points[1] != points[2] && points[2] != points[0];
}

/// Finds the nearest part of a coarse patch to a point of the fine one.
class CoarsePatch {
 public:
  CoarsePatch(const PatchSurface& surface, const CollapseSequence& sequence, std::size_t steps)
      : surface_(surface), becomes_(surface.points()), around_(surface.points()) {
    const std::vector<std::uint32_t> now = collapsed_corners(surface, sequence, steps);
    const std::vector<std::uint32_t> point_of = points_of_corners(surface);
    for (const PatchSurface::Triangle& triangle : surface.triangles) {
      Points points{};
      for (std::size_t k = 0; k < 3; ++k) {
        points[k] = point_of[now[triangle.corner[k]]];
        becomes_[triangle.point[k]] = points[k];
      }
      if (!has_area(points)) continue;
      for (std::uint32_t p : points) around_[p].push_back(points);
    }
  }

  /// Searches from the triangles around the point that it has collapsed into, on to their neighbours as long as these
  /// are nearer; may stop at any value below `enough`. 0 for points that are in no triangle.
  [[nodiscard]] double squared_distance_of(std::uint32_t point, std::size_t pose, double enough) const {
    if (becomes_[point] == point || around_[becomes_[point]].empty()) return 0;
    double nearest = INFINITY;
    Points best{becomes_[point], becomes_[point], becomes_[point]};
    for (bool nearer = true; nearer && nearest > enough;) {
      nearer = false;
      const Points from = best;
      for (std::uint32_t p : from) {
        for (const Points& triangle : around_[p]) {
          const double distance = squared_distance(surface_.at(pose, point), surface_.at(pose, triangle[0]),
                                                   surface_.at(pose, triangle[1]), surface_.at(pose, triangle[2]));
          if (distance >= nearest) continue;
          nearest = distance;
          best = triangle;
          nearer = true;
        }
      }
    }
    return nearest;
  }

 private:
  using Points = std::array<std::uint32_t, 3>;

  const PatchSurface& surface_;
  std::vector<std::uint32_t> becomes_;       ///< Per point, where it has gone.
  std::vector<std::vector<Points>> around_;  ///< Per point, the triangles that are left.
};

}  // namespace

std::vector<std::uint32_t> collapsed_corners(const PatchSurface& surface, const CollapseSequence& sequence,
                                             std::size_t steps) {
  std::vector<std::uint32_t> now(surface.vertex_of_corner.size());
  std::iota(now.begin(), now.end(), 0u);
  // Backwards, so that a corner's target is known before the corners that went into it.
  for (std::size_t m = steps == 0 ? 0 : sequence.steps[steps - 1].moves_end; m-- > 0;) {
    now[sequence.moves[m].from] = now[sequence.moves[m].to];
  }
  return now;
}

std::vector<std::uint32_t> collapsed_triangles(const PatchSurface& surface, const CollapseSequence& sequence,
                                               std::size_t steps, std::span<const std::uint32_t> originals) {
  const std::vector<std::uint32_t> now = collapsed_corners(surface, sequence, steps);
  const std::vector<std::uint32_t> point_of = points_of_corners(surface);
  std::vector<std::uint32_t> triangles;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> vertex{}, point{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = surface.triangles[t].corner[k];
      vertex[k] = now[corner] == corner ? originals[3 * t + k] : surface.vertex_of_corner[now[corner]];
      point[k] = point_of[now[corner]];
    }
    if (has_area(point)) triangles.insert(triangles.end(), vertex.begin(), vertex.end());
  }
  return triangles;
}

double collapsed_error(const PatchSurface& surface, const CollapseSequence& sequence, std::size_t steps) {
  if (steps == 0) return 0;
  const CoarsePatch coarse(surface, sequence, steps);
  double worst = 0;
  for (std::uint32_t p = 0; p < surface.points(); ++p) {
    for (std::size_t pose = 0; pose < surface.poses; ++pose) {
      worst = std::max(worst, coarse.squared_distance_of(p, pose, worst));
    }
  }
  return std::sqrt(worst);
}

}  // namespace coif::cook
