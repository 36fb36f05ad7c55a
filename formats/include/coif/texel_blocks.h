#pragma once

#include <coif/appearance_records.h>
#include <coif/export.h>

#include <cstddef>

namespace coif {

/// Texels of a block of TexelFormat::kSrgb8Alpha8Etc2, each way, and its bytes.
inline constexpr std::uint32_t kBlockSide = 4;
inline constexpr std::size_t kBlockTexels = 16, kColorBlockBytes = 16;

/// Decodes such a block as the Khronos Data Format Specification 1.3 says ("ETC2 Compressed Texture Image Formats",
/// "Format RGB ETC2" and "RGBA ETC2"), to the bit as drivers do: for renderers without it, and tools. `block` has
/// kColorBlockBytes, of which all values are valid. `rgba`: kBlockTexels times four bytes, rows top to bottom.
COIF_API void decode_color_block(const std::byte* block, std::byte* rgba);

}  // namespace coif
