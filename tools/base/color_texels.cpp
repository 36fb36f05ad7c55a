#include "base/color_texels.h"

#include <coif/texel_blocks.h>

#include <algorithm>

namespace coif {

std::vector<std::byte> decode_color_blocks(const std::byte* blocks, std::uint32_t width, std::uint32_t height) {
  constexpr std::size_t kTexelBytes = 4;
  std::vector<std::byte> texels(kTexelBytes * width * height);
  std::byte rgba[kTexelBytes * kBlockTexels];
  for (std::uint32_t top = 0; top < height; top += kBlockSide) {
    for (std::uint32_t left = 0; left < width; left += kBlockSide) {
      decode_color_block(blocks, rgba);
      blocks += kColorBlockBytes;
      const std::size_t columns = std::min(kBlockSide, width - left);
      for (std::uint32_t y = 0; y < std::min(kBlockSide, height - top); ++y) {
        std::copy_n(&rgba[kTexelBytes * kBlockSide * y], kTexelBytes * columns,
                    &texels[kTexelBytes * (std::size_t{top + y} * width + left)]);
      }
    }
  }
  return texels;
}

std::vector<std::byte> color_texels(const Asset& asset, const TextureRecord& texture, std::uint32_t mip) {
  const std::span<const std::byte> stored = asset.texels(texture, mip);
  if (texture.format != TexelFormat::kSrgb8Alpha8Etc2) return {stored.begin(), stored.end()};
  return decode_color_blocks(stored.data(), std::max(texture.width >> mip, 1u), std::max(texture.height >> mip, 1u));
}

}  // namespace coif
