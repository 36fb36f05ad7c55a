#include "base/srgb.h"
#include "cook/texture/vertex_colors.h"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector2f;
using Eigen::Vector4d;

constexpr std::uint32_t kSquareSide = 32;  ///< Texels, of which the outermost two on each side repeat the edge.
constexpr std::uint32_t kSquareMargin = 2;
constexpr std::size_t kMostSquares = 64;
constexpr double kFlat = 0.01;  ///< Largest root mean square distance from a plane, in linear numbers.

/// Colours of some islands: their sums, from which the plane that lies nearest to all follows.
struct ColorPlane {
  double count = 0;
  Vector4d sum = Vector4d::Zero();
  Matrix4d squares = Matrix4d::Zero();

  void add(const Vector4d& color) {
    ++count;
    sum += color;
    squares += color * color.transpose();
  }
  [[nodiscard]] ColorPlane with(const ColorPlane& other) const {
    return {count + other.count, sum + other.sum, squares + other.squares};
  }
  [[nodiscard]] Vector4d mean() const { return sum / std::max(count, 1.0); }
  [[nodiscard]] Eigen::SelfAdjointEigenSolver<Matrix4d> axes() const {
    return Eigen::SelfAdjointEigenSolver<Matrix4d>(squares / std::max(count, 1.0) - mean() * mean().transpose());
  }
  /// Root mean square distance of the colours from the plane.
  [[nodiscard]] double off_plane() const {
    const Vector4d spread = axes().eigenvalues();  // ascending
    return std::sqrt(std::max(0.0, spread[0]) + std::max(0.0, spread[1]));
  }
};

/// The planes of all islands, and the plane of each island's colours.
struct ColorPlanes {
  std::vector<ColorPlane> planes;
  std::vector<std::uint32_t> of_island;
  double worst = 0;  ///< ColorPlane::off_plane() of the planes.
};

ColorPlanes find_planes(const HairMesh& hair, std::span<const std::vector<std::size_t>> islands) {
  ColorPlanes out;
  for (const std::vector<std::size_t>& island : islands) {
    ColorPlane own;
    for (const std::size_t t : island) {
      for (std::size_t k = 0; k < 3; ++k) own.add(hair.colors[hair.triangles[3 * t + k]].cwiseMin(1.0f).cast<double>());
    }
    std::size_t best = 0;
    double least = INFINITY;
    for (std::size_t p = 0; p < out.planes.size() && least > kFlat; ++p) {
      const double off = out.planes[p].with(own).off_plane();
      if (off < least) {
        least = off;
        best = p;
      }
    }
    if (least > kFlat && out.planes.size() < kMostSquares) {
      best = out.planes.size();
      out.planes.emplace_back();
    }
    out.planes[best] = out.planes[best].with(own);
    out.of_island.push_back(std::uint32_t(best));
  }
  for (const ColorPlane& plane : out.planes) out.worst = std::max(out.worst, plane.off_plane());
  return out;
}

/// A plane's part of the image: its axes, and how far its colours reach along them.
struct ColorSquare {
  Vector4d mean = Vector4d::Zero();
  Vector4d axis[2] = {Vector4d::Zero(), Vector4d::Zero()};
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};

  [[nodiscard]] double at(const Vector4d& color, int k) const { return axis[k].dot(color - mean); }
  /// 0..1 within the reach.
  [[nodiscard]] double share(const Vector4d& color, int k) const {
    return high[k] - low[k] > 1.0e-9 ? (at(color, k) - low[k]) / (high[k] - low[k]) : 0.5;
  }
};

std::vector<ColorSquare> squares_of(const HairMesh& hair, const ColorPlanes& planes,
                                    std::span<const std::uint32_t> plane_of_vertex) {
  std::vector<ColorSquare> squares;
  for (const ColorPlane& plane : planes.planes) {
    ColorSquare square;
    square.mean = plane.mean();
    const Matrix4d vectors = plane.axes().eigenvectors();
    square.axis[0] = vectors.col(3);
    square.axis[1] = vectors.col(2);
    squares.push_back(square);
  }
  for (std::size_t v = 0; v < hair.colors.size(); ++v) {
    if (plane_of_vertex[v] == importer::kNoIndex) continue;
    ColorSquare& square = squares[plane_of_vertex[v]];
    for (int k = 0; k < 2; ++k) {
      const double along = square.at(hair.colors[v].cwiseMin(1.0f).cast<double>(), k);
      square.low[k] = std::min(square.low[k], along);
      square.high[k] = std::max(square.high[k], along);
    }
  }
  return squares;
}

constexpr double kSquareReach =
    double{kSquareSide - 2 * kSquareMargin - 1};  ///< From the first texel's middle to the last's.

std::uint8_t stored(double linear) {
  return std::uint8_t(std::lround(std::clamp(encode_srgb(linear), 0.0, 1.0) * 255));
}

void draw_square(const ColorSquare& square, std::uint32_t left, std::uint32_t top, Image& image) {
  for (std::uint32_t y = 0; y < kSquareSide; ++y) {
    for (std::uint32_t x = 0; x < kSquareSide; ++x) {
      Vector4d color = square.mean;
      const double at[2] = {double(x), double(y)};
      for (int k = 0; k < 2; ++k) {
        const double share = std::clamp((at[k] - kSquareMargin) / kSquareReach, 0.0, 1.0);
        if (square.high[k] > square.low[k])
          color += (square.low[k] + share * (square.high[k] - square.low[k])) * square.axis[k];
      }
      color = color.cwiseMax(0.0).cwiseMin(1.0);
      std::uint8_t* const texel = &image.texels[4 * (std::size_t(top + y) * image.width + left + x)];
      for (int k = 0; k < 3; ++k) texel[k] = stored(color[k]);
      texel[3] = std::uint8_t(std::lround(color.w() * 255));
    }
  }
}

std::uint32_t power_of_two(std::uint32_t least) {
  std::uint32_t power = 1;
  while (power < least) power *= 2;
  return power;
}

}  // namespace

Image make_color_squares(HairMesh& hair, Findings& findings) {
  const auto islands = color_islands(hair, [](std::size_t) { return true; });
  const ColorPlanes planes = find_planes(hair, islands);
  std::vector<std::uint32_t> plane_of_vertex(hair.positions.size(), importer::kNoIndex);
  for (std::size_t i = 0; i < islands.size(); ++i) {
    for (const std::size_t t : islands[i]) {
      for (std::size_t k = 0; k < 3; ++k) plane_of_vertex[hair.triangles[3 * t + k]] = planes.of_island[i];
    }
  }
  const std::vector<ColorSquare> squares = squares_of(hair, planes, plane_of_vertex);
  const std::uint32_t columns = power_of_two(std::uint32_t(std::ceil(std::sqrt(double(squares.size())))));
  const std::uint32_t rows = power_of_two((std::uint32_t(squares.size()) + columns - 1) / columns);
  Image image{columns * kSquareSide, rows * kSquareSide, 4, {}};
  image.texels.assign(4 * image.texel_count(), 255);
  for (std::uint32_t s = 0; s < squares.size(); ++s) {
    draw_square(squares[s], s % columns * kSquareSide, s / columns * kSquareSide, image);
  }
  hair.uvs.assign(hair.positions.size(), Vector2f(0.5f, 0.5f));
  for (std::size_t v = 0; v < hair.colors.size(); ++v) {
    const std::uint32_t s = plane_of_vertex[v];
    if (s == importer::kNoIndex) continue;
    const Vector4d color = hair.colors[v].cwiseMin(1.0f).cast<double>();
    const std::uint32_t corner[2] = {s % columns * kSquareSide, s / columns * kSquareSide};
    for (int k = 0; k < 2; ++k) {
      const double texel = corner[k] + kSquareMargin + 0.5 + squares[s].share(color, k) * kSquareReach;
      hair.uvs[v][k] = float(texel / (k == 0 ? image.width : image.height));
    }
  }
  findings.note(
      fmt::format("vertex colours are kept in an image of {} x {} texels, since the hair has no texture coordinates",
                  image.width, image.height));
  if (planes.worst > 2 * kFlat) {
    findings.warn("C152", fmt::format("the hair has no texture coordinates, and its vertex colours vary more than an "
                                      "image of them can hold: they "
                                      "are off by {:.0f} of 255; unwrap the hair",
                                      planes.worst * 255));
  }
  hair.colors.clear();
  return image;
}

}  // namespace coif::cook
