#include "cook/texture/relief.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

namespace coif::cook {
namespace {

constexpr std::uint32_t kSide = 4;
constexpr std::size_t kTexels = kSide * kSide;
constexpr std::size_t kChannelBytes = 8;
constexpr std::int16_t kMaxValue = 2047;
constexpr int kWidestStride = 8;

using Modifiers = std::array<std::int16_t, 8>;

constexpr std::array<Modifiers, 16> kTables = {{
    {-3, -6, -9, -15, 2, 5, 8, 14},
    {-3, -7, -10, -13, 2, 6, 9, 12},
    {-2, -5, -8, -13, 1, 4, 7, 12},
    {-2, -4, -6, -13, 1, 3, 5, 12},
    {-3, -6, -8, -12, 2, 5, 7, 11},
    {-3, -7, -9, -11, 2, 6, 8, 10},
    {-4, -7, -8, -11, 3, 6, 7, 10},
    {-3, -5, -8, -11, 2, 4, 7, 10},
    {-2, -6, -8, -10, 1, 5, 7, 9},
    {-2, -5, -8, -10, 1, 4, 7, 9},
    {-2, -4, -8, -10, 1, 3, 7, 9},
    {-2, -5, -7, -10, 1, 4, 6, 9},
    {-3, -4, -7, -10, 2, 3, 6, 9},
    {-1, -2, -3, -10, 0, 1, 2, 9},
    {-4, -6, -8, -9, 3, 5, 7, 8},
    {-3, -5, -7, -9, 2, 4, 6, 8},
}};

using Palette = std::array<std::int16_t, 8>;

/// One channel of one block, 0..2047. Texels outside the image repeat one inside, which adds no value to cover.
struct Block {
  std::array<std::int16_t, kTexels> value;  ///< Column by column, as the format counts.
  int low = kMaxValue;
  int high = 0;
};

struct Code {
  int base = 0;
  int multiplier = 0;
  int table = 0;
  int error = INT32_MAX;  ///< Sum of squares.
};

Palette palette_of(const Code& code) {
  // A multiplier of zero stands for an eighth: flat blocks are stored to the last bit.
  const auto step = std::int16_t(code.multiplier == 0 ? 1 : code.multiplier * 8);
  const auto middle = std::int16_t(code.base * 8 + 4);
  const Modifiers& modifiers = kTables[std::size_t(code.table)];
  Palette palette;
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const auto value = std::int16_t(middle + std::int16_t(modifiers[i] * step));
    palette[i] = std::min(std::max(value, std::int16_t{0}), kMaxValue);
  }
  return palette;
}

/// Half of a block, which GCC and Clang compute with at once.
using Texels = std::int16_t __attribute__((vector_size(16)));
constexpr std::size_t kTexelsAtOnce = 8;

int error_of(const Block& block, const Palette& palette) {
  int sum = 0;
  for (std::size_t begin = 0; begin < kTexels; begin += kTexelsAtOnce) {
    Texels value;
    std::memcpy(&value, &block.value[begin], sizeof value);
    Texels nearest = Texels{} + std::int16_t{INT16_MAX};
    for (const std::int16_t entry : palette) {
      const Texels above = value - entry, below = entry - value;
      const Texels distance = above > below ? above : below;
      nearest = distance < nearest ? distance : nearest;
    }
    for (std::size_t i = 0; i < kTexelsAtOnce; ++i) sum += int(nearest[i]) * int(nearest[i]);
  }
  return sum;
}

/// Searches the base from the one that puts the middle of the palette on the middle of the block, in halving strides:
/// a full search gains 0.2 dB and takes thirty times as long.
void search_base(const Block& block, int table, int multiplier, Code& best) {
  const auto [low, high] = std::ranges::minmax(kTables[std::size_t(table)]);
  const int step = multiplier == 0 ? 1 : multiplier * 8;
  const int middle = (block.low + block.high - step * (low + high)) / 2;
  Code here{std::clamp(middle / 8, 0, 255), multiplier, table, 0};
  here.error = error_of(block, palette_of(here));
  for (int stride = kWidestStride; stride > 0; stride /= 2) {
    const int centre = here.base;
    for (const int base : {centre - stride, centre + stride}) {
      Code code{std::clamp(base, 0, 255), multiplier, table, 0};
      code.error = error_of(block, palette_of(code));
      if (code.error < here.error) here = code;
    }
  }
  if (here.error < best.error) best = here;
}

Code search(const Block& block) {
  Code best;
  for (int table = 0; table < int(kTables.size()) && best.error > 0; ++table) {
    const auto [low, high] = std::ranges::minmax(kTables[std::size_t(table)]);
    // The multiplier that spans the block, and its neighbours: leaving an outlier out may serve the others better.
    const int span = (block.high - block.low + 4 * (high - low)) / (8 * (high - low));
    for (int multiplier = std::max(0, span - 1); multiplier <= std::min(15, span + 1); ++multiplier) {
      search_base(block, table, multiplier, best);
    }
  }
  return best;
}

void write(const Block& block, const Code& code, std::uint8_t* out) {
  const Palette palette = palette_of(code);
  std::uint64_t bits =
      std::uint64_t(code.base) << 56 | std::uint64_t(code.multiplier) << 52 | std::uint64_t(code.table) << 48;
  for (std::size_t i = 0; i < kTexels; ++i) {
    const auto nearer = [&](int a, int b) { return std::abs(a - block.value[i]) < std::abs(b - block.value[i]); };
    const auto index = std::uint64_t(std::ranges::min_element(palette, nearer) - palette.begin());
    bits |= index << (3 * (kTexels - 1 - i));
  }
  for (std::size_t byte = 0; byte < kChannelBytes; ++byte) out[byte] = std::uint8_t(bits >> (56 - 8 * byte));
}

Block read_block(const Image& image, std::uint32_t left, std::uint32_t top, std::uint32_t channel) {
  Block block;
  for (std::uint32_t column = 0; column < kSide; ++column) {
    for (std::uint32_t row = 0; row < kSide; ++row) {
      const std::size_t x = std::min(left + column, image.width - 1), y = std::min(top + row, image.height - 1);
      const int value = (image.texels[(y * image.width + x) * image.channels + channel] * kMaxValue + 127) / 255;
      block.value[column * kSide + row] = std::int16_t(value);
      block.low = std::min(block.low, value);
      block.high = std::max(block.high, value);
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
  std::vector<std::uint8_t> bytes(std::size_t(columns) * rows * 2 * kChannelBytes);
  parallel_for(rows, threads, [&](std::size_t row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      for (std::uint32_t channel = 0; channel < 2; ++channel) {
        const Block block = read_block(image, column * kSide, std::uint32_t(row) * kSide, channel);
        write(block, search(block), &bytes[((row * columns + column) * 2 + channel) * kChannelBytes]);
      }
    }
  });
  return bytes;
}

}  // namespace coif::cook
