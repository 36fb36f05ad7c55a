#include "cards/hair_source.h"

#include "cards/even_strands.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace coif::cards {
namespace {

using Eigen::Vector3f;

constexpr float kTipSeparation = 1;

/// Strands that may begin with their tips, seen from their roots.
class GuideRoots {
 public:
  explicit GuideRoots(const groom::Groom& guides) : guides_(guides), reversed_(find_reversed_strands(guides)) {}

  [[nodiscard]] bool is_reversed(std::size_t i) const { return reversed_[i] != 0; }
  [[nodiscard]] const Vector3f& root(std::size_t i) const { return root_of(guides_, reversed_, i); }
  [[nodiscard]] Vector3f way(std::size_t i) const {
    const auto strand = guides_.strand(i);
    const Vector3f segment = is_reversed(i) ? strand[strand.size() - 2] - strand.back() : strand[1] - strand[0];
    return segment.normalized();
  }

  /// Distance between neighbouring roots, the median of some.
  [[nodiscard]] float typical_distance() const {
    constexpr std::size_t kSome = 500;
    const std::size_t count = guides_.strand_count(), step = std::max<std::size_t>(count / kSome, 1);
    std::vector<float> distances;
    for (std::size_t i = 0; i < count; i += step) {
      float nearest = std::numeric_limits<float>::max();
      for (std::size_t k = 0; k < count; ++k) {
        if (k != i) nearest = std::min(nearest, (root(k) - root(i)).squaredNorm());
      }
      if (count > 1) distances.push_back(std::sqrt(nearest));
    }
    if (distances.empty()) return 0;
    return quantile(distances, 0.5f);
  }

 private:
  const groom::Groom& guides_;
  std::vector<std::uint8_t> reversed_;
};

/// Uniform in a circle, the same on every platform.
Eigen::Vector2f in_circle(std::mt19937& random) {
  for (;;) {
    const float x = float(random() >> 8) * 0x1p-23f - 1, y = float(random() >> 8) * 0x1p-23f - 1;
    if (x * x + y * y <= 1) return {x, y};
  }
}

template <class Value>
std::span<const Value> part_of(const std::vector<Value>& values, std::size_t begin, std::size_t count) {
  return values.empty() ? std::span<const Value>() : std::span(values).subspan(begin, count);
}

}  // namespace

tl::expected<groom::Groom, ToolError> with_follow_hairs(groom::Groom guides, std::uint32_t count, float radius) {
  if (count == 0) return guides;
  const std::uint64_t each = std::uint64_t{count} + 1;
  if (each * guides.strand_count() > groom::kMostStrands || each * guides.points.size() > groom::kMostStrandPoints) {
    return file_failure(ToolError::Kind::kOverBudget, guides.path,
                        "{} strands with {} follow hairs each are more than {} strands or {} points; ask for fewer by "
                        "the recipe's \"cards.follow_hairs\"",
                        guides.strand_count(), count, groom::kMostStrands, groom::kMostStrandPoints);
  }
  const GuideRoots roots(guides);
  if (!(radius > 0)) radius = roots.typical_distance();
  groom::Groom all;
  all.path = guides.path;
  all.format = guides.format;
  all.root_first = guides.root_first;
  all.space = guides.space;
  all.warnings = guides.warnings;
  groom::GroomBuilder builder(all);
  std::mt19937 random(1);
  std::vector<Vector3f> points;
  for (const groom::StrandGroup& group : guides.groups) {
    builder.begin_group(group.name);
    for (std::size_t i = group.first_strand; i < group.first_strand + std::size_t{group.strand_count}; ++i) {
      const auto guide = guides.strand(i);
      const std::size_t begin = guides.begin[i];
      const groom::GroomBuilder::Attributes looks{part_of(guides.widths, begin, guide.size()),
                                                  part_of(guides.colors, begin, guide.size()),
                                                  part_of(guides.opacities, begin, guide.size())};
      builder.add(guide, looks);
      const Vector3f across = roots.way(i).unitOrthogonal(), aside = roots.way(i).cross(across);
      for (std::uint32_t f = 0; f < count; ++f) {
        const Eigen::Vector2f place = radius * in_circle(random);
        points.clear();
        for (std::size_t k = 0; k < guide.size(); ++k) {
          const std::size_t from_root = roots.is_reversed(i) ? guide.size() - 1 - k : k;
          const float factor = 1 + kTipSeparation * float(from_root) / float(guide.size() - 1);
          points.emplace_back(guide[k] + factor * (place.x() * across + place.y() * aside));
        }
        builder.add(points, looks);
      }
    }
  }
  if (std::string fault = builder.finish(); !fault.empty())
    return file_failure(ToolError::Kind::kBadInput, guides.path, "{}", fault);
  return all;
}

}  // namespace coif::cards
