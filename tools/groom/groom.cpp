#include "groom/groom.h"

#include "base/text.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::groom {
namespace {

// The file's unit is not known to be right: a groom in centimetres is a hundred times as large. Beyond this it is
// damage.
constexpr float kFarthestPoint = 1e6f;

bool is_usable(const Eigen::Vector3f& point) {
  return point.allFinite() && point.cwiseAbs().maxCoeff() <= kFarthestPoint;
}

template <class Values>
bool fits(const Values& values, std::size_t points) {
  return values.empty() || values.size() == points;
}

template <class Values>
bool are_within(const Values& values, float low, float high) {
  return std::ranges::all_of(values, [=](float value) { return value >= low && value <= high; });
}

std::string strands_fault(const Groom& groom) {
  if (groom.begin.size() < 2) return "no strand";
  if (groom.strand_count() > kMostStrands || groom.points.size() > kMostStrandPoints) return "too many strands";
  if (groom.begin.front() != 0 || groom.begin.back() != groom.points.size()) return "strands do not cover the points";
  for (std::size_t i = 0; i + 1 < groom.begin.size(); ++i) {
    if (groom.begin[i + 1] < groom.begin[i] + std::uint64_t{2})
      return fmt::format("strand {}: fewer than two points", i);
  }
  if (!std::ranges::all_of(groom.points, is_usable)) return "place not finite";
  return {};
}

std::string attributes_fault(const Groom& groom) {
  const std::size_t points = groom.points.size();
  if (!fits(groom.widths, points) || !fits(groom.colors, points) || !fits(groom.opacities, points)) {
    return "an attribute that not every point has";
  }
  if (!are_within(groom.widths, 0, kFarthestPoint)) return "width is no length";
  if (!are_within(groom.opacities, 0, 1)) return "opacity outside 0..1";
  for (const Eigen::Vector3f& color : groom.colors) {
    if (!color.allFinite() || color.minCoeff() < 0 || color.maxCoeff() > 1) return "colour outside 0..1";
  }
  return {};
}

std::string groups_fault(const Groom& groom) {
  std::uint64_t next = 0;
  for (const StrandGroup& group : groom.groups) {
    if (group.first_strand != next || group.strand_count == 0) return fmt::format("group '{}': a gap", group.name);
    next += group.strand_count;
  }
  return next == groom.strand_count() ? "" : "strands without a group";
}

void warn_of(std::size_t count, const char* what, Diagnostics& warnings) {
  if (count != 0)
    importer::warn(warnings, importer::source_code::kStrands, "{} left out: {}", counted(count, "strand", "strands"),
                   what);
}

}  // namespace

float usual_strand_width(float head_radius, std::size_t strands) {
  constexpr float kHairsOfHead = 100000;  // A human head's, each kHairWidth of the head's radius wide.
  constexpr float kHairWidth = 0.0008f;
  return kHairWidth * head_radius * std::pow(std::max(kHairsOfHead / float(strands), 1.0f), 0.75f);
}

std::string find_groom_fault(const Groom& groom) {
  if (std::string fault = strands_fault(groom); !fault.empty()) return fault;
  if (std::string fault = attributes_fault(groom); !fault.empty()) return fault;
  if (!(groom.space.metres_per_unit > 0)) return "unit is no length";
  return groups_fault(groom);
}

void GroomBuilder::begin_group(std::string name) {
  if (!groom_.groups.empty() && groom_.groups.back().strand_count == 0) groom_.groups.pop_back();
  groom_.groups.push_back({std::move(name), std::uint32_t(groom_.strand_count()), 0});
}

void GroomBuilder::add(std::span<const Eigen::Vector3f> points, const Attributes& attributes) {
  if (points.size() < 2) return void(++too_short_);
  if (!std::ranges::all_of(points, is_usable)) return void(++misplaced_);
  if (groom_.strand_count() >= kMostStrands || groom_.points.size() + points.size() > kMostStrandPoints) {
    return void(too_many_ = true);
  }
  const std::size_t begin = groom_.points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (groom_.points.size() > begin && groom_.points.back() == points[i]) continue;
    groom_.points.push_back(points[i]);
    if (!attributes.widths.empty()) groom_.widths.push_back(attributes.widths[i]);
    if (!attributes.colors.empty()) groom_.colors.push_back(attributes.colors[i]);
    if (!attributes.opacities.empty()) groom_.opacities.push_back(attributes.opacities[i]);
  }
  if (groom_.points.size() < begin + 2) {
    ++without_length_;
    groom_.points.resize(begin);
    if (!attributes.widths.empty()) groom_.widths.resize(begin);
    if (!attributes.colors.empty()) groom_.colors.resize(begin);
    if (!attributes.opacities.empty()) groom_.opacities.resize(begin);
    return;
  }
  if (groom_.groups.empty()) begin_group("");
  groom_.begin.push_back(std::uint32_t(groom_.points.size()));
  ++groom_.groups.back().strand_count;
}

std::string GroomBuilder::finish() {
  if (!groom_.groups.empty() && groom_.groups.back().strand_count == 0) groom_.groups.pop_back();
  if (too_many_) {
    return fmt::format("more than {} strands or {} points; export guides, or a part of the hair", kMostStrands,
                       kMostStrandPoints);
  }
  warn_of(too_short_, "fewer than two points", groom_.warnings);
  warn_of(misplaced_, "points that are no numbers, or farther out than a million units", groom_.warnings);
  warn_of(without_length_, "all of their points at one place", groom_.warnings);
  return groom_.strand_count() == 0 ? "no strand that could be used; export curves as polylines" : "";
}

}  // namespace coif::groom
