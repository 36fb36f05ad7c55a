#pragma once

#include <cstdint>

namespace coif {

/// Where in an image a single number stands. kAuto: in alpha where that says anything, else in the luminance.
enum class TextureChannel : std::uint8_t { kAuto, kRed, kGreen, kBlue, kAlpha, kLuminance };

}  // namespace coif
