#include "cards/hair_picture.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::cards {
namespace {

constexpr std::uint32_t kBand = 16;  // rows of pixels that are drawn together

constexpr float kNothing = std::numeric_limits<float>::infinity();

/// A piece of a strand in samples: x, y, and depth in metres.
struct Piece {
  Eigen::Vector3f a, b;
  float half_width;  ///< Samples.
  float shade;       ///< shade_of() it.
};

/// The samples of some rows.
class Band {
 public:
  Band(std::uint32_t width, std::uint32_t first_row, std::uint32_t rows)
      : width_(int(width)),
        first_(int(first_row)),
        rows_(int(rows)),
        depth_(std::size_t(width) * rows, kNothing),
        piece_(depth_.size(), 0) {}

  void draw(const Piece& piece, std::uint32_t number) {
    const float h = piece.half_width;
    const int top = std::max(int(std::ceil(std::min(piece.a.y(), piece.b.y()) - h - 0.5f)), first_);
    const int bottom = std::min(int(std::floor(std::max(piece.a.y(), piece.b.y()) + h - 0.5f)), first_ + rows_ - 1);
    const float dx = piece.b.x() - piece.a.x(), dy = piece.b.y() - piece.a.y();
    const float squared = dx * dx + dy * dy;
    for (int y = top; y <= bottom; ++y) {
      const float sy = float(y) + 0.5f;
      const auto [left, right] = reach(piece, sy);
      for (int x = left; x <= right; ++x) {
        const float px = float(x) + 0.5f - piece.a.x(), py = sy - piece.a.y();
        const float t = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0f, 1.0f) : 0.0f;
        const float ox = px - t * dx, oy = py - t * dy;
        if (ox * ox + oy * oy > h * h) continue;
        const float depth = piece.a.z() + t * (piece.b.z() - piece.a.z());
        const std::size_t at = std::size_t(y - first_) * std::size_t(width_) + std::size_t(x);
        if (!(depth < depth_[at])) continue;
        depth_[at] = depth;
        piece_[at] = number;
      }
    }
  }

  [[nodiscard]] float depth(std::size_t x, std::size_t row) const { return depth_[row * std::size_t(width_) + x]; }
  [[nodiscard]] std::uint32_t piece(std::size_t x, std::size_t row) const {
    return piece_[row * std::size_t(width_) + x];
  }

 private:
  /// Columns that the piece may cover in a row of samples.
  [[nodiscard]] std::pair<int, int> reach(const Piece& piece, float y) const {
    const float h = piece.half_width;
    const Eigen::Vector3f& low = piece.a.y() <= piece.b.y() ? piece.a : piece.b;
    const Eigen::Vector3f& high = piece.a.y() <= piece.b.y() ? piece.b : piece.a;
    const float rise = high.y() - low.y();
    // Range of its middle line in the rows that the width reaches from here.
    const float from = rise > 1e-6f ? std::clamp((y - h - low.y()) / rise, 0.0f, 1.0f) : 0.0f;
    const float to = rise > 1e-6f ? std::clamp((y + h - low.y()) / rise, 0.0f, 1.0f) : 1.0f;
    const float x0 = low.x() + from * (high.x() - low.x()), x1 = low.x() + to * (high.x() - low.x());
    return {std::max(int(std::ceil(std::min(x0, x1) - h - 0.5f)), 0),
            std::min(int(std::floor(std::max(x0, x1) + h - 0.5f)), width_ - 1)};
  }

  int width_, first_, rows_;
  std::vector<float> depth_;
  std::vector<std::uint32_t> piece_;
};

/// `side`: samples of a pixel, each way.
std::vector<Piece> pieces_of(const groom::Groom& groom, const PictureFrame& frame, float width, int side) {
  std::vector<Piece> pieces;
  pieces.reserve(groom.points.size());
  const float samples_of_metre = float(side) * frame.pixels_of_metre;
  const auto in_samples = [&](const Eigen::Vector3f& point) {
    const Eigen::Vector3f place = frame.place(point);
    return Eigen::Vector3f(float(side) * place.x(), float(side) * place.y(), place.z());
  };
  for (std::size_t i = 0; i < groom.strand_count(); ++i) {
    for (std::uint32_t p = groom.begin[i]; p + 1 < groom.begin[i + 1]; ++p) {
      const float wide = groom.widths.empty() ? width : 0.5f * (groom.widths[p] + groom.widths[p + 1]);
      const Eigen::Vector3f way = frame.axes * (groom.points[p + 1] - groom.points[p]);
      pieces.push_back({in_samples(groom.points[p]), in_samples(groom.points[p + 1]), 0.5f * wide * samples_of_metre,
                        shade_of(way.normalized())});
    }
  }
  return pieces;
}

/// The pieces that reach into each band.
std::vector<std::vector<std::uint32_t>> by_band(const std::vector<Piece>& pieces, std::size_t bands, int side) {
  std::vector<std::vector<std::uint32_t>> lists(bands);
  const float rows = float(kBand) * float(side);
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    const float top = (std::min(piece.a.y(), piece.b.y()) - piece.half_width) / rows;
    const float bottom = (std::max(piece.a.y(), piece.b.y()) + piece.half_width) / rows;
    if (!(bottom >= 0) || !(top < float(bands))) continue;
    for (auto b = std::size_t(std::max(top, 0.0f)); b < bands && float(b) <= bottom; ++b) lists[b].push_back(i);
  }
  return lists;
}

void develop(const Band& band, const std::vector<Piece>& pieces, std::uint32_t first_row, std::uint32_t rows, int side,
             HairPicture& picture) {
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < picture.size; ++x) {
      int covered = 0;
      float depth = 0, shade = 0;
      for (int s = 0; s < side * side; ++s) {
        const std::size_t sx = std::size_t(x) * std::size_t(side) + std::size_t(s % side),
                          sy = std::size_t(y) * std::size_t(side) + std::size_t(s / side);
        if (band.depth(sx, sy) == kNothing) continue;
        ++covered;
        depth += band.depth(sx, sy);
        shade += pieces[band.piece(sx, sy)].shade;
      }
      const std::size_t at = std::size_t(first_row + y) * picture.size + x;
      picture.coverage[at] = float(covered) / float(side * side);
      if (covered == 0) continue;
      picture.depth[at] = depth / float(covered);
      picture.shade[at] = shade / float(side * side);
    }
  }
}

}  // namespace

HairPicture draw_strands(const groom::Groom& groom, const PictureFrame& frame, float width,
                         const platform::Threads& threads, std::uint32_t side) {
  HairPicture picture = blank_picture(frame.size);
  const std::vector<Piece> pieces = pieces_of(groom, frame, width, int(side));
  const std::size_t bands = (frame.size + kBand - 1) / kBand;
  const auto lists = by_band(pieces, bands, int(side));
  parallel_for(bands, threads, [&](std::size_t b) {
    const auto first = std::uint32_t(b * kBand), rows = std::min(kBand, frame.size - first);
    Band band(frame.size * side, first * side, rows * side);
    for (const std::uint32_t i : lists[b]) band.draw(pieces[i], i);
    develop(band, pieces, first, rows, int(side), picture);
  });
  return picture;
}

}  // namespace coif::cards
