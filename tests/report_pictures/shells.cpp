#include "report_pictures/shells.h"

#include "models/card_asset.h"

#include <Eigen/Geometry>

#include <vector>

namespace coif {
namespace {

constexpr int kDarkAlpha = 127, kBrightAlpha = 129;
constexpr std::uint32_t kTrianglesOfBox = 12;

void add_box(float half, int alpha, std::vector<Card>& cards) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      const Eigen::Vector3f out = side * Eigen::Vector3f::Unit(axis);
      const Eigen::Vector3f right = Eigen::Vector3f::Unit((axis + 1) % 3);
      cards.push_back({half * out, half * right, half * out.cross(right), alpha});
    }
  }
}

/// Texels are alphas from 0 to 255; those of the dark box's cards become dark.
void darken(AssetContents& contents) {
  for (std::size_t texel = 0; texel < contents.texels.size(); texel += 4) {
    const bool is_dark = texel / 4 <= kDarkAlpha;
    for (std::size_t c = 0; c < 3; ++c) contents.texels[texel + c] = std::byte(is_dark ? 20 : 235);
  }
}

}  // namespace

AssetContents shells() {
  std::vector<Card> cards;
  add_box(0.10f, kBrightAlpha, cards);
  add_box(0.06f, kDarkAlpha, cards);
  AssetContents contents = card_contents(cards);
  contents.material.front().flags = 0;
  darken(contents);
  for (float& ambient : contents.material.front().ambient) ambient = 1;
  return contents;
}

AssetContents shells_with_orders() {
  AssetContents contents = shells();
  for (std::uint32_t t = 0; t < 2 * kTrianglesOfBox; ++t) {
    contents.orders.push_back((t + kTrianglesOfBox) % (2 * kTrianglesOfBox));
  }
  contents.order_views.assign(kViewCells, 1);
  return contents;
}

}  // namespace coif
