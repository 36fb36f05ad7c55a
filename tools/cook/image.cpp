#include "cook/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

// The one home of this header.
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#define STB_IMAGE_RESIZE_STATIC
#include <stb/stb_image_resize.h>

namespace coif {

tl::expected<Image, std::string> read_image(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return tl::unexpected(std::string("no such file"));
  if (std::filesystem::file_size(path, error) > kMaxImageBytes) {
    return tl::unexpected(fmt::format("larger than {} MiB; reduce it", kMaxImageBytes >> 20));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) return tl::unexpected(fmt::format("cannot open: {}", std::strerror(errno)));
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  return decode_image({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

Image shrink(const Image& image, std::uint32_t width, std::uint32_t height, TexelMeaning meaning) {
  Image result{width, height, image.channels, {}};
  result.texels.resize(result.texel_count() * image.channels);
  const bool color = meaning == TexelMeaning::kSrgbColorAlpha;
  stbir_resize_uint8_generic(image.texels.data(), int(image.width), int(image.height), 0, result.texels.data(),
                             int(width), int(height), 0, int(image.channels), color ? 3 : STBIR_ALPHA_CHANNEL_NONE, 0,
                             STBIR_EDGE_WRAP, STBIR_FILTER_BOX, color ? STBIR_COLORSPACE_SRGB : STBIR_COLORSPACE_LINEAR,
                             nullptr);
  return result;
}

namespace {

Image half(const Image& image, TexelMeaning meaning) {
  return shrink(image, std::max(1u, image.width / 2), std::max(1u, image.height / 2), meaning);
}

}  // namespace

Image reduce(Image image, std::uint32_t max_size, TexelMeaning meaning) {
  while (std::max(image.width, image.height) > max_size) image = half(image, meaning);
  return image;
}

std::vector<Image> make_mips(Image image, std::uint32_t max_size, TexelMeaning meaning) {
  std::vector<Image> mips;
  mips.push_back(reduce(std::move(image), max_size, meaning));
  while (mips.back().width > 1 || mips.back().height > 1) mips.push_back(half(mips.back(), meaning));
  return mips;
}

}  // namespace coif
