#include "cook/texture/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace {

// A few kilobytes of PNG may unpack to gigabytes without an end; the decoder takes a refused block as its end. Twice
// the largest image, since buffers of unknown size grow by doubling.
constexpr std::size_t kMaxBlock = std::size_t{2} * 4 * coif::cook::kMaxImageTexels + (1 << 20);

void* allocate_block(std::size_t bytes) { return bytes <= kMaxBlock ? std::malloc(bytes) : nullptr; }
void* resize_block(void* block, std::size_t bytes) { return bytes <= kMaxBlock ? std::realloc(block, bytes) : nullptr; }

}  // namespace

// The one home of this header.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_MAX_DIMENSIONS (1 << 24)  // Larger images get a message below; stb must not refuse them as no image.
#define STBI_MALLOC(bytes) allocate_block(bytes)
#define STBI_REALLOC(block, bytes) resize_block(block, bytes)
#define STBI_FREE(block) std::free(block)
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#include <stb/stb_image.h>

namespace coif::cook {
namespace {

constexpr int kRgba = 4;

tl::unexpected<std::string> unreadable() {
  return tl::unexpected(fmt::format("cannot read the image ({}); save it as PNG", stbi_failure_reason()));
}

}  // namespace

tl::expected<Image, std::string> decode_texels(std::span<const std::uint8_t> bytes) {
  if (is_webp(bytes)) return decode_webp(bytes);
  if (std::string kind = foreign_kind(bytes); !kind.empty()) return tl::unexpected(std::move(kind));
  const int size = int(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0) return unreadable();
  if (std::string fault = size_fault(width, height); !fault.empty()) return tl::unexpected(std::move(fault));
  const std::unique_ptr<stbi_uc, void (*)(void*)> data(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, kRgba), stbi_image_free);
  if (!data) return unreadable();
  Image image{std::uint32_t(width), std::uint32_t(height), kRgba, {}};
  image.texels.assign(data.get(), data.get() + image.texel_count() * kRgba);
  return image;
}

}  // namespace coif::cook
