#include "cards/fit_opacity.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace coif::cards {
namespace {

/// Metres, of a point from the line between two others.
float off_line(const Eigen::Vector3f& point, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  const Eigen::Vector3f way = b - a;
  const float squared = way.squaredNorm();
  const float share = squared > 0 ? std::clamp((point - a).dot(way) / squared, 0.0f, 1.0f) : 0.0f;
  return (a + share * way - point).norm();
}

/// Finds the points of first..last that must stay, both ends included.
void find_corners(const std::vector<Eigen::Vector3f>& points, std::uint32_t first, std::uint32_t last, float tolerance,
                  std::vector<bool>& stays) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{first, last}};
  stays[first] = stays[last] = true;
  while (!open.empty()) {
    const auto [begin, end] = open.back();
    open.pop_back();
    float farthest = tolerance;
    std::uint32_t corner = begin;
    for (std::uint32_t p = begin + 1; p < end; ++p) {
      const float off = off_line(points[p], points[begin], points[end]);
      if (off > farthest) farthest = off, corner = p;
    }
    if (corner == begin) continue;
    stays[corner] = true;
    open.push_back({begin, corner});
    open.push_back({corner, end});
  }
}

}  // namespace

groom::Groom fewer_strands(const groom::Groom& groom, float width, std::size_t points) {
  const std::size_t each =
      std::max<std::size_t>((groom.points.size() + points - 1) / std::max<std::size_t>(points, 1), 1);
  groom::Groom fewer;
  fewer.root_first = groom.root_first;
  fewer.begin.push_back(0);
  for (std::size_t i = 0; i < groom.strand_count(); i += each) {
    for (std::uint32_t p = groom.begin[i]; p < groom.begin[i + 1]; ++p) {
      fewer.points.push_back(groom.points[p]);
      fewer.widths.push_back(float(each) * (groom.widths.empty() ? width : groom.widths[p]));
    }
    fewer.begin.push_back(std::uint32_t(fewer.points.size()));
  }
  fewer.groups.push_back({"", 0, std::uint32_t(fewer.strand_count())});
  return fewer;
}

groom::Groom straighter_strands(const groom::Groom& groom, float tolerance) {
  std::vector<bool> stays(groom.points.size(), false);
  for (std::size_t i = 0; i < groom.strand_count(); ++i)
    find_corners(groom.points, groom.begin[i], groom.begin[i + 1] - 1, tolerance, stays);
  groom::Groom straighter;
  straighter.root_first = groom.root_first;
  straighter.groups = groom.groups;
  straighter.begin.push_back(0);
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    for (std::uint32_t p = groom.begin[i]; p < groom.begin[i + 1]; ++p) {
      if (!stays[p]) continue;
      straighter.points.push_back(groom.points[p]);
      if (!groom.widths.empty()) straighter.widths.push_back(groom.widths[p]);
      if (!groom.colors.empty()) straighter.colors.push_back(groom.colors[p]);
    }
    straighter.begin.push_back(std::uint32_t(straighter.points.size()));
  }
  return straighter;
}

}  // namespace coif::cards
