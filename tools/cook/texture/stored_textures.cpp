#include "base/parallel_for.h"
#include "cook/texture/eac_block.h"
#include "cook/texture/relief.h"

#include <algorithm>

namespace coif::cook {
namespace {

constexpr std::uint32_t kSide = 4;
constexpr int kMaxValue = 2047;

EacBlock read_block(const Image& image, std::uint32_t left, std::uint32_t top, std::uint32_t channel) {
  EacBlock block;
  for (std::uint32_t column = 0; column < kSide; ++column) {
    for (std::uint32_t row = 0; row < kSide; ++row) {
      const std::size_t x = std::min(left + column, image.width - 1), y = std::min(top + row, image.height - 1);
      const int value = (image.texels[(y * image.width + x) * image.channels + channel] * kMaxValue + 127) / 255;
      block.set(column * kSide + row, value);
    }
  }
  return block;
}

}  // namespace

std::uint64_t bytes_with_mips(TexelFormat format, const Image& image) {
  std::uint64_t bytes = 0;
  for (std::uint32_t mip = 0; std::max(image.width, image.height) >> mip > 0; ++mip) {
    bytes += mip_bytes(format, image.width, image.height, mip);
  }
  return bytes;
}

void StoredTextures::append(TextureRole role, TexelFormat format, std::span<const Image> mips,
                            const platform::Threads& threads) {
  texels.resize((texels.size() + 63) / 64 * 64);
  TextureRecord record{};
  record.role = role;
  record.format = format;
  record.width = mips[0].width;
  record.height = mips[0].height;
  record.mip_count = std::uint32_t(mips.size());
  record.offset = texels.size();
  for (const Image& mip : mips) {
    const auto encoded = format == TexelFormat::kRg11Eac ? encode_eac_rg11(mip, threads) : mip.texels;
    const auto bytes = std::as_bytes(std::span(encoded));
    texels.insert(texels.end(), bytes.begin(), bytes.end());
  }
  record.bytes = texels.size() - record.offset;
  records.push_back(record);
}

std::vector<std::uint8_t> encode_eac_rg11(const Image& image, const platform::Threads& threads) {
  const std::uint32_t columns = (image.width + kSide - 1) / kSide, rows = (image.height + kSide - 1) / kSide;
  std::vector<std::uint8_t> bytes(std::size_t(columns) * rows * 2 * kEacBlockBytes);
  parallel_for(rows, threads, [&](std::size_t row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      for (std::uint32_t channel = 0; channel < 2; ++channel) {
        const EacBlock block = read_block(image, column * kSide, std::uint32_t(row) * kSide, channel);
        encode_eac_block(block, EacValues::kElevenBits,
                         &bytes[((row * columns + column) * 2 + channel) * kEacBlockBytes]);
      }
    }
  });
  return bytes;
}

}  // namespace coif::cook
