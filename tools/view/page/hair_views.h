#pragma once
// What of the hair the page shows beside itself: its patches, its layers, its order, and what the colours of these
// mean.

#include <coif/asset.h>

#include <array>
#include <cstdint>
#include <string>

namespace coif::view {

enum class HairView : std::uint8_t {
  kHair,      ///< As a game draws it.
  kPatches,   ///< Each in its colour, without its texture's holes.
  kOverdraw,  ///< How many layers lie on each other.
  kOrder,     ///< Which triangles are drawn before which.
};

/// Of the choice's number.
[[nodiscard]] HairView hair_view_of(float choice);

/// sRGB. None of those below is so bright that develop() bends it: what the legend says is what is seen.
using ScreenColor = std::array<std::uint8_t, 3>;

/// Of 1, 2, up to 4, up to 8, up to 16, up to 32 and more layers.
inline constexpr std::array<ScreenColor, 7> kLayerColors{{{0x2c, 0x1e, 0x6e},
                                                          {0x6a, 0x1f, 0x7e},
                                                          {0xa9, 0x2e, 0x6b},
                                                          {0xd4, 0x52, 0x40},
                                                          {0xdc, 0x8c, 0x22},
                                                          {0xde, 0xc2, 0x3c},
                                                          {0xe0, 0xe0, 0xc4}}};

/// Of a triangle; 0: it is drawn first, 1: last.
[[nodiscard]] ScreenColor order_color(double share);

/// Of a patch, by its place in Asset::lod_patches(): as `coif render --component patches` has it, without light.
[[nodiscard]] ScreenColor screen_color_of_patch(std::size_t patch);

/// {"title": "...", "colors": [{"color": "#2c1e6e", "text": "1"}]}; an empty title for kHair.
[[nodiscard]] std::string legend_json(const Asset& asset, HairView view, std::uint32_t lod);

}  // namespace coif::view
