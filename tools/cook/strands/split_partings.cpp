#include "cook/strands/strand_direction.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr float kPartEnd = 0.25f;  ///< Share of the strand's length, at each end.
constexpr float kMiddle = 0.1f;    ///< Share of the strand's length, to each side of the middle.
/// Share of the head's radius: ends that differ by more are no mirror images.
constexpr double kMostUnlike = 0.3;
constexpr double kLeastRise = 0.25;  ///< The middle is so much higher than both ends
/// Share of the head's radius: least distance of each end from the head's middle plane.
constexpr double kLeastReach = 0.7;

constexpr std::size_t kStations = 16;  ///< Along a strip.
/// Radians about the vertical: least way round the head, two thirds of it.
constexpr double kLeastWay = 4.2;
/// Share of the head's radius by which its lowest place must be below both ends.
constexpr double kLeastDrop = 0.5;
/// Share of the head's radius by which all of it may be above the head.
constexpr double kMostLift = 0.7;

struct MeanPlace {
  Vector3d sum = Vector3d::Zero();
  double count = 0;

  void add(const Eigen::Vector3f& p) {
    sum += p.cast<double>();
    count += 1;
  }
  [[nodiscard]] Vector3d value() const { return count > 0 ? Vector3d(sum / count) : Vector3d::Constant(NAN); }
};

/// For a patch from one side of the head over its top to the other: the X that separates its halves. None for other
/// patches.
std::optional<double> parting_of(const HairStrips& hair, const PatchView& patch, const FittedHead& head) {
  MeanPlace low, middle, high;
  for (const std::uint32_t v : patch.vertices) {
    const float place = hair.strands.place[v];
    const Eigen::Vector3f& p = hair.mesh.positions[v];
    if (place <= kPartEnd) low.add(p);
    if (place >= 1 - kPartEnd) high.add(p);
    if (std::abs(place - 0.5f) <= kMiddle) middle.add(p);
  }
  const double radius = head.radii.mean();
  const Vector3d a = low.value() - head.center, b = high.value() - head.center, top = middle.value() - head.center;
  const bool is_mirrored = std::abs(a.x() + b.x()) < kMostUnlike * radius &&
                           std::abs(a.y() - b.y()) < kMostUnlike * radius &&
                           std::abs(a.z() - b.z()) < kMostUnlike * radius;
  const bool is_across = a.x() * b.x() < 0 && std::min(std::abs(a.x()), std::abs(b.x())) > kLeastReach * head.radii.x();
  if (!is_mirrored || !is_across || !(top.y() - std::max(a.y(), b.y()) > kLeastRise * radius)) return std::nullopt;
  return head.center.x() + (a.x() + b.x()) / 2;
}

/// For a patch round the head from one side of a parting to the other, lowest on the way: the place along the strand of
/// its lowest point. None for other patches, also for hair that hangs off the head.
std::optional<float> meeting_of(const HairStrips& hair, const PatchView& patch, const FittedHead& head) {
  std::array<MeanPlace, kStations> stations;
  for (const std::uint32_t v : patch.vertices) {
    const auto station = std::size_t(std::max(0.0f, hair.strands.place[v]) * float(kStations));
    stations[std::min(station, kStations - 1)].add(hair.mesh.positions[v]);
  }
  std::vector<Vector3d> way;
  std::vector<float> places;
  for (std::size_t s = 0; s < kStations; ++s) {
    if (stations[s].count == 0) continue;
    way.push_back((stations[s].value() - head.center).cwiseQuotient(head.radii));
    places.push_back((float(s) + 0.5f) / float(kStations));
    if (way.back().norm() > 1 + kMostLift) return std::nullopt;
  }
  if (way.size() < 3) return std::nullopt;
  double round = 0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const Vector3d &from = way[i - 1], &to = way[i];
    round += std::atan2(from.x() * to.z() - from.z() * to.x(), from.x() * to.x() + from.z() * to.z());
  }
  const auto lowest = std::ranges::min_element(way, {}, [](const Vector3d& p) { return p.y(); });
  const double drop = std::min(way.front().y(), way.back().y()) - lowest->y();
  if (std::abs(round) < kLeastWay || drop < kLeastDrop) return std::nullopt;
  return places[std::size_t(lowest - way.begin())];
}

/// Whether a triangle belongs to the second half of its patch.
using IsBeyond = std::function<bool(std::size_t triangle)>;

/// Empty for patches that stay whole.
IsBeyond cut_of(const HairStrips& hair, const PatchView& patch, const FittedHead& head) {
  const auto mean = [&hair](std::size_t triangle, const auto& of_corner) {
    return (of_corner(triangle, 0) + of_corner(triangle, 1) + of_corner(triangle, 2)) / 3;
  };
  if (const auto parting = parting_of(hair, patch, head)) {
    const auto x = [&hair](std::size_t t, std::size_t k) { return double(hair.mesh.corner(t, k).x()); };
    return [=](std::size_t triangle) { return mean(triangle, x) > *parting; };
  }
  if (const auto meeting = meeting_of(hair, patch, head)) {
    const auto place = [&hair](std::size_t t, std::size_t k) {
      return hair.strands.place[hair.mesh.triangles[3 * t + k]];
    };
    return [=](std::size_t triangle) { return mean(triangle, place) > *meeting; };
  }
  return {};
}

}  // namespace

std::uint32_t split_partings(HairStrips& hair, const FittedHead& head, std::span<const std::string> roots,
                             Findings& findings) {
  const std::vector<PatchView> views = hair.views();
  const std::uint32_t before = hair.patches.count;
  for (std::uint32_t patch = 0; patch < views.size(); ++patch) {
    const PatchView& view = views[patch];
    const IsBeyond is_beyond = roots[patch] == "auto" ? cut_of(hair, view, head) : IsBeyond{};
    if (!is_beyond) continue;
    const std::uint32_t other = hair.patches.add_part_of(patch);
    for (const std::size_t t : view.triangles) {
      if (is_beyond(t / 3)) hair.patches.patch_of[t / 3] = other;
    }
  }
  const std::uint32_t more = hair.patches.count - before;
  if (more == 0) return 0;
  hair.separate_patches();
  findings.note(fmt::format(
      "patches: {} from one side of a parting over or round the head to its other side, cut in the middle", more));
  return more;
}

}  // namespace coif::cook
