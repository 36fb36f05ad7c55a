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

/// A texture's value between the four texels around a place, filtered as by a graphics card.
template <typename Texel>
[[nodiscard]] Texel bilinear(const CardSurface& surface, const std::vector<Texel>& texels, const Eigen::Vector2f& uv) {
  const float x = std::clamp(uv.x() * float(surface.width) - 0.5f, 0.0f, float(surface.width - 1));
  const float y = std::clamp(uv.y() * float(surface.height) - 0.5f, 0.0f, float(surface.height - 1));
  const auto x0 = std::size_t(x), y0 = std::size_t(y);
  const std::size_t x1 = std::min<std::size_t>(x0 + 1, surface.width - 1),
                    y1 = std::min<std::size_t>(y0 + 1, surface.height - 1);
  const float fx = x - float(x0), fy = y - float(y0);
  const auto at = [&](std::size_t column, std::size_t row) { return texels[row * surface.width + column]; };
  const Texel above = (1 - fx) * at(x0, y0) + fx * at(x1, y0), below = (1 - fx) * at(x0, y1) + fx * at(x1, y1);
  return (1 - fy) * above + fy * below;
}

}  // namespace coif::cards
