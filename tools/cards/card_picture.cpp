#include "cards/card_picture.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif {
namespace {

constexpr int kCardSide = 4;  // samples of a pixel, each way
constexpr std::uint32_t kCardBand = 16;

/// A corner in samples, its depth, and its place in the texture, 0..1 both.
struct Corner {
  float x, y, depth, u, v;
};
struct CardTriangle {
  Corner corner[3];
  std::uint32_t texture;
};

std::vector<CardTriangle> triangles_of(std::span<const Wisp> wisps, std::span<const CardStrip> strips,
                                       const PictureFrame& frame) {
  std::vector<CardTriangle> triangles;
  for (std::uint32_t s = 0; s < strips.size(); ++s) {
    const Ribbon& ribbon = wisps[strips[s].wisp].ribbon;
    std::vector<std::array<Corner, 2>> edges;
    for (const std::uint8_t station : strips[s].stations) {
      std::array<Corner, 2> corners{};
      const auto ends = edge_at(ribbon, station);
      for (std::size_t side = 0; side < 2; ++side) {
        const Eigen::Vector3f place = frame.place(ends[side]);
        corners[side] = {kCardSide * place.x(), kCardSide * place.y(), place.z(), float(side),
                         float(station) / float(Ribbon::kStations - 1)};
      }
      edges.push_back(corners);
    }
    for (std::size_t k = 1; k < edges.size(); ++k) {
      triangles.push_back({{edges[k - 1][0], edges[k - 1][1], edges[k][0]}, s});
      triangles.push_back({{edges[k - 1][1], edges[k][1], edges[k][0]}, s});
    }
  }
  return triangles;
}

class CardBand {
 public:
  CardBand(std::uint32_t width, std::uint32_t first_row, std::uint32_t rows)
      : width_(int(width)),
        first_(int(first_row)),
        rows_(int(rows)),
        clear_(std::size_t(width) * rows, 1.0f),
        depth_(clear_.size(), std::numeric_limits<float>::infinity()) {}

  void draw(const CardTriangle& triangle, const CardTexture& texture) {
    const auto& [a, b, c] = triangle.corner;
    const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (std::abs(area) < 1e-12f) return;
    const int top = std::max(int(std::ceil(std::min({a.y, b.y, c.y}) - 0.5f)), first_);
    const int bottom = std::min(int(std::floor(std::max({a.y, b.y, c.y}) - 0.5f)), first_ + rows_ - 1);
    const int left = std::max(int(std::ceil(std::min({a.x, b.x, c.x}) - 0.5f)), 0);
    const int right = std::min(int(std::floor(std::max({a.x, b.x, c.x}) - 0.5f)), width_ - 1);
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const float px = float(x) + 0.5f, py = float(y) + 0.5f;
        const float wb = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / area;
        const float wc = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) / area;
        if (wb < 0 || wc < 0 || wb + wc > 1) continue;
        const float wa = 1 - wb - wc;
        const float alpha = opacity(texture, wa * a.u + wb * b.u + wc * c.u, wa * a.v + wb * b.v + wc * c.v);
        const std::size_t at = std::size_t(y - first_) * std::size_t(width_) + std::size_t(x);
        clear_[at] *= 1 - alpha;
        if (alpha >= 0.5f) depth_[at] = std::min(depth_[at], wa * a.depth + wb * b.depth + wc * c.depth);
      }
    }
  }

  void develop(std::uint32_t first_row, std::uint32_t rows, HairPicture& picture) const {
    for (std::uint32_t y = 0; y < rows; ++y) {
      for (std::uint32_t x = 0; x < picture.size; ++x) {
        float covered = 0, depth = 0;
        int deep = 0;
        for (int s = 0; s < kCardSide * kCardSide; ++s) {
          const std::size_t at = (std::size_t(y) * kCardSide + std::size_t(s / kCardSide)) * std::size_t(width_) +
                                 std::size_t(x) * kCardSide + std::size_t(s % kCardSide);
          covered += 1 - clear_[at];
          if (!std::isfinite(depth_[at])) continue;
          depth += depth_[at];
          ++deep;
        }
        const std::size_t at = std::size_t(first_row + y) * picture.size + x;
        picture.coverage[at] = covered / float(kCardSide * kCardSide);
        if (deep > 0) picture.depth[at] = depth / float(deep);
      }
    }
  }

 private:
  static float opacity(const CardTexture& texture, float u, float v) {
    const float x = std::clamp(u * float(texture.width) - 0.5f, 0.0f, float(texture.width - 1));
    const float y = std::clamp(v * float(texture.height) - 0.5f, 0.0f, float(texture.height - 1));
    const auto x0 = std::size_t(x), y0 = std::size_t(y);
    const std::size_t x1 = std::min<std::size_t>(x0 + 1, texture.width - 1),
                      y1 = std::min<std::size_t>(y0 + 1, texture.height - 1);
    const float fx = x - float(x0), fy = y - float(y0);
    const auto at = [&](std::size_t column, std::size_t row) { return texture.opacity[row * texture.width + column]; };
    return (1 - fy) * ((1 - fx) * at(x0, y0) + fx * at(x1, y0)) + fy * ((1 - fx) * at(x0, y1) + fx * at(x1, y1));
  }

  int width_, first_, rows_;
  std::vector<float> clear_, depth_;
};

}  // namespace

HairPicture draw_cards(std::span<const Wisp> wisps, std::span<const CardStrip> strips,
                       std::span<const CardTexture> textures, const PictureFrame& frame, unsigned threads) {
  HairPicture picture = blank_picture(frame.size);
  const auto triangles = triangles_of(wisps, strips, frame);
  parallel_for((frame.size + kCardBand - 1) / kCardBand, threads, [&](std::size_t b) {
    const auto first = std::uint32_t(b * kCardBand), rows = std::min(kCardBand, frame.size - first);
    CardBand band(frame.size * kCardSide, first * kCardSide, rows * kCardSide);
    for (const CardTriangle& triangle : triangles) band.draw(triangle, textures[triangle.texture]);
    band.develop(first, rows, picture);
  });
  return picture;
}

}  // namespace coif
