#include "base/linear_picture.h"

#include <tinyexr.h>

#include <array>
#include <cstdlib>
#include <memory>

namespace coif {
namespace {

constexpr int kMostPixels = 8192;  ///< Each way.

struct FreeBlock {
  void operator()(void* block) const { std::free(block); }
};

/// What the library says, which is then freed.
std::string taken(const char* error) {
  std::string text = error != nullptr ? error : "it cannot be understood";
  if (error != nullptr) FreeEXRErrorMessage(error);
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  return text;
}

/// Width and height, before memory is taken for them.
tl::expected<std::array<int, 2>, std::string> extent_of(const unsigned char* bytes, std::size_t size) {
  EXRVersion version;
  if (ParseEXRVersionFromMemory(&version, bytes, size) != TINYEXR_SUCCESS)
    return tl::unexpected(std::string("it is no OpenEXR"));
  if (version.multipart != 0 || version.non_image != 0) return tl::unexpected(std::string("it has more than one part"));
  EXRHeader header;
  InitEXRHeader(&header);
  const char* error = nullptr;
  if (ParseEXRHeaderFromMemory(&header, &version, bytes, size, &error) != TINYEXR_SUCCESS) {
    return tl::unexpected(taken(error));
  }
  const auto& window = header.data_window;
  const std::array<int, 2> extent{window.max_x - window.min_x + 1, window.max_y - window.min_y + 1};
  FreeEXRHeader(&header);
  for (const int side : extent) {
    if (side < 1 || side > kMostPixels) {
      return tl::unexpected(std::string("it has more than 8192 pixels each way, or none"));
    }
  }
  return extent;
}

}  // namespace

tl::expected<std::vector<std::byte>, std::string> encode_exr(const LinearPicture& picture) {
  constexpr std::array kNames{"A", "B", "G", "R"};  // in the order of the alphabet, as the format wants them
  constexpr int kChannels = int(kNames.size());
  const std::size_t pixels = std::size_t{picture.width} * picture.height;
  std::array<std::vector<float>, kNames.size()> planes;
  std::array<unsigned char*, kNames.size()> images{};
  std::array<EXRChannelInfo, kNames.size()> infos{};
  std::array<int, kNames.size()> floats, halves;
  for (std::size_t c = 0; c < kNames.size(); ++c) {
    for (std::size_t i = 0; i < pixels; ++i) planes[c].push_back(picture.rgba[4 * i + 3 - c]);
    images[c] = reinterpret_cast<unsigned char*>(planes[c].data());
    infos[c].name[0] = kNames[c][0];
    floats[c] = TINYEXR_PIXELTYPE_FLOAT;
    halves[c] = TINYEXR_PIXELTYPE_HALF;
  }
  EXRHeader header;
  InitEXRHeader(&header);
  header.num_channels = kChannels;
  header.channels = infos.data();
  header.pixel_types = floats.data();
  header.requested_pixel_types = halves.data();
  header.compression_type = TINYEXR_COMPRESSIONTYPE_ZIP;
  EXRImage image;
  InitEXRImage(&image);
  image.num_channels = kChannels;
  image.images = images.data();
  image.width = int(picture.width);
  image.height = int(picture.height);
  unsigned char* memory = nullptr;
  const char* error = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&image, &header, &memory, &error);
  const std::unique_ptr<unsigned char, FreeBlock> owned(memory);
  if (size == 0) return tl::unexpected(taken(error));
  const auto* const begin = reinterpret_cast<const std::byte*>(memory);
  return std::vector<std::byte>(begin, begin + size);
}

tl::expected<LinearPicture, std::string> decode_exr(std::span<const std::byte> bytes) {
  const auto* const begin = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto extent = extent_of(begin, bytes.size());
  if (!extent) return tl::unexpected(extent.error());
  float* rgba = nullptr;
  int width = 0, height = 0;
  const char* error = nullptr;
  if (LoadEXRFromMemory(&rgba, &width, &height, begin, bytes.size(), &error) != TINYEXR_SUCCESS) {
    return tl::unexpected(taken(error));
  }
  const std::unique_ptr<float, FreeBlock> owned(rgba);
  return LinearPicture{std::uint32_t(width), std::uint32_t(height),
                       std::vector<float>(rgba, rgba + std::size_t{4} * std::size_t(width) * std::size_t(height))};
}

LinearPicture reduced(const LinearPicture& picture, std::uint32_t factor) {
  LinearPicture small{picture.width / factor, picture.height / factor, {}};
  small.rgba.resize(std::size_t{4} * small.width * small.height);
  const float share = 1 / float(factor * factor);
  for (std::size_t y = 0; y < std::size_t{small.height} * factor; ++y) {
    for (std::size_t x = 0; x < std::size_t{small.width} * factor; ++x) {
      for (std::size_t k = 0; k < 4; ++k) {
        small.rgba[4 * (y / factor * small.width + x / factor) + k] +=
            share * picture.rgba[4 * (y * picture.width + x) + k];
      }
    }
  }
  return small;
}

}  // namespace coif
