#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace coif::cook {

/// The two kinds of values that a block of EAC may have.
enum class EacValues {
  kElevenBits,  ///< R11 and RG11: 0..2047.
  kAlpha,       ///< RGBA: 0..255.
};

/// One channel of 4 x 4 texels. Texels outside the image repeat one inside, which adds no value to cover.
struct EacBlock {
  std::array<std::int16_t, 16> value;  ///< Column by column, as the format counts.
  int low = INT16_MAX;
  int high = 0;

  void set(std::size_t texel, int to) {
    value[texel] = std::int16_t(to);
    low = to < low ? to : low;
    high = to > high ? to : high;
  }
};

inline constexpr std::size_t kEacBlockBytes = 8;

/// Searches the code that is nearest to the block, and writes its kEacBlockBytes. Source of the layout: Khronos Data
/// Format Specification 1.3, "ETC2 Compressed Texture Image Formats", "Format Unsigned R11 EAC" and "RGBA ETC2".
void encode_eac_block(const EacBlock& block, EacValues values, std::uint8_t* out);

}  // namespace coif::cook
