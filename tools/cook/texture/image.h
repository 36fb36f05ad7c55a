#pragma once

#include <tl/expected.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::cook {

/// Eight bits a channel, rows top to bottom, channels interleaved.
struct Image {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t channels = 4;
  std::vector<std::uint8_t> texels;

  [[nodiscard]] std::size_t texel_count() const { return std::size_t(width) * height; }
};

/// Row or column of an image that repeats, at a coordinate where 1 is its size.
[[nodiscard]] inline std::size_t repeated(float coordinate, std::uint32_t size) {
  const float fraction = coordinate - std::floor(coordinate);
  return std::min(std::uint32_t(fraction * float(size)), size - 1);
}

inline constexpr std::uintmax_t kMaxImageBytes = std::uintmax_t{256} << 20;  ///< Encoded, of one file.
inline constexpr std::uint32_t kMaxImageSide = 16384;
inline constexpr std::uint64_t kMaxImageTexels = std::uint64_t{1} << 26;  ///< 8192 x 8192.

/// Decodes PNG, JPEG, TGA, BMP or WebP to RGBA. Bytes may be hostile: they are decoded in a process of their own under
/// limits (decode_texels() describes those inside). The error is a sentence without the file's name.
tl::expected<Image, std::string> decode_image(std::span<const std::uint8_t> bytes);
tl::expected<Image, std::string> read_image(const std::filesystem::path& path);

/// How an image's numbers are averaged.
enum class TexelMeaning {
  kSrgbColorAlpha,  ///< Four channels: colour is averaged as light, weighted by alpha.
  kNumbers,         ///< Any channels, averaged directly.
};

/// A smaller copy, box-filtered. The image repeats at its borders, as hair textures do.
[[nodiscard]] Image shrink(const Image& image, std::uint32_t width, std::uint32_t height, TexelMeaning meaning);

/// A larger copy, interpolated between texels; the image repeats at its borders. An image of that size is returned
/// unchanged.
[[nodiscard]] Image enlarge(Image image, std::uint32_t width, std::uint32_t height, TexelMeaning meaning);

/// The image, halved until no side is longer than `max_size`.
[[nodiscard]] Image reduce(Image image, std::uint32_t max_size, TexelMeaning meaning);

/// The image with a quarter of its rows: of textures whose strands run down the rows, which change across them.
[[nodiscard]] Image quarter_rows(const Image& image, TexelMeaning meaning);

/// Gives each channel of all smaller mips the standard deviation that it has in the largest, where `used` is not 0 (one
/// channel, the size of the largest); the mean stays. Averaged numbers of strands would differ the less the farther
/// away the hair is, but the few strands that are in front within a pixel do not.
void keep_spread(std::span<Image> mips, Image used);

/// The image and all its halvings down to one texel. An image larger than `max_size` is reduced first.
[[nodiscard]] std::vector<Image> make_mips(Image image, std::uint32_t max_size, TexelMeaning meaning);

/// The error of texels, of 255: numbers, or colour times alpha and alpha.
struct TexelError {
  double rms = 0, most = 0;
};

struct DetailedImage {
  Image image;
  TexelError error;  ///< Against the whole image.
};

/// An image at the lowest resolution that loses nothing; its sides are halved independently. Sampled between texels it
/// differs from the whole image by at most one level of 255 on average, and by a few anywhere. `used` (one channel, the
/// same size) marks the texels that count.
[[nodiscard]] DetailedImage reduce_to_detail(Image image, const Image& used, TexelMeaning meaning);

/// decode_image() in this process: a hostile image can only harm this process. Dimensions are read and checked first,
/// and no block of memory is larger than an image within the limits of image.h needs.
tl::expected<Image, std::string> decode_texels(std::span<const std::uint8_t> bytes);

/// "a KTX2 image, which is not read; make a PNG of it: ...", with the command; empty where the bytes are not of a known
/// kind that is not read.
[[nodiscard]] std::string foreign_kind(std::span<const std::uint8_t> bytes);

[[nodiscard]] bool is_webp(std::span<const std::uint8_t> bytes);

/// Runs in this process, as decode_texels(). Checks the size before it allocates.
tl::expected<Image, std::string> decode_webp(std::span<const std::uint8_t> bytes);

/// A sentence about a wrong size of an image; empty: none.
[[nodiscard]] std::string size_fault(int width, int height);

}  // namespace coif::cook
