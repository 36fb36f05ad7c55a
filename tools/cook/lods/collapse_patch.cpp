#include "cook/lods/collapse_patch.h"

#include "cook/lods/patch_surface.h"
#include "cook/select/triangle_distance.h"
#include "platform/stop.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

/// Weight of the planes that hold the outline, against those of the surface: people see mostly silhouettes of strips.
constexpr double kOutlineWeight = 4;
/// A candidate whose error has grown by more than this factor since it was weighed returns to the queue.
constexpr double kStale = 1.1;

struct Candidate {
  double error = 0;  ///< Metres.
  std::uint32_t from = 0, to = 0;
  std::uint32_t version = 0;  ///< Version of `from` when it was weighed; an older one is out of date.

  bool operator<(const Candidate& other) const {  // std::priority_queue hands out the largest
    return std::pair(error, from) > std::pair(other.error, other.from);
  }
};

/// For each point of each pose the planes of its triangles, weighted by area, and of its borders, perpendicular to the
/// surface.
std::vector<SurfaceQuadric> find_quadrics(const PatchSurface& surface) {
  std::vector<SurfaceQuadric> quadrics(surface.positions.size());
  const auto doubled_normal = [&](std::size_t pose, std::uint32_t t) -> Vector3d {
    const auto& [a, b, c] = surface.triangles[t].point;
    const Vector3d& origin = surface.at(pose, a);
    return (surface.at(pose, b) - origin).cross(surface.at(pose, c) - origin);
  };
  const auto add_plane = [&](std::size_t pose, std::uint32_t p, const Vector3d& normal, double weight) {
    quadrics[pose * surface.points() + p].add_plane(normal.normalized(), surface.at(pose, p), weight);
  };
  const PatchOutline outline = find_outline(surface);
  for (std::size_t pose = 0; pose < surface.poses; ++pose) {
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      const Vector3d normal = doubled_normal(pose, t);
      for (std::uint32_t p : surface.triangles[t].point) add_plane(pose, p, normal, normal.norm());
    }
    for (const PatchOutline::Edge& edge : outline.edges) {
      const Vector3d along = surface.at(pose, edge.b) - surface.at(pose, edge.a);
      const Vector3d out = along.cross(doubled_normal(pose, edge.triangle));
      for (std::uint32_t p : {edge.a, edge.b}) add_plane(pose, p, out, kOutlineWeight * along.squaredNorm());
    }
  }
  return quadrics;
}

class Collapser {
 public:
  Collapser(const PatchSurface& surface, const CollapseLimits& limits, const std::stop_token& stop)
      : surface_(surface),
        limits_(limits),
        stop_(stop),
        shrinking_(surface),
        quadrics_(find_quadrics(surface)),
        gone_into_(surface.points()),
        version_(surface.points(), 0),
        target_(surface.points(), importer::kNoIndex) {}

  CollapseSequence run();

 private:
  void weigh(std::uint32_t from);
  [[nodiscard]] double change(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] double measure(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] double squared_error(std::uint32_t point, std::span<const ShrinkingSurface::Points> star,
                                     double at_least) const;
  void collapse(std::uint32_t from, std::uint32_t to, double error);

  const PatchSurface& surface_;
  CollapseLimits limits_;
  const std::stop_token& stop_;
  ShrinkingSurface shrinking_;
  std::vector<SurfaceQuadric> quadrics_;               ///< Per pose and point, as PatchSurface::positions.
  std::vector<std::vector<std::uint32_t>> gone_into_;  ///< Per point; points that were collapsed into it.
  std::vector<std::uint32_t> version_;
  std::vector<std::uint32_t> target_;  ///< Per point; where the candidate in the queue takes it.
  std::priority_queue<Candidate> queue_;
  std::vector<std::pair<double, std::uint32_t>> choices_;
  CollapseSequence sequence_;
};

/// The error of both ends' quadrics at `to`, over all poses.
double Collapser::change(std::uint32_t from, std::uint32_t to) const {
  double sum = 0;
  for (std::size_t pose = 0; pose < surface_.poses; ++pose) {
    const Vector3d& target = surface_.at(pose, to);
    const std::size_t first = pose * surface_.points();
    sum += quadrics_[first + from].at(target) + quadrics_[first + to].at(target);
  }
  return sum;
}

/// Puts the best way to remove `from`, if any, into the queue. The quadrics choose among its neighbours; the measured
/// error decides its turn.
void Collapser::weigh(std::uint32_t from) {
  ++version_[from];
  target_[from] = importer::kNoIndex;
  if (shrinking_.is_fixed(from)) return;
  choices_.clear();
  for (std::uint32_t to : shrinking_.neighbours(from)) choices_.emplace_back(change(from, to), to);
  std::ranges::sort(choices_);
  for (const auto& [change, to] : choices_) {
    if (!shrinking_.may_collapse(from, to)) continue;
    const double error = measure(from, to);
    if (error > limits_.largest_error) return;
    target_[from] = to;
    queue_.push({error, from, to, version_[from]});
    return;
  }
}

/// The squared distance of `point` from the star, in the worst pose, or something not above `at_least`.
double Collapser::squared_error(std::uint32_t point, std::span<const ShrinkingSurface::Points> star,
                                double at_least) const {
  for (std::size_t pose = 0; pose < surface_.poses; ++pose) {
    double nearest = INFINITY;
    for (const auto& [a, b, c] : star) {
      nearest = std::min(nearest, squared_distance(surface_.at(pose, point), surface_.at(pose, a), surface_.at(pose, b),
                                                   surface_.at(pose, c)));
      if (nearest <= at_least) break;
    }
    at_least = std::max(at_least, nearest);
  }
  return at_least;
}

/// Distance of `from`, and of the points that collapsed into it before, from the triangles around `to`. Metres.
double Collapser::measure(std::uint32_t from, std::uint32_t to) {
  const auto star = shrinking_.star_after(from, to);
  double worst = squared_error(from, star, 0);
  for (std::uint32_t point : gone_into_[from]) worst = squared_error(point, star, worst);
  return std::sqrt(worst);
}

void Collapser::collapse(std::uint32_t from, std::uint32_t to, double error) {
  shrinking_.collapse(from, to, sequence_.moves);
  gone_into_[to].push_back(from);
  gone_into_[to].insert(gone_into_[to].end(), gone_into_[from].begin(), gone_into_[from].end());
  gone_into_[from] = {};
  for (std::size_t first = 0; first < surface_.positions.size(); first += surface_.points()) {
    quadrics_[first + to].add(quadrics_[first + from]);
  }
  const float before = sequence_.steps.empty() ? 0.0f : sequence_.steps.back().error;
  sequence_.steps.push_back(
      {std::max(before, float(error)), shrinking_.triangles_left(), std::uint32_t(sequence_.moves.size())});
}

CollapseSequence Collapser::run() {
  for (std::uint32_t p = 0; p < surface_.points(); ++p) weigh(p);
  const double fewest = limits_.fewest_share * shrinking_.triangles_left();
  std::vector<std::uint32_t> around;
  while (!queue_.empty() && shrinking_.triangles_left() > fewest) {
    platform::throw_if_stopped(stop_);
    const Candidate best = queue_.top();
    queue_.pop();
    if (best.version != version_[best.from]) continue;
    const bool fits = shrinking_.may_collapse(best.from, best.to);
    const double error = fits ? measure(best.from, best.to) : 0;
    if (!fits || error > kStale * best.error + 1.0e-9) {  // Its surroundings have changed since.
      weigh(best.from);
      continue;
    }
    collapse(best.from, best.to, error);
    weigh(best.to);
    const auto neighbours = shrinking_.neighbours(best.to);
    around.assign(neighbours.begin(), neighbours.end());
    for (std::uint32_t p : around) {
      if (target_[p] == best.from || target_[p] == importer::kNoIndex) weigh(p);
    }
  }
  return std::move(sequence_);
}

}  // namespace

CollapseSequence collapse_patch(const PatchSurface& surface, const CollapseLimits& limits,
                                const std::stop_token& stop) {
  return Collapser(surface, limits, stop).run();
}

}  // namespace coif::cook
