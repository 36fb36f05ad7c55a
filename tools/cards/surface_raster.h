#pragma once

#include "cards/card_surface.h"
#include "cards/picture_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace coif::cards {

/// A place on a card that a sample sees.
struct SurfacePoint {
  float depth = 0;
  Eigen::Vector2f uv;
  Eigen::Vector3f across, along;  ///< Not unit.
};

/// Some rows of a picture's samples.
struct SampleRows {
  std::uint32_t width = 0, first = 0, count = 0;
};

/// The same picture with `side` times as many pixels in each direction: its samples.
[[nodiscard]] inline PictureFrame finer(PictureFrame frame, int side) {
  frame.size *= std::uint32_t(side);
  frame.pixels_of_metre *= float(side);
  return frame;
}

/// The triangles that reach into each band of `rows` rows, in their order.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> triangles_by_band(const CardSurface& surface,
                                                                        const PictureFrame& frame, std::uint32_t rows);

/// A triangle in a picture: weights of its corners at a pixel.
class SeenTriangle {
 public:
  SeenTriangle(const CardSurface& surface, const PictureFrame& frame, std::uint32_t triangle)
      : vertices_(&surface.triangles[3 * std::size_t(triangle)]) {
    for (std::size_t k = 0; k < 3; ++k) corners_[k] = frame.place(surface.positions[vertices_[k]]);
    const Eigen::Vector3f ab = corners_[1] - corners_[0], ac = corners_[2] - corners_[0];
    area_ = ab.x() * ac.y() - ac.x() * ab.y();
    by_x_ = Eigen::Vector3f(ab.y() - ac.y(), ac.y(), -ab.y()) / area_;
    by_y_ = Eigen::Vector3f(ac.x() - ab.x(), -ac.x(), ab.x()) / area_;
  }

  /// Seen from its edge it covers no sample.
  [[nodiscard]] bool is_seen() const { return std::abs(area_) > 1e-9f; }

  /// Pixels whose middles may be inside: first and last in both directions.
  struct Box {
    int left, right, top, bottom;
  };
  [[nodiscard]] Box box_within(const SampleRows& rows) const {
    const auto [left, right] = std::minmax({corners_[0].x(), corners_[1].x(), corners_[2].x()});
    const auto [top, bottom] = std::minmax({corners_[0].y(), corners_[1].y(), corners_[2].y()});
    return {std::max(int(std::ceil(left - 0.5f)), 0), std::min(int(std::floor(right - 0.5f)), int(rows.width) - 1),
            std::max(int(std::ceil(top - 0.5f)), int(rows.first)),
            std::min(int(std::floor(bottom - 0.5f)), int(rows.first + rows.count) - 1)};
  }

  /// Weights of its three corners at a pixel's middle; outside one is negative.
  [[nodiscard]] Eigen::Vector3f weights(int x, int y) const {
    const Eigen::Vector2f at = Eigen::Vector2f(float(x) + 0.5f, float(y) + 0.5f) - corners_[0].head<2>();
    const float b = by_x_[1] * at.x() + by_y_[1] * at.y(), c = by_x_[2] * at.x() + by_y_[2] * at.y();
    return {1 - b - c, b, c};
  }

  /// First and last pixel of a row between two columns that may be inside; up to a pixel too many.
  [[nodiscard]] std::pair<int, int> span_of(int y, int left, int right) const {
    const Eigen::Vector3f begin = weights(left, y);
    float first = 0, last = float(right - left);
    for (int k = 0; k < 3; ++k) {
      if (by_x_[k] > 0) {
        first = std::max(first, -begin[k] / by_x_[k] - 1);
      } else if (by_x_[k] < 0) {
        last = std::min(last, -begin[k] / by_x_[k] + 1);
      } else if (begin[k] < 0) {
        return {0, -1};
      }
    }
    return first <= last ? std::pair(left + int(first), left + int(last)) : std::pair(0, -1);
  }

  [[nodiscard]] float depth(const Eigen::Vector3f& weights) const {
    return weights.dot(Eigen::Vector3f(corners_[0].z(), corners_[1].z(), corners_[2].z()));
  }
  [[nodiscard]] auto mix(const auto& of_vertices, const Eigen::Vector3f& weights) const {
    return (weights[0] * of_vertices[vertices_[0]] + weights[1] * of_vertices[vertices_[1]] +
            weights[2] * of_vertices[vertices_[2]])
        .eval();
  }

  /// Change of a texture's coordinates from pixel to pixel, in texels: the larger of both ways, by which a graphics
  /// card chooses a mip.
  [[nodiscard]] float texels_of_pixel(const CardSurface& surface) const {
    const Eigen::Vector2f size{float(surface.width), float(surface.height)};
    const auto change = [&](const Eigen::Vector3f& by) { return mix(surface.uvs, by).cwiseProduct(size).norm(); };
    return std::max(change(by_x_), change(by_y_));
  }

 private:
  const std::uint32_t* vertices_;
  Eigen::Vector3f corners_[3];
  float area_ = 0;
  Eigen::Vector3f by_x_, by_y_;  // Change of the weights from pixel to pixel.
};

/// Calls take(x, y, SurfacePoint) for each of the rows' samples in a triangle.
template <typename Take>
void for_each_sample(const CardSurface& surface, const PictureFrame& frame, const SampleRows& rows,
                     std::uint32_t triangle, const Take& take) {
  const SeenTriangle seen(surface, frame, triangle);
  if (!seen.is_seen()) return;
  const auto box = seen.box_within(rows);
  for (int y = box.top; y <= box.bottom; ++y) {
    const auto [first, last] = seen.span_of(y, box.left, box.right);
    for (int x = first; x <= last; ++x) {
      const Eigen::Vector3f weights = seen.weights(x, y);
      if (weights.minCoeff() < 0) continue;
      take(std::uint32_t(x), std::uint32_t(y),
           SurfacePoint{seen.depth(weights), seen.mix(surface.uvs, weights), seen.mix(surface.across, weights),
                        seen.mix(surface.along, weights)});
    }
  }
}

/// A texture's value between the four texels around a place, filtered as by a graphics card. `mip`: of the surface's
/// texture, whose texels these are.
template <typename Texel>
[[nodiscard]] Texel bilinear(const CardSurface& surface, const std::vector<Texel>& texels, const Eigen::Vector2f& uv,
                             std::size_t mip = 0) {
  const std::uint32_t width = std::max(surface.width >> mip, 1u), height = std::max(surface.height >> mip, 1u);
  const float x = std::clamp(uv.x() * float(width) - 0.5f, 0.0f, float(width - 1));
  const float y = std::clamp(uv.y() * float(height) - 0.5f, 0.0f, float(height - 1));
  const auto x0 = std::size_t(x), y0 = std::size_t(y);
  const std::size_t x1 = std::min<std::size_t>(x0 + 1, width - 1), y1 = std::min<std::size_t>(y0 + 1, height - 1);
  const float fx = x - float(x0), fy = y - float(y0);
  const auto at = [&](std::size_t column, std::size_t row) { return texels[row * width + column]; };
  const Texel above = (1 - fx) * at(x0, y0) + fx * at(x1, y0), below = (1 - fx) * at(x0, y1) + fx * at(x1, y1);
  return (1 - fy) * above + fy * below;
}

/// The opacity at a place, by two neighbouring mips. `level`: 0 is the largest, between two the share of the second.
[[nodiscard]] inline float opacity_at(const CardSurface& surface, const Eigen::Vector2f& uv, float level) {
  const auto of_mip = [&](std::size_t mip) {
    return bilinear(surface, mip == 0 ? surface.opacity : surface.smaller_opacity[mip - 1], uv, mip);
  };
  const float clamped = std::clamp(level, 0.0f, float(surface.smaller_opacity.size()));
  const auto mip = std::size_t(clamped);
  const float share = clamped - float(mip);
  return share > 0 ? (1 - share) * of_mip(mip) + share * of_mip(mip + 1) : of_mip(mip);
}

}  // namespace coif::cards
