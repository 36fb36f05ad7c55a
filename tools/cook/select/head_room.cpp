#include "cook/select/head_room.h"

#include "base/geometry.h"
#include "platform/stop.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kSamples = 20'000;  ///< Samples of the hair's surface.
constexpr std::size_t kSide = 24;         ///< Side of the map of directions.
/// One of this many samples in a direction is further in than "innermost": roots.
constexpr std::size_t kInnermost = 5;
constexpr double kNear = 1.5;  ///< Hair beyond, in radii, hides nothing of the head.

// Terms of the sum that is minimised.
constexpr double kSunk = 0.12;       ///< Quantile of innermost hair that may be inside the head.
constexpr double kFar = 0.3;         ///< Mean radii: hair that hovers higher adds no more.
constexpr double kPoke = 3;          ///< Weight where the head comes out through the hair.
constexpr double kGuess = 0.004;     ///< Weight of a guess that is wrong by one deviation.
constexpr double kLeastSide = 0.25;  ///< Weight of hair below the head, which hangs, against 1 above.

constexpr int kRounds = 6;  ///< The innermost hair depends on the head's middle, so it is found again.
constexpr int kMostSweeps = 100;
constexpr double kFirstStep = 0.2, kLaterStep = 0.05, kLastStep = 0.004;

/// Points for the same share of the hair's surface each.
std::vector<Vector3d> sample_surface(const HairMesh& hair) {
  const auto corner = [&](std::size_t t, std::size_t k) { return Vector3d(hair.corner(t, k).cast<double>()); };
  std::vector<double> areas;
  double total = 0;
  for (std::size_t t = 0; t < hair.triangle_count(); ++t) {
    areas.push_back((corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm());
    total += areas.back();
  }
  std::vector<Vector3d> samples;
  const double each = total / double(kSamples);
  double due = 0;
  for (std::size_t t = 0; t < areas.size() && each > 0; ++t) {
    for (due += areas[t]; due > each / 2; due -= each) {
      const Eigen::Vector2d at = spread_in_triangle(samples.size() + 1);
      samples.push_back(corner(t, 0) + at.x() * (corner(t, 1) - corner(t, 0)) + at.y() * (corner(t, 2) - corner(t, 0)));
    }
  }
  return samples;
}

/// The cell of the sphere that a direction (not zero) is in: the faces of an octahedron, unfolded (Cigolle et al. 2014,
/// "A Survey of Efficient Representations for Independent Unit Vectors").
std::size_t part_of_sphere(Vector3d direction) {
  direction /= direction.cwiseAbs().sum();
  double x = direction.x(), z = direction.z();
  if (direction.y() < 0) {
    x = std::copysign(1 - std::abs(direction.z()), direction.x());
    z = std::copysign(1 - std::abs(direction.x()), direction.z());
  }
  const auto cell = [](double v) { return std::min(kSide - 1, std::size_t((v / 2 + 0.5) * double(kSide))); };
  return cell(x) * kSide + cell(z);
}

/// The hair in one direction from a head's middle.
struct Seen {
  Vector3d innermost, outermost;
};

std::vector<Seen> look_around(std::span<const Vector3d> samples, const Vector3d& center) {
  std::vector<std::vector<std::pair<double, std::uint32_t>>> parts(kSide * kSide);
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const Vector3d from = samples[i] - center;
    if (from.norm() > 0) parts[part_of_sphere(from)].emplace_back(from.norm(), i);
  }
  std::vector<Seen> seen;
  for (auto& part : parts) {
    if (part.empty()) continue;
    std::ranges::sort(part);
    seen.push_back({samples[part[part.size() / kInnermost].second], samples[part.back().second]});
  }
  return seen;
}

double squared(double value) { return value * value; }

/// How much a head differs from the guess.
double surprise(const HeadEllipsoid& head, const HeadGuess& guess) {
  const Eigen::Array3d grown = (head.radii.array() / guess.shape.radii.array()).log();
  const Eigen::Array3d moved = (head.center - guess.shape.center).array() / guess.shape.radii.mean();
  return (moved / guess.center_spread.array()).square().sum() +
         ((grown - grown.mean()) / guess.shape_spread).square().sum() + squared(grown.mean() / guess.size_spread);
}

/// The misfit of the visible hair: sunk and hovering hair weighted for a quantile (Koenker and Bassett 1978,
/// "Regression Quantiles"), in mean radii.
double misfit(const HeadEllipsoid& head, std::span<const Seen> seen) {
  const double size = head.radii.mean();
  double sum = 0, weights = 0;
  for (const Seen& part : seen) {
    const double inner = head.distance(part.innermost) / size, outer = head.distance(part.outermost) / size;
    const double up = (part.innermost - head.center).normalized().y();
    const double weight = kLeastSide + (1 - kLeastSide) * std::clamp(up + 0.5, 0.0, 1.0);
    weights += weight;
    sum += weight * (inner > 0 ? kSunk * std::min(inner, kFar) : (kSunk - 1) * inner);
    if (outer < 0) sum += weight * kPoke * -outer;
  }
  return weights > 0 ? sum / weights : 0;
}

/// The head changed by `step` mean radii: its middle along an axis, one radius, or all of them.
HeadEllipsoid nudged(HeadEllipsoid head, int what, double step) {
  if (what < 3) {
    head.center[what] += step * head.radii.mean();
  } else if (what < 6) {
    head.radii[what - 3] *= std::exp(step);
  } else {
    head.radii *= std::exp(step);
  }
  return head;
}

}  // namespace

// Search along the coordinates, since the sum has kinks but few valleys.
HeadEllipsoid descend(HeadEllipsoid head, const HeadSurprise& cost, double step) {
  double best = cost(head);
  for (int sweep = 0; sweep < kMostSweeps && step > kLastStep; ++sweep) {
    bool better = false;
    for (int way = 0; way < 14; ++way) {
      const HeadEllipsoid tried = nudged(head, way / 2, way % 2 == 0 ? step : -step);
      const double found = cost(tried);
      if (!(found < best - 1.0e-9)) continue;
      best = found;
      head = tried;
      better = true;
    }
    if (!better) step /= 2;
  }
  return head;
}

HeadEllipsoid fit_head_room(const HairMesh& hair, const HeadGuess& guess, const std::stop_token& stop) {
  return fit_head_room(
      hair, guess.shape, [&](const HeadEllipsoid& head) { return surprise(head, guess); }, stop);
}

HeadEllipsoid fit_head_room(const HairMesh& hair, const HeadEllipsoid& first, const HeadSurprise& surprise,
                            const std::stop_token& stop) {
  const std::vector<Vector3d> samples = sample_surface(hair);
  HeadEllipsoid head = first;
  for (int round = 0; round < kRounds; ++round) {
    platform::throw_if_stopped(stop);
    const std::vector<Seen> seen = look_around(samples, head.center);
    const auto cost = [&](const HeadEllipsoid& h) { return misfit(h, seen) + kGuess * surprise(h); };
    head = descend(head, cost, round == 0 ? kFirstStep : kLaterStep);
  }
  return head;
}

namespace {

/// Scaled distances from the head's middle, ascending.
struct HairAround {
  std::vector<double> area, vertices, outermost;
};

HairAround hair_around(const HairMesh& hair, const HeadEllipsoid& head) {
  HairAround around;
  const std::vector<Vector3d> samples = sample_surface(hair);
  for (const Vector3d& p : samples) around.area.push_back(head.scaled_distance(p));
  for (const Eigen::Vector3f& p : hair.positions) around.vertices.push_back(head.scaled_distance(p.cast<double>()));
  for (const Seen& part : look_around(samples, head.center)) {
    const double scaled = head.scaled_distance(part.outermost);
    if (head.scaled_distance(part.innermost) < kNear) around.outermost.push_back(scaled);
  }
  for (std::vector<double>* list : {&around.area, &around.vertices, &around.outermost}) std::ranges::sort(*list);
  return around;
}

double share_below_one(const std::vector<double>& ascending) {
  if (ascending.empty()) return 0;
  return double(std::ranges::lower_bound(ascending, 1.0) - ascending.begin()) / double(ascending.size());
}

/// The first value that is not among the lowest `share`.
double after_share(const std::vector<double>& ascending, double share) {
  const auto count = std::size_t(share * double(ascending.size()));
  return count < ascending.size() ? ascending[count] : 1;
}

}  // namespace

HairInside hair_inside(const HairMesh& hair, const HeadEllipsoid& head) {
  const HairAround around = hair_around(hair, head);
  return {share_below_one(around.area), share_below_one(around.vertices), share_below_one(around.outermost)};
}

double share_with_room(const HairMesh& hair, const HeadEllipsoid& head, const HairInside& most) {
  const HairAround around = hair_around(hair, head);
  return std::min({1.0, after_share(around.area, most.area), after_share(around.vertices, most.vertices),
                   after_share(around.outermost, most.pokes)});
}

HairCover hair_cover(const HairMesh& hair, const HeadEllipsoid& head) {
  constexpr double kUpperHalf = double(kSide * kSide) / 2;
  std::size_t near = 0;
  double hovering = 0;
  for (const Seen& part : look_around(sample_surface(hair), head.center)) {
    const double scaled = head.scaled_distance(part.innermost);
    if (!((part.innermost - head.center).y() > 0) || !(scaled < kNear)) continue;
    ++near;
    hovering += std::abs(scaled - 1);
  }
  return {std::min(1.0, double(near) / kUpperHalf), near > 0 ? hovering / double(near) : kNear - 1};
}

}  // namespace coif::cook
