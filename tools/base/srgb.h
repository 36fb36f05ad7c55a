#pragma once

#include <cmath>
#include <concepts>

namespace coif {

// The transfer curve of sRGB (IEC 61966-2-1), 0..1 on both sides.

template <std::floating_point Number>
[[nodiscard]] Number decode_srgb(Number encoded) {
  return encoded <= Number(0.04045) ? encoded / Number(12.92)
                                    : std::pow((encoded + Number(0.055)) / Number(1.055), Number(2.4));
}

template <std::floating_point Number>
[[nodiscard]] Number encode_srgb(Number linear) {
  return linear <= Number(0.0031308) ? Number(12.92) * linear
                                     : Number(1.055) * std::pow(linear, Number(1) / Number(2.4)) - Number(0.055);
}

}  // namespace coif
