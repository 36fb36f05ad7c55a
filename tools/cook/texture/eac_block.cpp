#include "cook/texture/eac_block.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace coif::cook {
namespace {

constexpr std::size_t kTexels = 16;
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

/// How the numbers of a code become values.
struct Scale {
  int unit;    ///< Value of one in the base, and in the multiplier.
  int offset;  ///< Added to the base.
  int zero;    ///< Value of the multiplier zero.
  int least;   ///< Multiplier.
  std::int16_t most;
};

/// A multiplier of zero stands for an eighth: flat blocks are stored to the last bit. Alphas have whole steps, and
/// encoders are asked not to use zero.
constexpr Scale scale_of(EacValues values) {
  return values == EacValues::kAlpha ? Scale{1, 0, 0, 1, 255} : Scale{8, 4, 1, 0, 2047};
}

struct Code {
  int base = 0;
  int multiplier = 0;
  int table = 0;
  int error = INT32_MAX;  ///< Sum of squares.
};

int step_of(const Code& code, const Scale& scale) {
  return code.multiplier == 0 ? scale.zero : code.multiplier * scale.unit;
}

Palette palette_of(const Code& code, const Scale& scale) {
  const auto step = std::int16_t(step_of(code, scale));
  const auto middle = std::int16_t(code.base * scale.unit + scale.offset);
  const Modifiers& modifiers = kTables[std::size_t(code.table)];
  Palette palette;
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const auto value = std::int16_t(middle + std::int16_t(modifiers[i] * step));
    palette[i] = std::min(std::max(value, std::int16_t{0}), scale.most);
  }
  return palette;
}

/// Half of a block, which GCC and Clang compute with at once.
using Texels = std::int16_t __attribute__((vector_size(16)));
constexpr std::size_t kTexelsAtOnce = 8;

int error_of(const EacBlock& block, const Palette& palette) {
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
void search_base(const EacBlock& block, const Scale& scale, int table, int multiplier, Code& best) {
  const auto [low, high] = std::ranges::minmax(kTables[std::size_t(table)]);
  Code here{0, multiplier, table, 0};
  const int middle = (block.low + block.high - step_of(here, scale) * (low + high)) / 2;
  here.base = std::clamp(middle / scale.unit, 0, 255);
  here.error = error_of(block, palette_of(here, scale));
  for (int stride = kWidestStride; stride > 0; stride /= 2) {
    const int centre = here.base;
    for (const int base : {centre - stride, centre + stride}) {
      Code code{std::clamp(base, 0, 255), multiplier, table, 0};
      code.error = error_of(block, palette_of(code, scale));
      if (code.error < here.error) here = code;
    }
  }
  if (here.error < best.error) best = here;
}

Code search(const EacBlock& block, const Scale& scale) {
  Code best;
  for (int table = 0; table < int(kTables.size()) && best.error > 0; ++table) {
    const auto [low, high] = std::ranges::minmax(kTables[std::size_t(table)]);
    // The multiplier that spans the block, and its neighbours: leaving an outlier out may serve the others better.
    const int unit = scale.unit * (high - low);
    const int span = (block.high - block.low + unit / 2) / unit;
    for (int multiplier = std::max(scale.least, span - 1); multiplier <= std::min(15, span + 1); ++multiplier) {
      search_base(block, scale, table, multiplier, best);
    }
  }
  return best;
}

/// A block of one alpha. The table has a modifier of zero, at index 4.
void write_flat(int alpha, std::uint8_t* out) {
  constexpr std::uint8_t kOneOfTable13 = 1 << 4 | 13, kIndices[3] = {0x92, 0x49, 0x24};  // 100 100 ...
  out[0] = std::uint8_t(alpha);
  out[1] = kOneOfTable13;
  for (std::size_t byte = 2; byte < kEacBlockBytes; ++byte) out[byte] = kIndices[(byte - 2) % 3];
}

void write(const EacBlock& block, const Code& code, const Scale& scale, std::uint8_t* out) {
  const Palette palette = palette_of(code, scale);
  std::uint64_t bits =
      std::uint64_t(code.base) << 56 | std::uint64_t(code.multiplier) << 52 | std::uint64_t(code.table) << 48;
  for (std::size_t i = 0; i < kTexels; ++i) {
    const auto nearer = [&](int a, int b) { return std::abs(a - block.value[i]) < std::abs(b - block.value[i]); };
    const auto index = std::uint64_t(std::ranges::min_element(palette, nearer) - palette.begin());
    bits |= index << (3 * (kTexels - 1 - i));
  }
  for (std::size_t byte = 0; byte < kEacBlockBytes; ++byte) out[byte] = std::uint8_t(bits >> (56 - 8 * byte));
}

}  // namespace

void encode_eac_block(const EacBlock& block, EacValues values, std::uint8_t* out) {
  if (values == EacValues::kAlpha && block.low == block.high) return write_flat(block.low, out);
  const Scale scale = scale_of(values);
  write(block, search(block, scale), scale, out);
}

}  // namespace coif::cook
