#include "cook/texture/texture_atlas.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace coif {
namespace {

using Eigen::Vector2d;

constexpr double kOnBorder = 0.02;     ///< Texels: how far from where texels meet an edge of a triangle may lie.
constexpr double kMostOfAnEdge = 8192;  ///< Texels; longer ones repeat the image.

std::size_t wrapped_texel(double place, std::uint32_t size) {
  return std::min(std::size_t(place - std::floor(place / size) * size), std::size_t(size) - 1);
}

/// Where two rows or columns of texels meet along an edge of a triangle.
struct Border {
  int axis = 0;         ///< Across it: 0 for U.
  double outside = 0;   ///< The texel beyond it, along that axis, and
  double inside = 0;    ///< the one before it.
  double low = 0;       ///< Along the other axis, texels.
  double high = 0;
};

std::optional<Border> border_of(const Vector2d& a, const Vector2d& b, const Vector2d& third) {
  for (int axis = 0; axis < 2; ++axis) {
    const double line = std::round(a[axis]);
    const bool lies_on_it = std::abs(a[axis] - line) <= kOnBorder && std::abs(b[axis] - line) <= kOnBorder;
    const double along = std::abs(a[1 - axis] - b[1 - axis]), across = third[axis] - line;
    if (!lies_on_it || std::abs(across) <= kOnBorder || !(along > 0) || along > kMostOfAnEdge) continue;
    const bool is_above = across > 0;
    return Border{axis, is_above ? line - 1 : line, is_above ? line : line - 1,
                  std::floor(std::min(a[1 - axis], b[1 - axis])), std::ceil(std::max(a[1 - axis], b[1 - axis]))};
  }
  return std::nullopt;
}

/// One texel farther at both ends, where two borders meet.
void repeat_across(const Border& border, const Image& used, Image& image) {
  const std::uint32_t size[2] = {image.width, image.height};
  const auto index = [&](double across, double along) {
    std::size_t at[2];
    at[border.axis] = wrapped_texel(across, size[border.axis]);
    at[1 - border.axis] = wrapped_texel(along, size[1 - border.axis]);
    return at[1] * image.width + at[0];
  };
  for (double along = border.low - 1; along < border.high + 1; ++along) {
    const std::size_t from = index(border.inside, along), to = index(border.outside, along);
    if (used.texels[to] == 0)
      std::copy_n(&image.texels[from * image.channels], image.channels, &image.texels[to * image.channels]);
  }
}

}  // namespace

void repeat_edges(const HairMesh& hair, const Image& used, Image& image) {
  const Vector2d size(image.width, image.height);
  for (const int axis : {0, 1}) {
    for (std::size_t t = 0; t < hair.triangles.size(); t += 3) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = [&](std::size_t i) -> Vector2d {
          return hair.uvs[hair.triangles[t + (k + i) % 3]].cast<double>().cwiseProduct(size);
        };
        const auto border = border_of(at(0), at(1), at(2));
        if (border && border->axis == axis) repeat_across(*border, used, image);
      }
    }
  }
}

}  // namespace coif
