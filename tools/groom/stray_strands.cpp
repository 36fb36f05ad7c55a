#include "base/text.h"
#include "groom/groom.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace coif::groom {
namespace {

constexpr std::size_t kStrandsOfAStray = 1000;  // One strand of so many may be a stray, and one of fewer.
constexpr std::size_t kFewestStrands = 50;
constexpr float kApart = 2;  // A stray lies so many times farther from the middle than all that are no strays.
constexpr std::size_t kNamed = 3;

/// Coordinate by coordinate, of the strands' first points.
Eigen::Vector3f middle_of(const Groom& groom) {
  Eigen::Vector3f middle;
  std::vector<float> values(groom.strand_count());
  const auto half = values.begin() + std::ptrdiff_t(values.size() / 2);
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = groom.strand(i).front()[axis];
    std::ranges::nth_element(values, half);
    middle[axis] = *half;
  }
  return middle;
}

/// Marks the few strands whose distance is far beyond that of all others.
void mark_strays(const std::vector<float>& distances, std::vector<bool>& is_stray) {
  std::vector<std::pair<float, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < distances.size(); ++i) order.emplace_back(distances[i], i);
  const std::size_t most = std::max<std::size_t>(distances.size() / kStrandsOfAStray, 1);
  std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(most + 1), order.end(), std::greater());
  std::size_t strays = 0;
  for (std::size_t k = 1; k <= most; ++k) {
    if (order[k - 1].first > kApart * order[k].first) strays = k;
  }
  for (std::size_t k = 0; k < strays; ++k) is_stray[order[k].second] = true;
}

Groom without(const Groom& groom, const std::vector<bool>& is_stray) {
  Groom kept = groom;
  kept.points.clear();
  kept.widths.clear();
  kept.colors.clear();
  kept.opacities.clear();
  kept.begin.assign(1, 0);
  kept.groups.clear();
  for (const StrandGroup& group : groom.groups) {
    const auto first = std::uint32_t(kept.strand_count());
    for (std::uint32_t i = group.first_strand; i < group.first_strand + group.strand_count; ++i) {
      if (is_stray[i]) continue;
      const auto add = [&](const auto& from, auto& to) {
        if (!from.empty()) to.insert(to.end(), from.begin() + groom.begin[i], from.begin() + groom.begin[i + 1]);
      };
      add(groom.points, kept.points);
      add(groom.widths, kept.widths);
      add(groom.colors, kept.colors);
      add(groom.opacities, kept.opacities);
      kept.begin.push_back(std::uint32_t(kept.points.size()));
    }
    const std::uint32_t count = std::uint32_t(kept.strand_count()) - first;
    if (count > 0) kept.groups.push_back({group.name, first, count});
  }
  return kept;
}

}  // namespace

void leave_out_strays(Groom& groom) {
  if (groom.strand_count() < kFewestStrands) return;
  const Eigen::Vector3f middle = middle_of(groom);
  std::vector<float> nearest(groom.strand_count(), std::numeric_limits<float>::max()), farthest(nearest.size(), 0);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    for (const Eigen::Vector3f& point : groom.strand(i)) {
      const float distance = (point - middle).norm();
      nearest[i] = std::min(nearest[i], distance);
      farthest[i] = std::max(farthest[i], distance);
    }
  }
  std::vector<bool> is_stray(nearest.size(), false);
  mark_strays(nearest, is_stray);   // far away
  mark_strays(farthest, is_stray);  // much longer
  const auto count = std::size_t(std::ranges::count(is_stray, true));
  if (count == 0) return;
  std::string named;
  std::size_t names = 0;
  for (std::size_t i = 0; i < is_stray.size() && names < kNamed; ++i) {
    if (is_stray[i]) named += fmt::format("{}{}", names++ > 0 ? ", " : "", i);
  }
  Groom kept = without(groom, is_stray);
  importer::warn(kept.warnings, importer::source_code::kStrands,
                 "{} left out, far away from all others or much longer: {} of {}, counted from 0{}",
                 counted(count, "strand", "strands"), named, groom.strand_count(),
                 count > kNamed ? ", and others" : "");
  groom = std::move(kept);
}

}  // namespace coif::groom
