#pragma once

#include "write/asset_writer.h"

#include <coif/asset.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// A square of one colour that faces +Z, one patch of a made-up asset.
struct DrawnCard {
  std::array<float, 3> center{0, 0, 0};
  float half_size = 0.5f;
  bool turned = false;  ///< Its front side looks towards -Z.
  std::array<float, 3> normal{0, 0, 1};
  std::array<float, 3> tangent{0, -1, 0};
  std::array<std::uint8_t, 4> rgba{255, 255, 255, 255};  ///< sRGB.
  std::array<std::uint8_t, 2> shift_mask{128, 255};
  SkinRecord skin{{0, 0, 0, 0}, {255, 0, 0, 0}};
};

/// White, double-sided, ambient light 1, no highlights: colours appear as the texture has them. Opaque from alpha 0.9
/// on, nothing below 0.1.
[[nodiscard]] MaterialRecord plain_material();

/// `bones` rigid bones; the cards are patches in this order.
[[nodiscard]] AssetContents card_contents(std::span<const DrawnCard> cards, std::uint32_t bones = 1);

/// For AssetContents::order_views: from behind the second of two orders, from in front the first.
[[nodiscard]] std::vector<std::uint8_t> second_from_behind();

/// An open asset with the memory it lives in.
class DrawnAsset {
 public:
  /// Fails the running test when the contents do not open.
  explicit DrawnAsset(std::span<const std::byte> bytes);
  explicit DrawnAsset(const AssetContents& contents) : DrawnAsset(write_asset(contents)) {}
  [[nodiscard]] const Asset& operator*() const { return asset_; }

 private:
  struct alignas(64) Block {
    std::byte bytes[64];
  };
  std::vector<Block> memory_;
  Asset asset_;
};

}  // namespace coif
