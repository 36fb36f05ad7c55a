#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// Texels of RG11 EAC, read one by one as the Khronos Data Format Specification says; apart from our encoder and
/// decoder. 0..2047 of the texel at (x, y) of an image `width` texels wide.
inline int eac_rg11_value(std::span<const std::uint8_t> bytes, std::uint32_t width, std::uint32_t x, std::uint32_t y,
                          int channel) {
  constexpr int kModifier[16][8] = {
      {-3, -6, -9, -15, 2, 5, 8, 14}, {-3, -7, -10, -13, 2, 6, 9, 12}, {-2, -5, -8, -13, 1, 4, 7, 12},
      {-2, -4, -6, -13, 1, 3, 5, 12}, {-3, -6, -8, -12, 2, 5, 7, 11},  {-3, -7, -9, -11, 2, 6, 8, 10},
      {-4, -7, -8, -11, 3, 6, 7, 10}, {-3, -5, -8, -11, 2, 4, 7, 10},  {-2, -6, -8, -10, 1, 5, 7, 9},
      {-2, -5, -8, -10, 1, 4, 7, 9},  {-2, -4, -8, -10, 1, 3, 7, 9},   {-2, -5, -7, -10, 1, 4, 6, 9},
      {-3, -4, -7, -10, 2, 3, 6, 9},  {-1, -2, -3, -10, 0, 1, 2, 9},   {-4, -6, -8, -9, 3, 5, 7, 8},
      {-3, -5, -7, -9, 2, 4, 6, 8},
  };
  const std::size_t block = std::size_t(y / 4) * ((width + 3) / 4) + x / 4;
  const std::uint8_t* half = &bytes[block * 16 + std::size_t(channel) * 8];
  const std::uint32_t texel = x % 4 * 4 + y % 4;
  const std::uint32_t first_bit = 16 + 3 * texel;
  int index = 0;
  for (std::uint32_t bit = first_bit; bit < first_bit + 3; ++bit)
    index = index * 2 + (half[bit / 8] >> (7 - bit % 8) & 1);
  const int modifier = kModifier[half[1] & 15][index], multiplier = half[1] >> 4;
  const int value = half[0] * 8 + 4 + (multiplier == 0 ? modifier : modifier * multiplier * 8);
  return std::clamp(value, 0, 2047);
}

}  // namespace coif
