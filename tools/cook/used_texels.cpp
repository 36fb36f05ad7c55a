#include "cook/used_texels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace coif {
namespace {

using Eigen::Vector2d;
using Corners = std::array<Vector2d, 3>;  ///< In texels.

/// A triangle that repeats the texture this often shows all of it, whatever its shape leaves out of one repeat.
constexpr double kManyRepeats = 4;

struct Range {
  double low = INFINITY;
  double high = -INFINITY;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Where the triangle is between the rows `top` and `top + 1`; empty (low > high) where it is not.
Range columns_in_row(const Corners& corners, double top) {
  Range range;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector2d &a = corners[k], &b = corners[(k + 1) % 3];
    if (a.y() >= top && a.y() <= top + 1) range.include(a.x());
    for (const double line : {top, top + 1}) {
      if (std::min(a.y(), b.y()) > line || std::max(a.y(), b.y()) < line || a.y() == b.y()) continue;
      range.include(a.x() + (b.x() - a.x()) * (line - a.y()) / (b.y() - a.y()));
    }
  }
  return range;
}

std::uint32_t wrapped(double coordinate, std::uint32_t size) {
  return std::min(std::uint32_t(coordinate - std::floor(coordinate / size) * size), size - 1);
}

void mark_row(double low, double high, std::uint32_t y, Image& used) {
  std::uint8_t* row = &used.texels[std::size_t(y) * used.width];
  const auto count = std::uint32_t(std::min<double>(std::floor(high) - std::floor(low) + 1, used.width));
  const std::uint32_t first = wrapped(std::floor(low), used.width);
  for (std::uint32_t i = 0; i < count; ++i) row[(first + i) % used.width] = 255;
}

/// Returns false where no other triangle can add to what is used: broken files repeat a large texture in every one.
bool mark_triangle(const Corners& corners, Image& used) {
  Range x, y;
  for (const Vector2d& corner : corners) {
    if (!corner.allFinite()) return true;
    x.include(corner.x());
    y.include(corner.y());
  }
  if (x.high - x.low > kManyRepeats * used.width || y.high - y.low > kManyRepeats * used.height) {
    std::ranges::fill(used.texels, std::uint8_t{255});
    return false;
  }
  for (double row = std::floor(y.low); row <= y.high; ++row) {
    const Range columns = columns_in_row(corners, row);
    if (columns.low <= columns.high) mark_row(columns.low, columns.high, wrapped(row, used.height), used);
  }
  return true;
}

}  // namespace

Image used_texels(const HairMesh& hair, std::uint32_t width, std::uint32_t height) {
  Image used{width, height, 1, std::vector<std::uint8_t>(std::size_t(width) * height, 0)};
  if (hair.uvs.empty()) return used;
  const Vector2d size(width, height);
  for (std::size_t t = 0; t < hair.triangles.size(); t += 3) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = hair.uvs[hair.triangles[t + k]].cast<double>().cwiseProduct(size);
    }
    if (!mark_triangle(corners, used)) break;
  }
  return used;
}

}  // namespace coif
