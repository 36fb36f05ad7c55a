#include "cook/strands/strand_direction.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace coif {
namespace {

using Eigen::Vector3d;

constexpr float kPartEnd = 0.25f;    ///< Of the place along the strand, at each end.
constexpr float kMiddle = 0.1f;      ///< To each side of the middle.
constexpr double kMostUnlike = 0.3;  ///< Of the head's radius: ends that differ by more do not mirror each other.
constexpr double kLeastRise = 0.25;  ///< The middle is so much higher than both ends
constexpr double kLeastReach = 0.7;  ///< and each end so far from the head's middle plane.

struct MeanPlace {
  Vector3d sum = Vector3d::Zero();
  double count = 0;

  void add(const Eigen::Vector3f& p) {
    sum += p.cast<double>();
    count += 1;
  }
  [[nodiscard]] Vector3d value() const { return count > 0 ? Vector3d(sum / count) : Vector3d::Constant(NAN); }
};

/// From one side of the head over its top to the other: the X that parts its halves. None for other patches.
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

}  // namespace

std::uint32_t split_partings(HairStrips& hair, const FittedHead& head, std::span<const std::string> roots,
                             Findings& findings) {
  const std::vector<PatchView> views = hair.views();
  const std::uint32_t before = hair.patches.count;
  for (std::uint32_t patch = 0; patch < views.size(); ++patch) {
    const PatchView& view = views[patch];
    const auto parting = roots[patch] == "auto" ? parting_of(hair, view, head) : std::nullopt;
    if (!parting) continue;
    const std::uint32_t other = hair.patches.add_part_of(patch);
    for (const std::size_t t : view.triangles) {
      double x = 0;
      for (std::size_t k = 0; k < 3; ++k) x += double(hair.mesh.corner(t / 3, k).x()) / 3;
      if (x > *parting) hair.patches.patch_of[t / 3] = other;
    }
  }
  const std::uint32_t more = hair.patches.count - before;
  if (more == 0) return 0;
  hair.separate_patches();
  findings.note(
      fmt::format("patches: {} from one side of the head over its top to the other, cut at the parting", more));
  return more;
}

}  // namespace coif
