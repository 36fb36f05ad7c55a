#include "cook/texture/texture_atlas.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace coif::cook {
namespace {

using Eigen::Vector2d;

constexpr double kOnBorder = 0.02;      ///< Texels: largest distance of a triangle's edge from the line between texels.
constexpr int kRepeated = 8;            ///< Texels: as far as the fourth mip filters.
constexpr double kLeastOfAnEdge = 4;    ///< Texels; shorter edges show nothing.
constexpr double kMostOfAnEdge = 8192;  ///< Texels; longer ones repeat the image.

std::size_t wrapped_texel(double place, std::uint32_t size) {
  return std::min(std::size_t(place - std::floor(place / size) * size), std::size_t(size) - 1);
}

std::optional<TexelBorder> border_of(const Vector2d& a, const Vector2d& b, const Vector2d& third) {
  for (int axis = 0; axis < 2; ++axis) {
    const double line = std::round(a[axis]);
    const bool lies_on_it = std::abs(a[axis] - line) <= kOnBorder && std::abs(b[axis] - line) <= kOnBorder;
    const double along = std::abs(a[1 - axis] - b[1 - axis]), across = third[axis] - line;
    if (!lies_on_it || std::abs(across) <= kOnBorder || !(along >= kLeastOfAnEdge) || along > kMostOfAnEdge) continue;
    const bool is_above = across > 0;
    return TexelBorder{axis, is_above ? line : line - 1, is_above ? -1.0 : 1.0,
                       std::floor(std::min(a[1 - axis], b[1 - axis])), std::ceil(std::max(a[1 - axis], b[1 - axis]))};
  }
  return std::nullopt;
}

class BorderTexels {
 public:
  BorderTexels(const TexelBorder& border, const Image& image) : border_(border), image_(image) {}

  /// `depth` texels beyond the border, at the place `along` it; 0: before it.
  [[nodiscard]] std::size_t index(int depth, double along) const {
    const std::uint32_t size[2] = {image_.width, image_.height};
    std::size_t at[2];
    at[border_.axis] = wrapped_texel(border_.inside + depth * border_.step, size[border_.axis]);
    at[1 - border_.axis] = wrapped_texel(along, size[1 - border_.axis]);
    return at[1] * image_.width + at[0];
  }
  /// The picture ends at the border: the texels on both sides of it differ far more than texels before it do.
  [[nodiscard]] bool breaks_off() const {
    double across = 0, before = 0;
    for (double along = border_.low; along < border_.high; ++along) {
      across += difference(index(0, along), index(1, along));
      before += difference(index(0, along), index(-1, along));
    }
    return across > kBreak * (border_.high - border_.low) && across > kTimesSmoother * before;
  }

 private:
  static constexpr double kBreak = 24;  ///< On average; four channels differ by at most 4 * 255.
  static constexpr double kTimesSmoother = 2;

  [[nodiscard]] double difference(std::size_t a, std::size_t b) const {
    const std::uint8_t *const one = &image_.texels[4 * a], *const other = &image_.texels[4 * b];
    double sum = std::abs(double(one[3]) - double(other[3]));
    for (int c = 0; c < 3; ++c) sum += std::abs(double(one[c]) * one[3] - double(other[c]) * other[3]) / 255;
    return sum;
  }

  const TexelBorder& border_;
  const Image& image_;
};

/// Borders across V come last and reach as far at both ends as beyond, since borders across U may meet them.
void repeat_across(const TexelBorder& border, const Image& used, Image& image) {
  const BorderTexels texels(border, image);
  const int reach = border.axis == 0 ? 0 : kRepeated;
  for (double along = border.low - reach; along < border.high + reach; ++along) {
    const std::size_t from = texels.index(0, along);
    for (int i = 1; i <= kRepeated; ++i) {
      const std::size_t to = texels.index(i, along);
      if (used.texels[to] != 0) break;
      std::copy_n(&image.texels[from * image.channels], image.channels, &image.texels[to * image.channels]);
    }
  }
}

}  // namespace

std::vector<TexelBorder> borders_where_pictures_end(const HairMesh& hair, const Image& painted) {
  std::vector<TexelBorder> borders;
  const Vector2d size(painted.width, painted.height);
  for (std::size_t t = 0; t < hair.triangles.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t i) -> Vector2d {
        return hair.uvs[hair.triangles[t + (k + i) % 3]].cast<double>().cwiseProduct(size);
      };
      const auto border = border_of(at(0), at(1), at(2));
      if (border && BorderTexels(*border, painted).breaks_off()) borders.push_back(*border);
    }
  }
  std::ranges::stable_sort(borders, {}, &TexelBorder::axis);
  return borders;
}

void repeat_edges(std::span<const TexelBorder> borders, const Image& used, Image& image) {
  for (const TexelBorder& border : borders) repeat_across(border, used, image);
}

}  // namespace coif::cook
