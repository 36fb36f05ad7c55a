#include "cook/texture/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include <webp/decode.h>

namespace coif::cook {
namespace {

constexpr std::uint32_t kRgbaChannels = 4;

bool has_at(std::span<const std::uint8_t> bytes, std::size_t at, std::string_view mark) {
  return bytes.size() >= at + mark.size() &&
         std::ranges::equal(bytes.subspan(at, mark.size()), mark, {}, {}, [](char c) { return std::uint8_t(c); });
}

/// How files of a kind begin, and a command that makes a PNG of them. ImageMagick reads all but the first two.
struct ForeignKind {
  std::string_view mark;
  const char* name;
  const char* suffix;
};

constexpr ForeignKind kForeign[] = {{"\xABKTX 20\xBB", "KTX2", "ktx2"},
                                    {"\xABKTX 11\xBB", "KTX", "ktx"},
                                    {"sB", "Basis Universal", "basis"},
                                    {"DDS ", "DDS", "dds"},
                                    {"8BPS", "Photoshop", "psd"},
                                    {std::string_view("II*\0", 4), "TIFF", "tif"},
                                    {std::string_view("MM\0*", 4), "TIFF", "tif"},
                                    {"\x76\x2F\x31\x01", "OpenEXR", "exr"},
                                    {"#?RADIANCE", "Radiance HDR", "hdr"},
                                    {"GIF8", "GIF", "gif"}};

std::string command_for(const ForeignKind& kind) {
  const std::string_view suffix = kind.suffix;
  if (suffix == "ktx2")
    return "ktx extract hair.ktx2 hair.png (a .glb as a whole: npx @gltf-transform/cli ktxdecompress in.glb out.glb)";
  if (suffix == "ktx") return "ktx2ktx2 hair.ktx, then ktx extract hair.ktx2 hair.png";
  if (suffix == "basis") return "basisu -unpack hair.basis";
  return fmt::format("convert hair.{0} hair.png (ImageMagick)", suffix);
}

}  // namespace

std::string foreign_kind(std::span<const std::uint8_t> bytes) {
  for (const ForeignKind& kind : kForeign) {
    if (has_at(bytes, 0, kind.mark))
      return fmt::format("a {} image, which is not read; make a PNG of it: {}", kind.name, command_for(kind));
  }
  // For ISO media files the brand decides.
  if (has_at(bytes, 4, "ftypavif") || has_at(bytes, 4, "ftypheic")) {
    return fmt::format("a {0} image, which is not read; make a PNG of it: convert hair.{1} hair.png (ImageMagick)",
                       has_at(bytes, 8, "avif") ? "AVIF" : "HEIC", has_at(bytes, 8, "avif") ? "avif" : "heic");
  }
  return {};
}

bool is_webp(std::span<const std::uint8_t> bytes) { return has_at(bytes, 0, "RIFF") && has_at(bytes, 8, "WEBP"); }

tl::expected<Image, std::string> decode_webp(std::span<const std::uint8_t> bytes) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK) {
    return tl::unexpected(std::string("cannot read the image (damaged WebP); save it as PNG"));
  }
  if (features.has_animation != 0)
    return tl::unexpected(std::string("an animated WebP; save one of its pictures as PNG"));
  if (std::string fault = size_fault(features.width, features.height); !fault.empty())
    return tl::unexpected(std::move(fault));
  Image image{std::uint32_t(features.width), std::uint32_t(features.height), kRgbaChannels, {}};
  image.texels.resize(image.texel_count() * kRgbaChannels);
  const int stride = features.width * int(kRgbaChannels);
  if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), image.texels.data(), image.texels.size(), stride) == nullptr) {
    return tl::unexpected(std::string("cannot read the image (damaged WebP); save it as PNG"));
  }
  return image;
}

std::string size_fault(int width, int height) {
  const bool fits = width >= 1 && height >= 1 && std::max(width, height) <= int(kMaxImageSide) &&
                    std::uint64_t(width) * std::uint64_t(height) <= kMaxImageTexels;
  if (fits) return {};
  return fmt::format("{} x {} texels; an image has 1 to {} a side and at most {} million; reduce it", width, height,
                     kMaxImageSide, kMaxImageTexels / 1000000);
}

}  // namespace coif::cook
