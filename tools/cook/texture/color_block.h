#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace coif::cook {

/// RGBA of 4 x 4 texels, row by row. Texels outside the image repeat one inside.
using ColorBlock = std::array<std::array<std::uint8_t, 4>, 16>;

/// Encodes colour and alpha as TexelFormat::kSrgb8Alpha8Etc2: coif/texel_blocks.h decodes the 16 bytes that are
/// written. The error of colours counts by alpha, as it is seen; the search leaves out the modes T and H, which gain
/// little where a block has no two hues. Source: Khronos Data Format Specification 1.3, "ETC2 Compressed Texture Image
/// Formats".
void encode_color_block(const ColorBlock& block, std::uint8_t* out);

}  // namespace coif::cook
