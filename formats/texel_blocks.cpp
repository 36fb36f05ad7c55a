#include <coif/texel_blocks.h>

namespace coif {
namespace {

int clamped(int value) { return value < 0 ? 0 : value > 255 ? 255 : value; }

struct Color {
  int channel[3];
};

Color moved(const Color& color, int by) {
  return {{clamped(color.channel[0] + by), clamped(color.channel[1] + by), clamped(color.channel[2] + by)}};
}

/// Expands `bits` of a channel to eight by repeating the highest.
int expanded(unsigned value, unsigned bits) { return int(value << (8 - bits) | value >> (2 * bits - 8)); }

/// The eight bytes of a block's colours, the first one highest.
class ColorBits {
 public:
  explicit ColorBits(const std::byte* bytes) {
    for (std::size_t i = 0; i < 8; ++i) bits_ = bits_ << 8 | std::uint64_t(bytes[i]);
  }

  /// The `count` bits from `lowest` on.
  [[nodiscard]] unsigned at(unsigned lowest, unsigned count) const {
    return unsigned(bits_ >> lowest) & ((1u << count) - 1);
  }
  /// The texel's two bits; texels are counted column by column.
  [[nodiscard]] unsigned index(std::uint32_t x, std::uint32_t y) const {
    const unsigned texel = x * kBlockSide + y;
    return at(16 + texel, 1) << 1 | at(texel, 1);
  }

 private:
  std::uint64_t bits_ = 0;
};

void write(std::byte* rgba, std::uint32_t x, std::uint32_t y, const Color& color) {
  std::byte* const texel = rgba + 4 * (y * kBlockSide + x);
  for (int k = 0; k < 3; ++k) texel[k] = std::byte(color.channel[k]);
}

constexpr int kSteps[8][2] = {{2, 8}, {5, 17}, {9, 29}, {13, 42}, {18, 60}, {24, 80}, {33, 106}, {47, 183}};
constexpr int kDistances[8] = {3, 6, 11, 16, 23, 32, 41, 64};

/// Two halves, each with a colour that its texels lighten or darken.
void decode_halves(const ColorBits& bits, const Color (&half)[2], std::byte* rgba) {
  const bool is_flipped = bits.at(32, 1) != 0;
  for (std::uint32_t x = 0; x < kBlockSide; ++x) {
    for (std::uint32_t y = 0; y < kBlockSide; ++y) {
      const std::uint32_t side = (is_flipped ? y : x) / 2;
      const unsigned index = bits.index(x, y);
      const int step = kSteps[bits.at(side == 0 ? 37 : 34, 3)][index & 1];
      write(rgba, x, y, moved(half[side], (index & 2) != 0 ? -step : step));
    }
  }
}

void decode_paints(const ColorBits& bits, const Color (&paint)[4], std::byte* rgba) {
  for (std::uint32_t x = 0; x < kBlockSide; ++x) {
    for (std::uint32_t y = 0; y < kBlockSide; ++y) write(rgba, x, y, paint[bits.index(x, y)]);
  }
}

Color of_four_bits(unsigned red, unsigned green, unsigned blue) {
  return {{expanded(red, 4), expanded(green, 4), expanded(blue, 4)}};
}

void decode_t(const ColorBits& bits, std::byte* rgba) {
  const Color first = of_four_bits(bits.at(59, 2) << 2 | bits.at(56, 2), bits.at(52, 4), bits.at(48, 4));
  const Color second = of_four_bits(bits.at(44, 4), bits.at(40, 4), bits.at(36, 4));
  const int distance = kDistances[bits.at(34, 2) << 1 | bits.at(32, 1)];
  decode_paints(bits, {first, moved(second, distance), second, moved(second, -distance)}, rgba);
}

void decode_h(const ColorBits& bits, std::byte* rgba) {
  const unsigned first[3] = {bits.at(59, 4), bits.at(56, 3) << 1 | bits.at(52, 1),
                             bits.at(51, 1) << 3 | bits.at(47, 3)};
  const unsigned second[3] = {bits.at(43, 4), bits.at(39, 4), bits.at(35, 4)};
  const auto order = [](const unsigned(&c)[3]) { return c[0] << 8 | c[1] << 4 | c[2]; };
  const unsigned last = order(first) >= order(second) ? 1 : 0;
  const int distance = kDistances[bits.at(34, 1) << 2 | bits.at(32, 1) << 1 | last];
  const Color a = of_four_bits(first[0], first[1], first[2]), b = of_four_bits(second[0], second[1], second[2]);
  decode_paints(bits, {moved(a, distance), moved(a, -distance), moved(b, distance), moved(b, -distance)}, rgba);
}

/// Colours at three corners, and a plane through them.
void decode_plane(const ColorBits& bits, std::byte* rgba) {
  const int origin[3] = {expanded(bits.at(57, 6), 6), expanded(bits.at(56, 1) << 6 | bits.at(49, 6), 7),
                         expanded(bits.at(48, 1) << 5 | bits.at(43, 2) << 3 | bits.at(39, 3), 6)};
  const int right[3] = {expanded(bits.at(34, 5) << 1 | bits.at(32, 1), 6), expanded(bits.at(25, 7), 7),
                        expanded(bits.at(19, 6), 6)};
  const int below[3] = {expanded(bits.at(13, 6), 6), expanded(bits.at(6, 7), 7), expanded(bits.at(0, 6), 6)};
  for (int x = 0; x < int(kBlockSide); ++x) {
    for (int y = 0; y < int(kBlockSide); ++y) {
      Color color;
      for (int k = 0; k < 3; ++k) {
        const int sum = x * (right[k] - origin[k]) + y * (below[k] - origin[k]) + 4 * origin[k] + 2;
        color.channel[k] = clamped(sum >> 2);
      }
      write(rgba, std::uint32_t(x), std::uint32_t(y), color);
    }
  }
}

/// Values of three bits with a sign.
int signed_three(unsigned value) { return int(value) - (value >= 4 ? 8 : 0); }

void decode_color(const std::byte* block, std::byte* rgba) {
  const ColorBits bits(block);
  Color half[2];
  if (bits.at(33, 1) == 0) {
    for (unsigned k = 0; k < 3; ++k) {
      half[0].channel[k] = expanded(bits.at(60 - 8 * k, 4), 4);
      half[1].channel[k] = expanded(bits.at(56 - 8 * k, 4), 4);
    }
    return decode_halves(bits, half, rgba);
  }
  // A second colour that is out of range stands for one of the other modes.
  constexpr void (*kModes[3])(const ColorBits&, std::byte*) = {decode_t, decode_h, decode_plane};
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned first = bits.at(59 - 8 * k, 5);
    const int second = int(first) + signed_three(bits.at(56 - 8 * k, 3));
    if (second < 0 || second > 31) return kModes[k](bits, rgba);
    half[0].channel[k] = expanded(first, 5);
    half[1].channel[k] = expanded(unsigned(second), 5);
  }
  decode_halves(bits, half, rgba);
}

/// Distances from a block's base. The second four of a row are the mirror of the first four, less one.
constexpr int kModifiers[16][4] = {{-3, -6, -9, -15}, {-3, -7, -10, -13}, {-2, -5, -8, -13}, {-2, -4, -6, -13},
                                   {-3, -6, -8, -12}, {-3, -7, -9, -11},  {-4, -7, -8, -11}, {-3, -5, -8, -11},
                                   {-2, -6, -8, -10}, {-2, -5, -8, -10},  {-2, -4, -8, -10}, {-2, -5, -7, -10},
                                   {-3, -4, -7, -10}, {-1, -2, -3, -10},  {-4, -6, -8, -9},  {-3, -5, -7, -9}};

void decode_alpha(const std::byte* block, std::byte* rgba) {
  const ColorBits bits(block);
  const int base = int(bits.at(56, 8)), multiplier = int(bits.at(52, 4));
  const int(&row)[4] = kModifiers[bits.at(48, 4)];
  for (unsigned texel = 0; texel < kBlockTexels; ++texel) {
    const unsigned index = bits.at(3 * (unsigned(kBlockTexels) - 1 - texel), 3);
    const int modifier = index < 4 ? row[index] : -row[index & 3] - 1;
    const unsigned x = texel / kBlockSide, y = texel % kBlockSide;
    rgba[4 * (y * kBlockSide + x) + 3] = std::byte(clamped(base + modifier * multiplier));
  }
}

}  // namespace

void decode_color_block(const std::byte* block, std::byte* rgba) {
  decode_alpha(block, rgba);
  decode_color(block + 8, rgba);
}

}  // namespace coif
