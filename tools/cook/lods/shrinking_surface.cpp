#include "cook/lods/collapse_patch.h"
#include "cook/lods/patch_surface.h"

#include <algorithm>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

/// A triangle may turn by less than about 75 degrees in one step.
constexpr double kSmallestCosine = 0.25;

bool has(const PatchSurface::Triangle& triangle, std::uint32_t point) {
  return triangle.point[0] == point || triangle.point[1] == point || triangle.point[2] == point;
}

std::size_t side_of(const PatchSurface::Triangle& triangle, std::uint32_t point) {
  return triangle.point[0] == point ? 0 : triangle.point[1] == point ? 1 : 2;
}

}  // namespace

ShrinkingSurface::ShrinkingSurface(const PatchSurface& surface)
    : surface_(surface), triangles_(surface.triangles), triangles_of_(surface.points()), mark_(surface.points(), 0) {
  PatchOutline outline = find_outline(surface);
  on_border_ = std::move(outline.on_border);
  fixed_ = std::move(outline.fixed);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const auto& [a, b, c] = triangles_[t].point;
    if (a == b || b == c || c == a) continue;
    for (std::uint32_t point : triangles_[t].point) triangles_of_[point].push_back(t);
    ++left_;
  }
}

std::span<const std::uint32_t> ShrinkingSurface::neighbours(std::uint32_t point) {
  neighbours_.clear();
  ++last_mark_;
  mark_[point] = last_mark_;
  for (std::uint32_t t : triangles_of_[point]) {
    for (std::uint32_t other : triangles_[t].point) {
      if (mark_[other] == last_mark_) continue;
      mark_[other] = last_mark_;
      neighbours_.push_back(other);
    }
  }
  return neighbours_;
}

bool ShrinkingSurface::may_collapse(std::uint32_t from, std::uint32_t to) {
  return !fixed_[from] && keeps_topology(from, to) && keeps_facing(from, to) && find_moves(from, to);
}

/// The link condition: the common neighbours of both ends are exactly the third points of the triangles that vanish.
bool ShrinkingSurface::keeps_topology(std::uint32_t from, std::uint32_t to) {
  std::size_t dying = 0;
  for (std::uint32_t t : triangles_of_[from]) {
    if (!has(triangles_[t], to)) continue;
    ++dying;
    for (std::uint32_t third : triangles_[t].point) {
      if (third != from && third != to && triangles_of_[third].size() == 1) return false;
    }
  }
  if (dying == triangles_of_[from].size() || dying > 2 || (on_border_[from] && dying != 1)) return false;
  (void)neighbours(from);
  const std::uint32_t beside_from = last_mark_, counted = ++last_mark_;
  std::size_t both = 0;
  for (std::uint32_t t : triangles_of_[to]) {
    for (std::uint32_t point : triangles_[t].point) {
      if (point == from || point == to || mark_[point] != beside_from) continue;
      mark_[point] = counted;
      ++both;
    }
  }
  return both == dying;
}

bool ShrinkingSurface::keeps_facing(std::uint32_t from, std::uint32_t to) const {
  for (std::uint32_t t : triangles_of_[from]) {
    if (has(triangles_[t], to)) continue;
    const std::size_t side = side_of(triangles_[t], from);
    const Vector3d& b = surface_.at(0, triangles_[t].point[(side + 1) % 3]);
    const Vector3d& c = surface_.at(0, triangles_[t].point[(side + 2) % 3]);
    const Vector3d before = (b - surface_.at(0, from)).cross(c - surface_.at(0, from));
    const Vector3d after = (b - surface_.at(0, to)).cross(c - surface_.at(0, to));
    const double lengths = before.norm() * after.norm();
    const bool had_no_area = lengths == 0 && after.squaredNorm() > 0;
    if (!had_no_area && !(before.dot(after) > kSmallestCosine * lengths)) return false;
  }
  return true;
}

/// Finds the corner of `to` that continues each corner of `from`: the one on the same side of a texture seam, by a
/// triangle that vanishes. False where no triangle shows it.
bool ShrinkingSurface::find_moves(std::uint32_t from, std::uint32_t to) {
  moves_.clear();
  for (std::uint32_t t : triangles_of_[from]) {
    const Triangle& triangle = triangles_[t];
    if (!has(triangle, to)) continue;
    const CornerMove move{triangle.corner[side_of(triangle, from)], triangle.corner[side_of(triangle, to)]};
    const std::uint32_t known = moved_corner(move.from);
    if (known != importer::kNoIndex && known != move.to) return false;
    if (known == importer::kNoIndex) moves_.push_back(move);
  }
  return std::ranges::all_of(triangles_of_[from], [&](std::uint32_t t) {
    return moved_corner(triangles_[t].corner[side_of(triangles_[t], from)]) != importer::kNoIndex;
  });
}

std::uint32_t ShrinkingSurface::moved_corner(std::uint32_t corner) const {
  const auto move = std::ranges::find(moves_, corner, &CornerMove::from);
  return move == moves_.end() ? importer::kNoIndex : move->to;
}

std::span<const ShrinkingSurface::Points> ShrinkingSurface::star_after(std::uint32_t from, std::uint32_t to) {
  star_.clear();
  for (std::uint32_t t : triangles_of_[from]) {
    if (has(triangles_[t], to)) continue;
    star_.push_back(triangles_[t].point);
    star_.back()[side_of(triangles_[t], from)] = to;
  }
  for (std::uint32_t t : triangles_of_[to]) {
    if (!has(triangles_[t], from)) star_.push_back(triangles_[t].point);
  }
  return star_;
}

void ShrinkingSurface::collapse(std::uint32_t from, std::uint32_t to, std::vector<CornerMove>& moves) {
  for (std::uint32_t t : triangles_of_[from]) {
    Triangle& triangle = triangles_[t];
    if (has(triangle, to)) {
      for (std::uint32_t point : triangle.point) {
        if (point != from) std::erase(triangles_of_[point], t);
      }
      --left_;
      continue;
    }
    const std::size_t side = side_of(triangle, from);
    triangle.point[side] = to;
    triangle.corner[side] = moved_corner(triangle.corner[side]);
    triangles_of_[to].push_back(t);
  }
  triangles_of_[from].clear();
  moves.insert(moves.end(), moves_.begin(), moves_.end());
}

}  // namespace coif::cook
