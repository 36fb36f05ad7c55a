#pragma once
// Other views of the hair on the page: its patches, its layers, its order, and the meaning of their colours.

#include <coif/asset.h>

#include <array>
#include <cstdint>
#include <string>

namespace coif::view {

enum class HairView : std::uint8_t {
  kHair,      ///< As in a game.
  kPatches,   ///< Each in its own colour, without its texture's holes.
  kOverdraw,  ///< The number of layers on each other.
  kOrder,     ///< The order in which triangles are drawn.
};

/// The view with the choice's number.
[[nodiscard]] HairView hair_view_of(float choice);

/// sRGB. All colours below are so dark that develop() does not change them: the legend's colours are those on the
/// screen.
using ScreenColor = std::array<std::uint8_t, 3>;

/// For 1, 2, up to 4, up to 8, up to 16, up to 32 and more layers.
inline constexpr std::array<ScreenColor, 7> kLayerColors{{{0x2c, 0x1e, 0x6e},
                                                          {0x6a, 0x1f, 0x7e},
                                                          {0xa9, 0x2e, 0x6b},
                                                          {0xd4, 0x52, 0x40},
                                                          {0xdc, 0x8c, 0x22},
                                                          {0xde, 0xc2, 0x3c},
                                                          {0xe0, 0xe0, 0xc4}}};

/// The colour of a triangle; 0: it is drawn first, 1: last.
[[nodiscard]] ScreenColor order_color(double share);

/// The colour of a patch, by its place in Asset::lod_patches(): as in `coif render --component patches`, without light.
[[nodiscard]] ScreenColor screen_color_of_patch(std::size_t patch);

/// {"title": "...", "colors": [{"color": "#2c1e6e", "text": "1"}]}; an empty title for kHair.
[[nodiscard]] std::string legend_json(const Asset& asset, HairView view, std::uint32_t lod);

}  // namespace coif::view
