#pragma once

#include <cstdint>

namespace coif {

/// The channel of an image that holds a single number. kAuto: alpha if it carries information, else luminance.
enum class TextureChannel : std::uint8_t { kAuto, kRed, kGreen, kBlue, kAlpha, kLuminance };

}  // namespace coif
