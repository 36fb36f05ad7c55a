#pragma once

#include <coif/asset.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif {

/// RGBA of one mip of a base colour texture, rows top to bottom, decoded where it is stored in blocks.
[[nodiscard]] std::vector<std::byte> color_texels(const Asset& asset, const TextureRecord& texture, std::uint32_t mip);

/// Decodes blocks of kSrgb8Alpha8Etc2 of an image of that size.
[[nodiscard]] std::vector<std::byte> decode_color_blocks(const std::byte* blocks, std::uint32_t width,
                                                         std::uint32_t height);

}  // namespace coif
