#include "grow/body_surface.h"

#include "cook/select/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace coif::grow {
namespace {

using Eigen::Vector3f;

constexpr std::uint32_t kTrianglesOfLeaf = 4;
constexpr float kFar = 2;  // radii from which on a dipole is as good as its triangles (Barill et al. 2018)
constexpr int kDeepest = 64;

/// Solid angle of a triangle, signed. Source: van Oosterom and Strackee 1983.
float solid_angle(const Vector3f& a, const Vector3f& b, const Vector3f& c) {
  const float la = a.norm(), lb = b.norm(), lc = c.norm();
  const float numerator = a.dot(b.cross(c));
  const float denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2 * std::atan2(numerator, denominator);
}

}  // namespace

BodySurface::BodySurface(std::vector<Vector3f> positions, std::vector<std::uint32_t> triangles)
    : positions_(std::move(positions)), triangles_(std::move(triangles)) {
  nodes_.reserve(triangles_.size() / 3 + 2);
  nodes_.emplace_back();
  nodes_.front().count = std::uint32_t(triangles_.size() / 3);
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) build(node);
}

/// Computes the node's values, and its two children if it is no leaf.
void BodySurface::build(std::uint32_t node) {
  Node& n = nodes_[node];
  float whole = 0;
  for (std::size_t t = n.first; t < n.first + n.count; ++t) {
    const Vector3f area = 0.5f * (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0));
    for (std::size_t k = 0; k < 3; ++k) n.box.extend(corner(t, k));
    n.area += area;
    n.middle += area.norm() * (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3;
    whole += area.norm();
  }
  n.middle = whole > 0 ? Vector3f(n.middle / whole) : n.box.center();
  for (std::size_t t = n.first; t < n.first + n.count; ++t) {
    for (std::size_t k = 0; k < 3; ++k) n.radius = std::max(n.radius, (corner(t, k) - n.middle).norm());
  }
  if (n.count <= kTrianglesOfLeaf) return;
  int axis = 0;
  n.box.sizes().maxCoeff(&axis);
  std::vector<std::array<std::uint32_t, 3>> sorted(n.count);
  for (std::size_t i = 0; i < n.count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) sorted[i][k] = triangles_[3 * (n.first + i) + k];
  }
  const auto place = [&](const auto& t) {
    return positions_[t[0]][axis] + positions_[t[1]][axis] + positions_[t[2]][axis];
  };
  const std::uint32_t half = n.count / 2;
  std::ranges::nth_element(sorted, sorted.begin() + half, {}, place);
  for (std::size_t i = 0; i < n.count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) triangles_[3 * (n.first + i) + k] = sorted[i][k];
  }
  n.children = std::uint32_t(nodes_.size());
  const std::uint32_t first = n.first, count = n.count;
  nodes_.resize(nodes_.size() + 2);
  nodes_[nodes_.size() - 2].first = first;
  nodes_[nodes_.size() - 2].count = half;
  nodes_.back().first = first + half;
  nodes_.back().count = count - half;
}

float BodySurface::squared_distance_to(const Vector3f& point, std::size_t triangle) const {
  const auto at = [&](std::size_t k) -> Eigen::Vector3d { return corner(triangle, k).cast<double>(); };
  return float(cook::squared_distance(point.cast<double>(), at(0), at(1), at(2)));
}

std::uint32_t BodySurface::search(const Vector3f& point, float& least) const {
  std::uint32_t found = kNone;
  std::array<std::pair<std::uint32_t, float>, kDeepest> open{};  // nodes, and the squared distances of their boxes
  std::size_t count = 1;
  while (count > 0) {
    const auto [next, away] = open[--count];
    if (away >= least) continue;
    const Node& node = nodes_[next];
    if (node.children != 0) {
      const float first = nodes_[node.children].box.squaredExteriorDistance(point);
      const float second = nodes_[node.children + 1].box.squaredExteriorDistance(point);
      open[count++] = {node.children + (first <= second ? 1 : 0), std::max(first, second)};
      open[count++] = {node.children + (first <= second ? 0 : 1), std::min(first, second)};  // looked at first
      continue;
    }
    for (std::uint32_t t = node.first; t < node.first + node.count; ++t) {
      const float distance = squared_distance_to(point, t);
      if (distance >= least) continue;
      least = distance;
      found = t;
    }
  }
  return found;
}

float BodySurface::distance(const Vector3f& point, float most) const {
  float least = most * most;
  return search(point, least) == kNone ? most : std::sqrt(least);
}

BodySurface::Nearest BodySurface::nearest(const Vector3f& point, std::uint32_t guess) const {
  float least = squared_distance_to(point, guess);
  const std::uint32_t found = search(point, least);
  return {found == kNone ? guess : found, std::sqrt(least)};
}

bool BodySurface::is_inside(const Vector3f& point) const {
  float angle = 0;
  std::array<std::uint32_t, kDeepest> open{};
  std::size_t count = 1;
  while (count > 0) {
    const Node& node = nodes_[open[--count]];
    const Vector3f from = node.middle - point;
    const float away = from.norm();
    if (away > kFar * node.radius) {
      angle += node.area.dot(from) / (away * away * away);
    } else if (node.children != 0) {
      open[count++] = node.children;
      open[count++] = node.children + 1;
    } else {
      for (std::size_t t = node.first; t < node.first + node.count; ++t)
        angle += solid_angle(corner(t, 0) - point, corner(t, 1) - point, corner(t, 2) - point);
    }
  }
  return angle > 2 * std::numbers::pi_v<float>;
}

}  // namespace coif::grow
