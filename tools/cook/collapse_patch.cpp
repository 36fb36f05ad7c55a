#include "cook/collapse_patch.h"

#include "cook/patch_outline.h"
#include "cook/surface_quadric.h"
#include "cook/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

namespace coif {
namespace {

using Eigen::Vector3d;

/// Weight of the planes that hold the outline, against those of the surface: silhouettes are what is seen of strips.
constexpr double kOutlineWeight = 4;
/// A triangle may turn by less than about 75 degrees in one step.
constexpr double kSmallestCosine = 0.25;

struct Candidate {
  double cost = 0;
  std::uint32_t from = 0, to = 0;
  std::uint32_t version = 0;  ///< Of `from` when it was weighed; an older one is out of date.

  bool operator<(const Candidate& other) const {  // std::priority_queue hands out the largest
    return std::pair(cost, from) > std::pair(other.cost, other.from);
  }
};

class Collapser {
 public:
  Collapser(const PatchSurface& surface, const CollapseLimits& limits);
  CollapseSequence run();

 private:
  using Triangle = PatchSurface::Triangle;

  void add_planes(const PatchOutline& outline);
  void weigh(std::uint32_t from);
  /// Both ends' quadrics at `to`, over all poses.
  [[nodiscard]] double cost(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] bool fits(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] bool keeps_topology(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] bool keeps_facing(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] bool find_corner_moves(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] double measure(std::uint32_t from, std::uint32_t to);
  void collapse(std::uint32_t from, std::uint32_t to, double error);
  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t point) const;

  const PatchSurface& surface_;
  CollapseLimits limits_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::uint32_t>> triangles_of_;  ///< Per point; those that are left.
  std::vector<std::vector<std::uint32_t>> gone_into_;     ///< Per point; points that were collapsed into it.
  std::vector<bool> on_border_, fixed_;
  std::vector<SurfaceQuadric> quadrics_;  ///< Per pose and point, as PatchSurface::positions.
  std::vector<std::uint32_t> version_;
  std::priority_queue<Candidate> queue_;
  std::uint32_t left_ = 0;
  double error_ = 0;
  CollapseSequence sequence_;
  // Of the candidate in hand.
  std::vector<std::array<std::uint32_t, 3>> star_;
  std::vector<CollapseSequence::Move> moves_;
};

bool has(const PatchSurface::Triangle& triangle, std::uint32_t point) {
  return std::ranges::find(triangle.point, point) != triangle.point.end();
}

std::size_t side_of(const PatchSurface::Triangle& triangle, std::uint32_t point) {
  return std::size_t(std::ranges::find(triangle.point, point) - triangle.point.begin());
}

Collapser::Collapser(const PatchSurface& surface, const CollapseLimits& limits)
    : surface_(surface),
      limits_(limits),
      triangles_(surface.triangles),
      triangles_of_(surface.points()),
      gone_into_(surface.points()),
      quadrics_(surface.positions.size()),
      version_(surface.points(), 0) {
  const PatchOutline outline = find_outline(surface);
  on_border_ = outline.on_border;
  fixed_ = outline.fixed;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const auto& [a, b, c] = triangles_[t].point;
    if (a == b || b == c || c == a) continue;  // Shows nothing; no coarser level has it.
    for (std::uint32_t point : triangles_[t].point) triangles_of_[point].push_back(t);
    ++left_;
  }
  add_planes(outline);
}

void Collapser::add_planes(const PatchOutline& outline) {
  const std::size_t points = surface_.points();
  const auto doubled_normal = [&](std::size_t pose, std::uint32_t t) -> Vector3d {
    const auto& [a, b, c] = triangles_[t].point;
    const Vector3d& origin = surface_.at(pose, a);
    return (surface_.at(pose, b) - origin).cross(surface_.at(pose, c) - origin);
  };
  for (std::size_t pose = 0; pose < surface_.poses; ++pose) {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const Vector3d normal = doubled_normal(pose, t);
      const double area = normal.norm();
      if (!(area > 0)) continue;
      for (std::uint32_t p : triangles_[t].point) {
        quadrics_[pose * points + p].add_plane(normal / area, surface_.at(pose, p), area);
      }
    }
    for (const PatchOutline::Edge& edge : outline.edges) {
      const Vector3d along = surface_.at(pose, edge.b) - surface_.at(pose, edge.a);
      const Vector3d out = along.cross(doubled_normal(pose, edge.triangle));
      if (!(out.norm() > 0)) continue;
      for (std::uint32_t p : {edge.a, edge.b}) {
        quadrics_[pose * points + p].add_plane(out.normalized(), surface_.at(pose, p),
                                               kOutlineWeight * along.squaredNorm());
      }
    }
  }
}

std::vector<std::uint32_t> Collapser::neighbours(std::uint32_t point) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t t : triangles_of_[point]) {
    for (std::uint32_t other : triangles_[t].point) {
      if (other != point) found.push_back(other);
    }
  }
  std::ranges::sort(found);
  found.erase(std::ranges::unique(found).begin(), found.end());
  return found;
}

double Collapser::cost(std::uint32_t from, std::uint32_t to) const {
  double sum = 0;
  for (std::size_t pose = 0; pose < surface_.poses; ++pose) {
    const Vector3d& target = surface_.at(pose, to);
    const std::size_t first = pose * surface_.points();
    sum += quadrics_[first + from].at(target) + quadrics_[first + to].at(target);
  }
  return std::max(sum, 0.0);
}

/// Puts the cheapest way to remove `from` into the queue, if there is one.
void Collapser::weigh(std::uint32_t from) {
  ++version_[from];
  if (fixed_[from]) return;
  std::vector<Candidate> candidates;
  for (std::uint32_t to : neighbours(from)) candidates.push_back({cost(from, to), from, to, version_[from]});
  std::ranges::sort(candidates, {}, [](const Candidate& c) { return std::pair(c.cost, c.to); });
  const auto best = std::ranges::find_if(candidates, [&](const Candidate& c) { return fits(c.from, c.to); });
  if (best != candidates.end()) queue_.push(*best);
}

bool Collapser::fits(std::uint32_t from, std::uint32_t to) {
  return keeps_topology(from, to) && keeps_facing(from, to) && find_corner_moves(from, to);
}

/// The link condition, and a border that stays where it is: only along itself may it lose a point.
bool Collapser::keeps_topology(std::uint32_t from, std::uint32_t to) {
  std::size_t dying = 0;
  for (std::uint32_t t : triangles_of_[from]) dying += has(triangles_[t], to) ? 1 : 0;
  if (dying == triangles_of_[from].size() || dying > 2) return false;
  if (on_border_[from] && dying != 1) return false;
  const auto around_from = neighbours(from), around_to = neighbours(to);
  std::vector<std::uint32_t> both;
  std::ranges::set_intersection(around_from, around_to, std::back_inserter(both));
  // A point whose only triangles die would go without anything in its place.
  for (std::uint32_t third : both) {
    const auto dies = [&](std::uint32_t t) { return has(triangles_[t], from) && has(triangles_[t], to); };
    if (std::ranges::all_of(triangles_of_[third], dies)) return false;
  }
  return both.size() == dying;
}

bool Collapser::keeps_facing(std::uint32_t from, std::uint32_t to) const {
  for (std::uint32_t t : triangles_of_[from]) {
    if (has(triangles_[t], to)) continue;
    const std::size_t side = side_of(triangles_[t], from);
    const Vector3d& b = surface_.at(0, triangles_[t].point[(side + 1) % 3]);
    const Vector3d& c = surface_.at(0, triangles_[t].point[(side + 2) % 3]);
    const Vector3d before = (b - surface_.at(0, from)).cross(c - surface_.at(0, from));
    const Vector3d after = (b - surface_.at(0, to)).cross(c - surface_.at(0, to));
    if (before.squaredNorm() == 0 && after.squaredNorm() > 0) continue;
    if (!(before.dot(after) > kSmallestCosine * before.norm() * after.norm())) return false;
  }
  return true;
}

/// Which corner of `to` continues each corner of `from`: the one on the same side of a texture seam, as a dying triangle
/// shows. False where none shows it.
bool Collapser::find_corner_moves(std::uint32_t from, std::uint32_t to) {
  moves_.clear();
  const auto move_of = [&](std::uint32_t corner) {
    return std::ranges::find(moves_, corner, &CollapseSequence::Move::from);
  };
  for (std::uint32_t t : triangles_of_[from]) {
    const Triangle& triangle = triangles_[t];
    if (!has(triangle, to)) continue;
    const CollapseSequence::Move move{triangle.corner[side_of(triangle, from)], triangle.corner[side_of(triangle, to)]};
    const auto known = move_of(move.from);
    if (known == moves_.end()) {
      moves_.push_back(move);
    } else if (known->to != move.to) {
      return false;
    }
  }
  return std::ranges::all_of(triangles_of_[from], [&](std::uint32_t t) {
    return move_of(triangles_[t].corner[side_of(triangles_[t], from)]) != moves_.end();
  });
}

/// How far `from`, and what went into it before, would lie from the triangles around `to`.
double Collapser::measure(std::uint32_t from, std::uint32_t to) {
  star_.clear();
  for (std::uint32_t t : triangles_of_[to]) {
    if (!has(triangles_[t], from)) star_.push_back(triangles_[t].point);
  }
  for (std::uint32_t t : triangles_of_[from]) {
    if (has(triangles_[t], to)) continue;
    star_.push_back(triangles_[t].point);
    star_.back()[side_of(triangles_[t], from)] = to;
  }
  double worst = 0;
  const auto include = [&](std::uint32_t point) {
    for (std::size_t pose = 0; pose < surface_.poses; ++pose) {
      double nearest = INFINITY;
      for (const auto& [a, b, c] : star_) {
        nearest = std::min(nearest, squared_distance(surface_.at(pose, point), surface_.at(pose, a),
                                                     surface_.at(pose, b), surface_.at(pose, c)));
      }
      worst = std::max(worst, nearest);
    }
  };
  include(from);
  for (std::uint32_t point : gone_into_[from]) include(point);
  return std::sqrt(worst);
}

void Collapser::collapse(std::uint32_t from, std::uint32_t to, double error) {
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
    triangle.corner[side] = std::ranges::find(moves_, triangle.corner[side], &CollapseSequence::Move::from)->to;
    triangles_of_[to].push_back(t);
  }
  triangles_of_[from].clear();
  gone_into_[to].push_back(from);
  gone_into_[to].insert(gone_into_[to].end(), gone_into_[from].begin(), gone_into_[from].end());
  gone_into_[from] = {};
  for (std::size_t first = 0; first < surface_.positions.size(); first += surface_.points()) {
    quadrics_[first + to].add(quadrics_[first + from]);
  }
  error_ = std::max(error_, error);
  sequence_.moves.insert(sequence_.moves.end(), moves_.begin(), moves_.end());
  sequence_.steps.push_back({float(error_), left_, std::uint32_t(sequence_.moves.size())});
}

CollapseSequence Collapser::run() {
  for (std::uint32_t p = 0; p < surface_.points(); ++p) weigh(p);
  const double fewest = limits_.fewest_share * left_;
  while (!queue_.empty() && left_ > fewest) {
    const Candidate best = queue_.top();
    queue_.pop();
    if (best.version != version_[best.from]) continue;
    if (!fits(best.from, best.to)) {  // Something beyond its own neighbours has changed.
      weigh(best.from);
      continue;
    }
    const double error = measure(best.from, best.to);
    if (error > limits_.largest_error) continue;
    collapse(best.from, best.to, error);
    weigh(best.to);
    for (std::uint32_t p : neighbours(best.to)) weigh(p);
  }
  return std::move(sequence_);
}

}  // namespace

CollapseSequence collapse_patch(const PatchSurface& surface, const CollapseLimits& limits) {
  return Collapser(surface, limits).run();
}

}  // namespace coif
